#include "editor/view/panels/search.h"

#include <cctype>
#include <numeric>

namespace wrinkle::editor {
namespace {

constexpr size_t shortest_for_doc = 3;

bool is_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80;
}

// Returns the position of a word other than the first that begins with the query; npos if none.
size_t find_word(std::string_view text, std::string_view query) {
    for (size_t at = text.find(query, 1); at != text.npos; at = text.find(query, at + 1))
        if (!is_letter(text[at - 1])) return at;
    return text.npos;
}

std::vector<size_t> run_of(size_t at, size_t length) {
    std::vector<size_t> letters(length);
    std::iota(letters.begin(), letters.end(), at);
    return letters;
}

std::optional<Match> in_order(std::string_view title, std::string_view query) {
    Match found{7, {}};
    for (size_t i = 0; i < title.size() && found.letters.size() < query.size(); ++i)
        if (title[i] == query[found.letters.size()]) found.letters.push_back(i);
    if (found.letters.size() < query.size()) return std::nullopt;
    return found;
}

}  // namespace

std::optional<Match> match(std::string_view title, std::string_view id, std::string_view doc,
                           std::string_view query) {
    if (query.empty()) return Match{};
    const std::string name = lower_case(title), key = lower_case(id);
    const size_t in_name = name.find(query), in_key = key.find(query);
    const auto found = [&](int rank, size_t at) { return Match{rank, run_of(at, query.size())}; };
    if (name == query) return found(0, 0);
    if (key == query) return Match{0, {}};
    if (in_name == 0) return found(1, 0);
    if (in_key == 0) return Match{2, {}};
    if (in_name != name.npos) {
        const size_t word = find_word(name, query);
        if (word != name.npos) return found(3, word);
    }
    if (in_key != key.npos && find_word(key, query) != key.npos) return Match{4, {}};
    if (in_name != name.npos) return found(5, in_name);
    if (in_key != key.npos) return Match{6, {}};
    if (const auto letters = in_order(name, query)) return letters;
    const std::string line = query.size() < shortest_for_doc ? "" : lower_case(doc);
    if (line.starts_with(query) || (!line.empty() && find_word(line, query) != line.npos))
        return Match{8, {}};
    return std::nullopt;
}

}  // namespace wrinkle::editor
