#include "json/parse.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

#include "base/text.h"
#include "base/text_hash.h"
#include "json/syntax_error.h"
#include "json/tree.h"

namespace wrinkle::json {
namespace {

// Iterator over the text for the library. All copies share one position, from which the handler
// takes the locations of tokens. Supports comparison only with the end.
struct SharedIterator {
    using difference_type = std::ptrdiff_t;
    using value_type = char;
    using pointer = const char*;
    using reference = const char&;
    using iterator_category = std::input_iterator_tag;

    const char** at;
    const char* end;

    const char& operator*() const { return **at; }
    SharedIterator& operator++() {
        ++*at;
        return *this;
    }
    SharedIterator operator++(int) {
        ++*this;
        return *this;
    }
    bool operator==(const SharedIterator&) const { return *at == end; }
    bool operator!=(const SharedIterator&) const { return *at != end; }
};

bool is_number_character(char c) {
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E';
}

// Receives the library's events and builds the tree.
class Handler {
public:
    Handler(const std::shared_ptr<Tree>& tree, Diagnostics& diagnostics, ParseLimits limits)
        : shared_(tree), tree_(*tree), diagnostics_(diagnostics), limits_(limits) {
        open_.reserve(16);
        open_.emplace_back();
        cursor_ = begin_of(tree_.source);
        at_ = tree_.source.data();
    }

