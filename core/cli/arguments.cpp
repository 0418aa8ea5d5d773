#include "cli/arguments.h"

#include <algorithm>
#include <deque>

#include "base/file.h"

namespace wrinkle::cli {
namespace {

constexpr size_t most_files = 1000;  // one that names itself goes beyond any number
constexpr std::string_view blanks = " \t\r\n\f\v";

// CLI11 has no long names behind a single dash, as compilers spell these.
constexpr std::pair<std::string_view, const char*> compiler_flags[] = {{"-MD", "--depfile"},
                                                                       {"-MF", "--depfile-path"},
                                                                       {"-MT", "--depfile-target"},
                                                                       {"-MP", "--depfile-phony"}};

bool is_blank(char c) {
    return blanks.find(c) != blanks.npos;
}

// One word of `text` from `at` on, which is left behind it; false where a quote stays open.
bool take_word(std::string_view text, size_t& at, std::string& word) {
    char quote = 0;
    for (; at < text.size() && (quote || !is_blank(text[at])); ++at) {
        const char c = text[at];
        if (c == '\\' && quote != '\'' && at + 1 < text.size())
            word += text[++at];
        else if (quote ? c == quote : c == '"' || c == '\'')
            quote = quote ? 0 : c;
        else
            word += c;
    }
    return quote == 0;
}

bool split_words(std::string_view text, std::vector<std::string>& words) {
    for (size_t at = text.find_first_not_of(blanks); at < text.size();
         at = text.find_first_not_of(blanks, at)) {
        std::string word;
        if (!take_word(text, at, word)) return false;
        words.push_back(std::move(word));
    }
    return true;
}

std::string renamed(std::string word) {
    for (const auto& [flag, name] : compiler_flags)
        if (word == flag) return name;
    return word;
}

// Puts what the file holds in front of what is left.
bool open_file(const std::string& file, std::deque<std::string>& left, std::string& why) {
    std::vector<std::string> words;
    const auto text = read_file(file, why);
    if (text && split_words(*text, words)) {
        left.insert(left.begin(), words.begin(), words.end());
        return true;
    }
    why = file + ": " + (text ? "a quote is not closed" : why);
    return false;
}

}  // namespace

std::optional<std::vector<std::string>> command_words(int argc, const char* const* argv,
                                                      std::string& why) {
    std::deque<std::string> left(argv + 1, argv + argc);
    std::vector<std::string> words;
    size_t files = 0;
    bool plain = false;
    while (!left.empty()) {
        const std::string word = std::move(left.front());
        left.pop_front();
        plain = plain || word == "--";
        const bool is_points = !words.empty() && words.back() == "--at";
        if (plain || is_points || word.size() < 2 || word[0] != '@') {
            words.push_back(renamed(word));
        } else if (++files > most_files) {
            why = word.substr(1) + ": names itself, or a file that names it";
            return {};
        } else if (!open_file(word.substr(1), left, why)) {
            return {};
        }
    }
    return words;
}

}  // namespace wrinkle::cli
