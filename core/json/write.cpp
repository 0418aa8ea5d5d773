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

// Returns the number of columns of an entry without its children; a container includes its
// brackets, and the separators of its children.
size_t own_width(const Tree& tree, const Entry& entry) {
    if (!is_container(entry.kind)) return scalar(tree, entry).size();
    if (entry.length == 0) return 2;
    const size_t separators = (entry.length - 1) * 2;  // ", "
    return 2 + separators + (entry.kind == Kind::object ? 2 + entry.length * 2 : 0);
}

class Writer {
public:
    Writer(const Tree& tree, uint32_t root, size_t indent, size_t column, size_t width)
        : tree_(tree), root_(root), indent_(indent), column_(column), width_(width) {}

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

    // Returns true if the container fits the rest of the line; stops at the first entry beyond it.
    bool fits(uint32_t container) const {
        if (width_ == unlimited || (!open_.empty() && open_.back().flat)) return true;
        size_t end = column_ + out_.size() - line_begin_;
        uint32_t i = container;
        while (end < width_ && i < tree_.after(container)) {
            const bool skipped = i != container && tree_.entries[i].duplicate;
            if (!skipped) end += own_width(tree_, tree_.entries[i]);
            i = skipped ? tree_.after(i + 1) : i + 1;
        }
        return end < width_;
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
    std::vector<Open> open_;
    std::string out_;
    size_t line_begin_ = 0;
};

}  // namespace

std::string one_line(const Value& value) {
    return pretty(value, 0, 0, Writer::unlimited);
}

std::string pretty(const Value& value, size_t indent, size_t column, size_t width) {
    const Tree* tree = value.tree().get();
    if (!tree) return "null";
    return Writer(*tree, value.index(), indent, column, width).run();
}

std::string string_array(const std::vector<std::string>& words) {
    std::string text = "[";
    for (const std::string& word : words)
        text += (text.size() > 1 ? ", " : "") + json_quoted(word);
    return text + "]";
}

}  // namespace wrinkle::json
