// Words that readers stop at, counted in prose: comments, documents, and strings that are printed.
//
// Prose comes in blocks: the lines of one comment, a paragraph, a string literal. Each is read as
// words in lower case: letters, digits, '_', '\'' and '-' belong to a word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::layout {

struct Prose {
    std::vector<std::string> comments;
    std::vector<std::string> strings;  // literals of more than one word
};
Prose prose_of_code(std::string_view text);

// Paragraphs without fenced blocks, code spans and addresses.
std::vector<std::string> prose_of_document(std::string_view text);

// Phrases are words between single spaces; "^word" is the first word of a block
// that does not begin with a space, "word*" every
// word that begins so.
struct Term {
    std::string name;
    std::vector<std::string> phrases;
    std::vector<std::string> allowed;  // an occurrence inside one of these does not count
};
size_t occurrences(const Term& term, std::string_view block);

}  // namespace wrinkle::layout
