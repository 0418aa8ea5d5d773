#include "json/parse.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "base/text.h"
#include "json/syntax_error.h"
#include "json/tree.h"

namespace wrinkle::json {
namespace {

bool is_punctuation(char c) {
    return c == ',' || c == ':' || c == '{' || c == '}' || c == '[' || c == ']';
}

// The text as the library reads it: of a string of plain characters only the quotes, and no white
// space after strings and punctuation. The library takes 50 instructions for a character.
struct Feed {
    const char* at;                    // next character
    const char* end;                   // a zero byte
    const char* taken = at;            // one past the character read last
    const char* string = nullptr;      // opening quote of the latest string
    const char* string_end = nullptr;  // one past its closing quote

    void advance() {
        taken = ++at;
        if (taken < string_end) return;
        if (taken[-1] == '"' && taken != string_end) return begin_string();
        while (is_space(*at) && (taken == string_end || is_punctuation(taken[-1])))
            ++at;
    }
    void begin_string() {
        string = at - 1;
        const char* quote = at;
        while (is_json_plain(*quote))
            ++quote;
        if (*quote == '"') at = quote;
        while (quote < end && *quote != '"')
            quote += *quote == '\\' ? 2 : 1;
        string_end = std::min(quote, end) + 1;
    }
};

// Iterator for the library, with the operations that it uses. All copies share one position;
// supports comparison only with the end.
struct FeedIterator : std::iterator_traits<const char*> {
    using iterator_category = std::input_iterator_tag;

    explicit FeedIterator(Feed& text) : feed(&text) {}
    const char& operator*() const { return *feed->at; }
    FeedIterator& operator++() {
        feed->advance();
        return *this;
    }
    bool operator==(const FeedIterator&) const { return feed->at == feed->end; }

    Feed* feed;
};

// Receives the library's events and builds the tree.
class Handler {
public:
    Handler(const std::shared_ptr<Tree>& tree, Diagnostics& diagnostics, uint32_t max_depth)
        : shared_(tree), tree_(*tree), diagnostics_(diagnostics), max_depth_(max_depth) {}

