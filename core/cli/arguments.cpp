#include "cli/arguments.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <span>
#include <vector>

#include "base/file.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> opened;

constexpr size_t max_depth = 16, max_files = 1000;
constexpr uint64_t max_bytes = uint64_t{16} << 20;
constexpr std::string_view blanks = " \t\r\n\f\v";

// Compiler-style flags; CLI11 does not support long names after a single dash.
constexpr std::pair<std::string_view, const char*> compiler_flags[] = {{"-MD", "--depfile"},
                                                                       {"-MF", "--depfile-path"},
                                                                       {"-MT", "--depfile-target"},
                                                                       {"-MP", "--depfile-phony"}};

bool is_blank(char c) {
    return blanks.find(c) != blanks.npos;
}

// Reads one word from `at` and advances `at` past it; returns false if a quote is not closed.
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

bool is_file_name(const std::string& word) {
    std::error_code ignored;
    return word.size() > 1 && (word[0] == '@' || word[0] == '-') && word != "--" &&
           fs::exists(fs::symlink_status(word, ignored));
}

std::string renamed(std::string word) {
    for (const auto& [flag, name] : compiler_flags)
        if (word == flag) return name;
    return word;
}

// Expands the words of the command line and of the @FILEs that it names.
class Expansion {
public:
    explicit Expansion(std::string& why) : why_(why) {}

    // Recursion is limited to max_depth files.
    bool add(std::span<const std::string> from) {
        for (const std::string& word : from) {
            plain_ = plain_ || word == "--";
            if (!plain_ && is_file_name(word)) return refuse(word);
            const bool is_points = !words.empty() && words.back() == "--at";
            if (plain_ || is_points || word.size() < 2 || word[0] != '@')
                words.push_back(renamed(word));
            else if (!add_file(word.substr(1)))
                return false;
        }
        return true;
    }

    std::vector<std::string> words;

private:
    bool add_file(const std::string& file) {
        const fs::path path = real_path(file);
        if (std::ranges::find(open_, path) != open_.end())
            return fail(file, "names itself, or a file that names it");
        if (open_.size() == max_depth)
            return fail(file, "is more than " + std::to_string(max_depth) + " files deep");
        if (++files_ > max_files)
            return fail(file, "is one of more than " + std::to_string(max_files) + " files");
        std::string why;
        const auto text = read_file(path, why);
        opened.push_back(file);
        if (!text) return fail(file, why);
        bytes_ += text->size();
        if (bytes_ > max_bytes) return fail(file, "these words are of more than 16 MB");
        std::vector<std::string> held;
        if (!split_words(*text, held)) return fail(file, "a quote is not closed");
        open_.push_back(path);
        const bool added = add(held);
        open_.pop_back();
        return added;
    }

    bool refuse(const std::string& word) {
        why_ = "'" + word + "' is the name of a file here; ./" + word + " or -- " + word +
               " names that file";
        if (word[0] == '@')
            why_ += ", @./" + word.substr(1) + " takes the words of " + word.substr(1);
        return false;
    }

    bool fail(const std::string& file, const std::string& why) {
        why_ = file + ": " + why;
        return false;
    }

    std::string& why_;
    std::vector<fs::path> open_;  // files being read, outermost first
    size_t files_ = 0;
    uint64_t bytes_ = 0;
    bool plain_ = false;  // after "--"
};

}  // namespace

std::optional<std::vector<std::string>> command_words(int argc, const char* const* argv,
                                                      std::string& why) {
    opened.clear();
    Expansion expansion(why);
    if (!expansion.add(std::vector<std::string>(argv + 1, argv + argc))) return {};
    return std::move(expansion.words);
}

std::vector<std::string> inputs_of_run(std::vector<std::string> inputs) {
    inputs.insert(inputs.end(), opened.begin(), opened.end());
    return inputs;
}

std::string overwrite_fault_of_run(std::span<const std::string> outputs,
                                   std::vector<std::string> inputs) {
    return overwrite_fault(outputs, inputs_of_run(std::move(inputs)));
}

std::string shell_quoted(const std::string& word) {
    const bool plain = !word.empty() && std::ranges::all_of(word, [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || std::strchr("/._-+,:@%", c);
    });
    if (plain) return word;
    std::string quoted = "'";
    for (const char c : word)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

}  // namespace wrinkle::cli