    bool null() { return literal(Kind::null, 4, false); }
    bool boolean(bool value) { return literal(Kind::boolean, value ? 4 : 5, value); }
    bool number_integer(int64_t) { return number(); }
    bool number_unsigned(uint64_t) { return number(); }
    bool number_float(double, const std::string&) { return number(); }
    bool string(std::string& text) { return add_string(text); }
    bool key(std::string& text) {
        add_string(text);
        if (open_.back().added > 2 * few) keep_key();
        return true;
    }
    bool binary(std::vector<uint8_t>&) { return false; }
    bool start_object(size_t) { return open(Kind::object); }
    bool start_array(size_t) { return open(Kind::array); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    template <class Exception>
    bool parse_error(size_t, const std::string&, const Exception& exception) {
        const SyntaxError error = explain(exception.what(), tree_.source, cursor_, consumed());
        report(error.offset, Value(shared_, open_.back().entry).pointer(), error.message,
               error.expected);
        return false;
    }

    SharedIterator iterator() { return {&at_, tree_.source.data() + tree_.source.size()}; }
    uint32_t cursor() const { return cursor_; }

    void report(uint32_t offset, std::string pointer, std::string message, std::string expected) {
        Diagnostic diagnostic;
        diagnostic.where = tree_.location(offset);
        diagnostic.pointer = std::move(pointer);
        diagnostic.message = std::move(message);
        diagnostic.expected = std::move(expected);
        diagnostics_.add(std::move(diagnostic));
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
        uint32_t first_key = 0;  // index of its first key in keys_
        uint32_t added = 0;      // direct children: values, and in an object also keys
    };
    struct Key {
        uint32_t hash;
        uint32_t entry;
    };
    // Up to this number of members, keys are compared pairwise; above it, they are hashed on
    // arrival.
    static constexpr uint32_t few = 8;

    uint32_t consumed() const { return static_cast<uint32_t>(at_ - tree_.source.data()); }
    uint32_t start() const { return token_start(tree_.source, cursor_, ~0u); }

    Entry& add(Kind kind, uint32_t offset) {
        Open& parent = open_.back();
        ++parent.added;
        Entry& entry = tree_.entries.emplace_back();
        entry.offset = offset;
        entry.parent = parent.entry;
        entry.kind = kind;
        return entry;
    }

    bool literal(Kind kind, uint32_t length, bool truth) {
        const uint32_t offset = start();
        cursor_ = offset + length;
        add(kind, offset).truth = truth;
        return true;
    }

    bool number() {
        const std::string& source = tree_.source;
        const uint32_t offset = start();
        uint32_t end = offset;
        while (end < source.size() && is_number_character(source[end]))
            ++end;
        cursor_ = end;
        add(Kind::number, offset).length = end - offset;
        return true;
    }

    bool add_string(const std::string& text) {
        const uint32_t offset = start();
        cursor_ = consumed();
        Entry& entry = add(Kind::string, offset);
        entry.length = cursor_ - offset - 2;
        if (entry.length == text.size()) return true;
        entry.length = static_cast<uint32_t>(text.size());
        entry.pooled = true;
        entry.place = static_cast<uint32_t>(tree_.pool.size());
        tree_.pool += text;
        return true;
    }

    bool open(Kind kind) {
        cursor_ = consumed();
        const uint32_t offset = cursor_ - 1;
        if (open_.size() > limits_.depth) {
            report(offset, Value(shared_, open_.back().entry).pointer(),
                   "nested more than " + std::to_string(limits_.depth) + " deep",
                   "arrays and objects nest at most " + std::to_string(limits_.depth) + " deep");
            return false;
        }
        add(kind, offset);
        open_.push_back(
            {static_cast<uint32_t>(tree_.entries.size() - 1), static_cast<uint32_t>(keys_.size())});
        return true;
    }

    bool close() {
        cursor_ = consumed();
        const Open ends = open_.back();
        open_.pop_back();
        Entry& entry = tree_.entries[ends.entry];
        entry.length = ends.added;
        entry.place = static_cast<uint32_t>(tree_.entries.size());
        if (entry.kind == Kind::array) return true;
        entry.length /= 2;
        if (entry.length > few)
            find_duplicates(ends);
        else if (entry.length > 1)
            find_few_duplicates(ends.entry, entry.place);
        keys_.resize(ends.first_key);
        return true;
    }

    // Stores the latest key of the innermost open object; with the ninth key, also those before it.
    void keep_key() {
        const Open& in = open_.back();
        const auto latest = static_cast<uint32_t>(tree_.entries.size() - 1);
        if (keys_.size() == in.first_key)
            for (uint32_t k = in.entry + 1; k < latest; k = tree_.after(k + 1))
                keys_.push_back(key_at(k));
        keys_.push_back(key_at(latest));
    }
    Key key_at(uint32_t entry) const {
        return {static_cast<uint32_t>(text_hash(tree_.text(tree_.entries[entry]))), entry};
    }

    // Marks each member with a key that occurred before. The last key may have no value.
    void find_duplicates(const Open& ended) {
        const uint32_t count = tree_.entries[ended.entry].length;
        const std::span<const Key> keys = std::span(keys_).subspan(ended.first_key, count);
        slots_.assign(std::bit_ceil(size_t{count} * 2), 0);
        const size_t mask = slots_.size() - 1;
        for (uint32_t i = 0; i < count; ++i) {
            const auto is_other = [&](const Key& key) {
                return key.hash != keys[i].hash || !same_text(key.entry, keys[i].entry);
            };
            size_t slot = keys[i].hash & mask;
            while (slots_[slot] != 0 && is_other(keys[slots_[slot] - 1]))
                slot = (slot + 1) & mask;
            if (slots_[slot] == 0)
                slots_[slot] = i + 1;
            else
                duplicate(ended.entry, keys[slots_[slot] - 1].entry, keys[i].entry);
        }
    }

    void find_few_duplicates(uint32_t object, uint32_t end) {
        for (uint32_t k = tree_.after(object + 2); k < end; k = tree_.after(k + 1))
            for (uint32_t first = object + 1; first < k; first = tree_.after(first + 1))
                if (!tree_.entries[first].duplicate && same_text(first, k)) {
                    duplicate(object, first, k);
                    break;
                }
    }

    bool same_text(uint32_t a, uint32_t b) const {
        const Entry &one = tree_.entries[a], &two = tree_.entries[b];
        return one.length == two.length && tree_.text(one) == tree_.text(two);
    }

    void duplicate(uint32_t object, uint32_t first, uint32_t again) {
        std::vector<Entry>& entries = tree_.entries;
        entries[again].duplicate = entries[again + 1].duplicate = true;
        --entries[object].length;
        if (diagnostics_.dropped() > 0) return diagnostics_.add({});  // only counted from here on
        const Location before = tree_.location(entries[first].offset);
        report(entries[again].offset, Value(shared_, again + 1).pointer(),
               "key " + json_quoted(tree_.text(entries[again])) + " stands twice",
               "first at line " + std::to_string(before.line) + ", column " +
                   std::to_string(before.column));
    }

    std::shared_ptr<Tree> shared_;
    Tree& tree_;
    Diagnostics& diagnostics_;
    ParseLimits limits_;
    const char* at_;          // next character of the library's lexer
    uint32_t cursor_ = 0;     // end of the last token understood
    std::vector<Open> open_;  // the text itself, and its open containers
    std::vector<Key> keys_;   // keys of open objects with many members
    std::vector<uint32_t> slots_;
};

// Approximate for graphs; for other texts the tree grows as required.
constexpr size_t bytes_an_entry = 6, max_expected_entries = 1'000'000;

bool too_large(const Tree& tree, Diagnostics& diagnostics) {
    if (tree.source.size() < std::numeric_limits<uint32_t>::max()) return false;
    Diagnostic diagnostic;
    diagnostic.where.file = tree.file;
    diagnostic.message = "the text is larger than 4 GiB";
    diagnostics.add(std::move(diagnostic));
    return true;
}

bool read_all(Tree& tree, Handler& handler) {
    if (!nlohmann::json::sax_parse(handler.iterator(), handler.iterator(), &handler)) return false;
    const uint32_t rest = token_start(tree.source, handler.cursor(), 0);
    if (rest == tree.source.size()) return true;
    handler.report(rest, "", "unexpected byte 0x00", "expected the end of the file");
    return false;
}

}  // namespace

Parsed parse(std::string text, std::string file, Diagnostics& diagnostics, ParseLimits limits) {
    auto tree = std::make_shared<Tree>();
    tree->file = std::move(file);
    tree->source = std::move(text);
    if (too_large(*tree, diagnostics)) return {};
    tree->lines = std::make_unique<Lines>();
    tree->entries.reserve(std::min(tree->source.size() / bytes_an_entry, max_expected_entries));
    Handler handler(tree, diagnostics, limits);
    const bool complete = read_all(*tree, handler);
    if (!complete) handler.cut();
    if (tree->entries.empty()) tree->entries.emplace_back();
    return {Value(tree, 0), complete};
}

}  // namespace wrinkle::json