    bool null() { return literal(Kind::null, false); }
    bool boolean(bool value) { return literal(Kind::boolean, value); }
    bool number_integer(int64_t) { return number(); }
    bool number_unsigned(uint64_t) { return number(); }
    bool number_float(double, const std::string&) { return number(); }
    bool string(std::string& text) { return add_string(text); }
    bool key(std::string& text) { return add_string(text); }
    bool binary(std::vector<uint8_t>&) { return false; }
    bool start_object(size_t) { return open(Kind::object); }
    bool start_array(size_t) { return open(Kind::array); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    template <class Exception>
    bool parse_error(size_t, const std::string&, const Exception& exception) {
        constexpr int number_overflow = 406;  // the library's number of this error
        report_syntax(exception.id == number_overflow);
        return false;
    }

    FeedIterator iterator() { return FeedIterator(feed_); }

    // Returns false and reports an error if more than white space follows the tokens: the library
    // takes a zero byte for the end of the text.
    bool is_at_end() {
        if (skip_space(tree_.source, cursor_) == tree_.source.size()) return true;
        report_syntax(false);
        return false;
    }

    // Closes all open containers after an error and marks them as cut off.
    void cut() {
        for (; open_.size() > 1; close()) {
            Entry& entry = tree_.entries[open_.back().entry];
            entry.cut_off = true;
            const bool lone_key = entry.kind == Kind::object && open_.back().added % 2 == 1;
            if (lone_key) tree_.entries.pop_back();
        }
    }

private:
    struct Open {
        uint32_t entry = 0;
        uint32_t added = 0;  // direct children: values, and in an object also keys
    };

    void report(RuleId rule, uint32_t offset, std::string pointer, std::string message,
                std::string expected) {
        diagnostics_.add({.rule = rule,
                          .where = tree_.location(offset),
                          .pointer = std::move(pointer),
                          .message = std::move(message),
                          .expected = std::move(expected)});
    }

    void report_syntax(bool out_of_range) {
        const Open& in = open_.back();
        const Kind container = open_.size() == 1 ? Kind::null : tree_.entries[in.entry].kind;
        const SyntaxError error =
            explain({tree_.source, cursor_, consumed(), container, in.added, out_of_range});
        report(RuleId::json_syntax, error.offset, Value(shared_, in.entry).pointer(), error.message,
               error.expected);
    }

    const char* begin() const { return tree_.source.data(); }
    uint32_t offset_of(const char* c) const { return static_cast<uint32_t>(c - begin()); }
    uint32_t consumed() const { return offset_of(feed_.taken); }

    // Returns the start of the token that the library has just accepted: only white space and
    // separators are before it.
    uint32_t start() const {
        uint32_t offset = cursor_;
        const auto is_skipped = [](char c) { return c <= ' ' || c == ',' || c == ':'; };
        while (is_skipped(tree_.source[offset]))
            ++offset;
        return offset;
    }

    Entry& add(Kind kind, uint32_t offset) {
        Open& parent = open_.back();
        ++parent.added;
        return tree_.entries.emplace_back(
            Entry{.offset = offset, .parent = parent.entry, .kind = kind});
    }

    bool literal(Kind kind, bool truth) {
        add(kind, start()).length = truth;
        cursor_ = consumed();
        return true;
    }

    bool number() {
        const uint32_t offset = start();
        // The library has read one byte beyond the number, unless the text ends with it.
        const char last = feed_.taken[-1];
        const bool is_last = feed_.taken == feed_.end && last >= '0' && last <= '9';
        cursor_ = consumed() - (is_last ? 0 : 1);
        add(Kind::number, offset).length = cursor_ - offset;
        return true;
    }

    bool add_string(const std::string& text) {
        const uint32_t offset = offset_of(feed_.string);
        cursor_ = consumed();
        Entry& entry = add(Kind::string, offset);
        entry.length = cursor_ - offset - 2;
        if (text.empty() || entry.length == text.size()) return true;  // empty: not read
        entry.length = static_cast<uint32_t>(text.size());
        entry.pooled = true;
        tree_.pool += text;
        entry.end = static_cast<uint32_t>(tree_.pool.size());
        return true;
    }

    bool open(Kind kind) {
        cursor_ = consumed();
        const uint32_t offset = cursor_ - 1;
        if (open_.size() > max_depth_) {
            report(RuleId::json_syntax, offset, Value(shared_, open_.back().entry).pointer(),
                   "nested more than " + std::to_string(max_depth_) + " deep",
                   "arrays and objects nest at most " + std::to_string(max_depth_) + " deep");
            return false;
        }
        add(kind, offset);
        open_.push_back({static_cast<uint32_t>(tree_.entries.size() - 1)});
        return true;
    }

    bool close() {
        cursor_ = consumed();
        const Open ends = open_.back();
        open_.pop_back();
        Entry& entry = tree_.entries[ends.entry];
        entry.length = ends.added;
        entry.end = static_cast<uint32_t>(tree_.entries.size());
        if (entry.kind == Kind::array) return true;
        entry.length /= 2;
        if (entry.length > 1) find_duplicates(ends.entry, entry.end);
        return true;
    }

    // Returns false only if all keys differ: compares one bit of their lengths and last characters.
    bool may_have_duplicates(uint32_t object, uint32_t end) const {
        uint64_t bits = 0;
        for (uint32_t k = object + 1; k < end; k = tree_.after(k + 1)) {
            const std::string_view key = tree_.text(tree_.entries[k]);
            const uint64_t bit = uint64_t{1}
                                 << (key.size() * 5 + (key.empty() ? 0 : key.back())) % 64;
            if (bits & bit) return true;
            bits |= bit;
        }
        return false;
    }

    // Marks each member with a key that occurred before.
    void find_duplicates(uint32_t object, uint32_t end) {
        if (!may_have_duplicates(object, end)) return;
        std::unordered_map<std::string_view, uint32_t> first_with;
        first_with.reserve(tree_.entries[object].length);
        for (uint32_t k = object + 1; k < end; k = tree_.after(k + 1)) {
            const auto [first, is_new] = first_with.emplace(tree_.text(tree_.entries[k]), k);
            if (!is_new) duplicate(object, first->second, k);
        }
    }

    void duplicate(uint32_t object, uint32_t first, uint32_t again) {
        std::vector<Entry>& entries = tree_.entries;
        entries[again].duplicate = entries[again + 1].duplicate = true;
        --entries[object].length;
        if (diagnostics_.dropped() > 0) return diagnostics_.add({});  // only counted from here on
        const Location before = tree_.location(entries[first].offset);
        report(RuleId::duplicate_key, entries[again].offset, Value(shared_, again + 1).pointer(),
               "key " + json_quoted(tree_.text(entries[again])) + " occurs twice",
               "first at line " + std::to_string(before.line) + ", column " +
                   std::to_string(before.column));
    }

    std::shared_ptr<Tree> shared_;
    Tree& tree_;
    Diagnostics& diagnostics_;
    uint32_t max_depth_;
    Feed feed_{begin(), begin() + tree_.source.size()};
    uint32_t cursor_ = begin_of(tree_.source);  // end of the last token understood
    std::vector<Open> open_{Open()};            // the text itself, and its open containers
};

// Approximate for graphs; for other texts the tree grows as required.
constexpr size_t bytes_an_entry = 6, max_expected_entries = 1'000'000;

}  // namespace

Parsed parse(std::string text, std::string file, Diagnostics& diagnostics, uint32_t max_depth) {
    auto tree = std::make_shared<Tree>();
    tree->file = std::move(file);
    tree->source = std::move(text);
    if (tree->source.size() >= std::numeric_limits<uint32_t>::max()) {
        diagnostics.add(file_problem(Severity::error, RuleId::over_limit, tree->file,
                                     "the text is larger than 4 GiB", ""));
        return {};
    }
    tree->is_parsed = true;
    tree->entries.reserve(std::min(tree->source.size() / bytes_an_entry, max_expected_entries));
    Handler handler(tree, diagnostics, max_depth);
    const bool complete =
        nlohmann::json::sax_parse(handler.iterator(), handler.iterator(), &handler) &&
        handler.is_at_end();
    if (!complete) handler.cut();
    if (tree->entries.empty()) tree->entries.emplace_back();
    return {Value(tree, 0), complete};
}

}  // namespace wrinkle::json
