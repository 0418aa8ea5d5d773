#include "json/write.h"

#include <limits>

#include "base/text.h"
#include "json/tree.h"

namespace wrinkle::json {
namespace {

std::string scalar(const Tree& tree, const Entry& entry) {
    if (entry.kind == Kind::string) return json_quoted(tree.text(entry));
    if (entry.kind == Kind::number) return std::string(tree.text(entry));
    if (entry.kind == Kind::boolean) return entry.truth ? "true" : "false";
    return "null";
}

// Returns the number of columns of every entry written on one line; a key includes its ": ".
// Children are stored after their container, so one reverse loop is sufficient.
std::vector<size_t> flat_widths(const Tree& tree, uint32_t root) {
    const uint32_t end = tree.after(root);
    std::vector<size_t> widths(end - root, 0);
    std::vector<bool> key(end - root, false);
    for (uint32_t i = end; i-- > root;) {
        const Entry& entry = tree.entries[i];
        size_t& width = widths[i - root];
        if (is_container(entry.kind)) {
            width += 2;
            if (entry.length > 0)
                width += (entry.length - 1) * 2 + (entry.kind == Kind::object ? 2 : 0);
        } else {
            width = scalar(tree, entry).size();
        }
        if (i == root || entry.duplicate) continue;
        const uint32_t parent = entry.parent;
        const bool member = tree.entries[parent].kind == Kind::object;
        const bool value = member && i > parent + 1 && !key[i - root];
        if (value && i > root) key[i - 1 - root] = true;
        widths[parent - root] += width + (key[i - root] ? 2 : 0);
    }
    return widths;
}

class Writer {
public:
    Writer(const Tree& tree, uint32_t root, size_t indent, size_t column, size_t width)
        : tree_(tree), root_(root), indent_(indent), column_(column), width_(width) {
        if (width_ != unlimited) widths_ = flat_widths(tree, root);
    }

    std::string run() {
        uint32_t i = write_value(root_);
        while (!open_.empty()) {
            if (i == open_.back().end)
                close();
            else
                i = write_child(i);
        }
        return std::move(out_);
    }

    static constexpr size_t unlimited = std::numeric_limits<size_t>::max();

private:
    struct Open {
        uint32_t end;
        bool object;
        bool flat;
        bool first;
    };

    void new_line() {
        out_ += '\n';
        line_begin_ = out_.size();
        column_ = 0;
        out_.append(indent_ + 2 * open_.size(), ' ');
    }

    bool fits(uint32_t i) const {
        if (width_ == unlimited || (!open_.empty() && open_.back().flat)) return true;
        return column_ + out_.size() - line_begin_ + widths_[i - root_] < width_;
    }

    // Writes a scalar, or the start of a container; returns the entry to continue with.
    uint32_t write_value(uint32_t i) {
        const Entry& entry = tree_.entries[i];
        if (!is_container(entry.kind)) {
            out_ += scalar(tree_, entry);
            return i + 1;
        }
        const bool object = entry.kind == Kind::object;
        if (entry.length == 0) {
            out_ += object ? "{}" : "[]";
            return entry.place;
        }
        const bool flat = fits(i);
        out_ += object ? '{' : '[';
        open_.push_back({entry.place, object, flat, true});
        return i + 1;
    }

    uint32_t write_child(uint32_t i) {
        Open& open = open_.back();
        if (open.object && tree_.entries[i].duplicate) return tree_.after(i + 1);
        if (!open.first) out_ += ',';
        if (!open.flat)
            new_line();
        else if (!open.first || open.object)
            out_ += ' ';
        open.first = false;
        if (open.object) out_ += scalar(tree_, tree_.entries[i++]) + ": ";
        return write_value(i);
    }

    void close() {
        const Open open = open_.back();
        open_.pop_back();
        if (!open.flat)
            new_line();
        else if (open.object)
            out_ += ' ';
        out_ += open.object ? '}' : ']';
    }

    const Tree& tree_;
    uint32_t root_;
    size_t indent_, column_, width_;
    std::vector<size_t> widths_;
    std::vector<Open> open_;
    std::string out_;
    size_t line_begin_ = 0;
};

}  // namespace

std::string one_line(const Value& value) {
    return pretty(value, 0, 0, Writer::unlimited);
}

std::string pretty(const Value& value, size_t indent, size_t column, size_t width) {
    const Tree* tree = tree_of(value);
    if (!tree) return "null";
    return Writer(*tree, index_of(value), indent, column, width).run();
}

std::string string_array(const std::vector<std::string>& words) {
    std::string text = "[";
    for (const std::string& word : words)
        text += (text.size() > 1 ? ", " : "") + json_quoted(word);
    return text + "]";
}

}  // namespace wrinkle::json
