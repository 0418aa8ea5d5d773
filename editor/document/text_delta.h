// How one text becomes another: ranges copied from the old one, and new bytes between them. Found
// line by line, in time linear in the texts; an edit of a graph touches few lines of its text.
//
// A delta is a row of "=OFFSET,LENGTH\n" (copy) and "+LENGTH\n" followed by that many bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace wrinkle::editor {

// Writes a delta from what it is given in order, joining what follows on each other.
class DeltaWriter {
public:
    explicit DeltaWriter(std::string_view before = {}) : before_(before) {}

    void copy(size_t offset, size_t length);  // of the old text
    void add(std::string_view bytes);
    // Whether the copy under way would go on with these bytes; of the text that was given.
    bool goes_on(std::string_view bytes) const;
    size_t end_of_copy() const { return offset_ + length_; }
    std::string take();

private:
    void flush();

    std::string_view before_;
    std::string delta_, added_;
    size_t offset_ = 0, length_ = 0;
};

std::string text_delta(std::string_view before, std::string_view after);
// Nothing when the delta is none, or not of this text.
std::optional<std::string> apply_text_delta(std::string_view before, std::string_view delta);

}  // namespace wrinkle::editor
