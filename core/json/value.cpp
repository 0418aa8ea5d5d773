#include "json/value.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

#include "base/text.h"
#include "json/tree.h"

namespace wrinkle::json {
namespace {

const Entry null_entry;

const Entry& entry_of(const Value& value) {
    return value.tree() ? value.tree()->entries[value.index()] : null_entry;
}

double number_of(std::string_view spelling) {
    double number = 0;  // unchanged if the text is too close to zero for a double
    std::from_chars(spelling.data(), spelling.data() + spelling.size(), number);
    return number;
}

uint32_t item_number(const Tree& tree, uint32_t array, uint32_t item) {
    uint32_t number = 0;
    for (uint32_t i = array + 1; i != item; i = tree.after(i))
        ++number;
    return number;
}

}  // namespace

const char* kind_name(Kind kind) {
    static constexpr std::array names = {"null",     "a boolean", "a number",
                                         "a string", "an array",  "an object"};
    return names[static_cast<size_t>(kind)];
}

std::string pointer_step(std::string_view key) {
    std::string step = "/";
    for (const char c : key) {
        if (c == '~')
            step += "~0";
        else if (c == '/')
            step += "~1";
        else
            step += c;
    }
    return step;
}

// Returns the mark of byte `end`, given that of byte `begin`.
Tree::Mark Tree::advanced(Mark mark, uint32_t begin, uint32_t end) const {
    std::string_view text = std::string_view(source).substr(begin, end - begin);
    if (const size_t last = text.rfind('\n'); last != text.npos) {
        mark.line += static_cast<uint32_t>(std::count(text.begin(), text.end(), '\n'));
        mark.column = 1;
        text.remove_prefix(last + 1);
    }
    const auto is_character = [](char byte) { return (byte & 0xC0) != 0x80; };  // UTF-8
    mark.column += static_cast<uint32_t>(std::count_if(text.begin(), text.end(), is_character));
    return mark;
}

Location Tree::location(uint32_t offset) const {
    constexpr uint32_t step = bytes_between_marks;
    const uint32_t begin = begin_of(source);
    if (offset <= begin) return {file, 1, 1};
    std::call_once(marks_.made, [&] {
        Mark mark;
        uint32_t from = begin;
        marks_.list.push_back(mark);
        for (uint32_t to = step; to <= source.size(); from = to, to += step)
            marks_.list.push_back(mark = advanced(mark, from, to));
    });
    const uint32_t nearest = offset / step;
    const Mark mark = advanced(marks_.list[nearest], std::max(nearest * step, begin), offset);
    return {file, mark.line, mark.column};
}

Kind Value::kind() const {
    return entry_of(*this).kind;
}

bool Value::as_boolean() const {
    assert(is(Kind::boolean));
    return entry_of(*this).length > 0;
}

double Value::as_number() const {
    return number_of(spelling());
}

std::string_view Value::spelling() const {
    assert(is(Kind::number));
    return tree_->text(tree_->entries[index_]);
}

std::string_view Value::as_string() const {
    assert(is(Kind::string));
    return tree_->text(tree_->entries[index_]);
}

size_t Value::size() const {
    const Entry& entry = entry_of(*this);
    return is_container(entry.kind) ? entry.length : 0;
}

ChildIterator::ChildIterator(const Value& parent) : left_(parent.size()) {
    member_.value = parent;
    if (left_ > 0) enter(parent.index_ + 1);
}

ChildIterator& ChildIterator::operator++() {
    const Tree& tree = *member_.value.tree_;
    if (--left_ == 0) return *this;
    uint32_t entry = tree.after(member_.value.index_);
    while (tree.entries[entry].duplicate)
        entry = tree.after(entry + 1);
    enter(entry);
    return *this;
}

// Moves to the child that begins with this entry: its key in an object.
void ChildIterator::enter(uint32_t entry) {
    const Tree& tree = *member_.value.tree_;
    const bool is_key = tree.entries[tree.entries[entry].parent].kind == Kind::object;
    if (is_key) member_.key = tree.text(tree.entries[entry]);
    member_.value.index_ = entry + is_key;
}

Value Value::find(std::string_view key) const {
    if (!is(Kind::object)) return {};
    for (const Member& member : children())
        if (member.key == key) return member.value;
    return {};
}

bool Value::has(std::string_view key) const {
    return find(key).tree_ != nullptr;
}

Value Value::at(size_t item) const {
    assert(is(Kind::array) && item < size());
    ChildIterator child(*this);
    for (; item > 0; --item)
        ++child;
    return (*child).value;
}

bool Value::has_location() const {
    return tree_ && tree_->is_parsed;
}

uint32_t Value::offset() const {
    return has_location() ? entry_of(*this).offset : 0;
}

Location Value::location() const {
    return has_location() ? tree_->location(offset()) : Location{};
}

Location Value::key_location() const {
    if (!has_location() || index_ == 0) return location();
    const uint32_t parent = tree_->entries[index_].parent;
    if (tree_->entries[parent].kind != Kind::object) return location();
    return tree_->location(tree_->entries[index_ - 1].offset);
}

std::string Value::pointer() const {
    if (!tree_) return {};
    std::string pointer;
    for (uint32_t i = index_; i != 0; i = tree_->entries[i].parent) {
        const uint32_t parent = tree_->entries[i].parent;
        const bool member = tree_->entries[parent].kind == Kind::object;
        pointer.insert(0, member ? pointer_step(tree_->text(tree_->entries[i - 1]))
                                 : "/" + std::to_string(item_number(*tree_, parent, i)));
    }
    return pointer;
}

bool Value::cut_off() const {
    return entry_of(*this).cut_off;
}

std::string_view Value::source() const {
    return has_location() ? std::string_view(tree_->source) : std::string_view();
}

bool Value::same(const Value& other) const {
    return tree_ == other.tree_ && index_ == other.index_;
}

bool operator==(const Value& a, const Value& b) {
    if (a.same(b)) return true;
    if (!a.tree_ || !b.tree_) return a.kind() == b.kind() && a.is(Kind::null);
    const uint32_t count = a.tree_->after(a.index_) - a.index_;
    if (b.tree_->after(b.index_) - b.index_ != count) return false;
    for (uint32_t i = 0; i < count; ++i) {
        const Entry& one = a.tree_->entries[a.index_ + i];
        const Entry& two = b.tree_->entries[b.index_ + i];
        const bool has_text = one.kind == Kind::number || one.kind == Kind::string;
        if (one.kind != two.kind || (!has_text && one.length != two.length)) return false;
        if (!has_text) continue;
        const std::string_view text = a.tree_->text(one), other = b.tree_->text(two);
        if (text == other) continue;
        if (one.kind != Kind::number || number_of(text) != number_of(other)) return false;
    }
    return true;
}

}  // namespace wrinkle::json
