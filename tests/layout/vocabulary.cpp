#include "layout/vocabulary.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <sstream>

namespace wrinkle::layout {
namespace {

bool is_word_character(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '\'' || c == '-' ||
           static_cast<unsigned char>(c) >= 0x80;
}

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    const auto end_word = [&] {
        if (!word.empty()) words.push_back(std::move(word));
        word.clear();
    };
    for (const char c : text)
        if (is_word_character(c))
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else
            end_word();
    end_word();
    return words;
}

bool matches_at(const std::vector<std::string>& words, size_t at,
                const std::vector<std::string>& phrase) {
    if (at + phrase.size() > words.size()) return false;
    return std::equal(phrase.begin(), phrase.end(), words.begin() + static_cast<std::ptrdiff_t>(at),
                      [](std::string_view wanted, std::string_view word) {
                          if (!wanted.ends_with('*')) return wanted == word;
                          return word.starts_with(wanted.substr(0, wanted.size() - 1));
                      });
}

std::vector<std::string> split(const std::string& phrase) {
    std::istringstream stream(phrase);
    return {std::istream_iterator<std::string>(stream), {}};
}

// Marks the words that belong to one of the phrases.
std::vector<bool> covered(const std::vector<std::string>& words,
                          const std::vector<std::string>& phrases) {
    std::vector<bool> result(words.size(), false);
    for (const std::string& text : phrases) {
        const std::vector<std::string> phrase = split(text);
        for (size_t at = 0; at < words.size(); ++at)
            if (matches_at(words, at, phrase))
                std::fill_n(result.begin() + static_cast<std::ptrdiff_t>(at), phrase.size(), true);
    }
    return result;
}

// Reads C++ from one comment or literal to the next.
class CodeReader {
public:
    explicit CodeReader(std::string_view text) : text_(text) {}

    Prose read() {
        while (at_ < text_.size()) {
            if (starts("//"))
                line_comment();
            else if (starts("R\"") && (at_ == 0 || !is_word_character(text_[at_ - 1])))
                raw_string();
            else if (text_[at_] == '"')
                literal();
            else if (text_[at_] == '\'')
                character();
            else
                ++at_;
        }
        return std::move(prose_);
    }

private:
    bool starts(std::string_view with) const { return text_.substr(at_).starts_with(with); }

    // Comments on successive lines that hold nothing else are one block.
    void line_comment() {
        const size_t line = text_.rfind('\n', at_) + 1;
        const bool alone = text_.substr(line, at_ - line).find_first_not_of(" \t") == text_.npos;
        const size_t end = std::min(text_.find('\n', at_), text_.size());
        const std::string_view words = text_.substr(at_ + 2, end - at_ - 2);
        if (alone && line == next_line_ && !prose_.comments.empty() &&
            words.find_first_not_of(' ') != words.npos)
            prose_.comments.back().append(" ").append(words);
        else
            prose_.comments.emplace_back(words);
        next_line_ = alone ? end + 1 : text_.npos;
        at_ = end;
    }

    void raw_string() {
        const size_t open = text_.find('(', at_);
        const std::string close = ")" + std::string(text_.substr(at_ + 2, open - at_ - 2)) + "\"";
        const size_t end = std::min(text_.find(close, open), text_.size());
        keep(text_.substr(open + 1, end - open - 1));
        at_ = std::min(end + close.size(), text_.size());
    }

    void literal() {
        std::string value;
        for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
            if (text_[at_] == '\\') ++at_;
            value += at_ < text_.size() ? text_[at_] : ' ';
        }
        ++at_;
        keep(value);
    }

    // A digit's separator (10'000) begins no character.
    void character() {
        if (at_ > 0 && std::isalnum(static_cast<unsigned char>(text_[at_ - 1]))) {
            ++at_;
            return;
        }
        at_ += at_ + 1 < text_.size() && text_[at_ + 1] == '\\' ? 2 : 1;
        at_ = std::min(text_.find('\'', at_ + 1), text_.size() - 1) + 1;
    }

    void keep(std::string_view value) {
        if (words_of(value).size() > 1) prose_.strings.emplace_back(value);
    }

    std::string_view text_;
    size_t at_ = 0;
    size_t next_line_ = std::string_view::npos;  // begin of the line that would continue a comment
    Prose prose_;
};

// Without code spans and addresses.
std::string plain(std::string_view line) {
    std::string result;
    bool code = false;
    for (size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '`') {
            code = !code;
            result += ' ';
        } else if (line.substr(i).starts_with("](")) {
            i = std::min(line.find(')', i), line.size() - 1);
            result += ' ';
        } else if (line.substr(i).starts_with("http")) {
            i = std::min(line.find_first_of(" )>", i), line.size() - 1);
            result += ' ';
        } else if (!code) {
            result += line[i];
        }
    }
    return result;
}

}  // namespace

Prose prose_of_code(std::string_view text) {
    return CodeReader(text).read();
}

std::vector<std::string> prose_of_document(std::string_view text) {
    std::vector<std::string> blocks;
    bool fenced = false, begins = true;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        const size_t start = std::min(line.find_first_not_of(' '), line.size());
        const std::string_view rest = std::string_view(line).substr(start);
        if (rest.starts_with("```")) fenced = !fenced;
        const bool item = rest.starts_with("* ") || rest.starts_with("- ") || rest.starts_with('|');
        if (fenced || rest.empty() || rest.starts_with("```")) {
            begins = true;
            continue;
        }
        if (begins || item || rest.starts_with('#')) blocks.emplace_back();
        blocks.back().append(plain(rest)).append(" ");
        begins = rest.starts_with('#');
    }
    return blocks;
}

size_t occurrences(const Term& term, std::string_view block) {
    const std::vector<std::string> words = words_of(block);
    const std::vector<bool> allowed = covered(words, term.allowed);
    size_t count = 0;
    for (const std::string& text : term.phrases) {
        const bool first = text.starts_with('^');
        if (first && block.starts_with(' ')) continue;  // a string that continues another
        const std::vector<std::string> phrase = split(first ? text.substr(1) : text);
        for (size_t at = 0; at < (first ? std::min<size_t>(words.size(), 1) : words.size()); ++at)
            if (!allowed[at] && matches_at(words, at, phrase)) ++count;
    }
    return count;
}

}  // namespace wrinkle::layout
