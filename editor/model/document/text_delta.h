// Text deltas: ranges copied from the old text, and new bytes between them. Computed line by line,
// in time linear in the texts; an edit of a graph changes few lines of its text.
//
// A delta is a sequence of "=OFFSET,LENGTH\n" (copy) and "+LENGTH\n" followed by that many bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace wrinkle::editor {

// Writes a delta from operations in order; merges adjacent ones.
class DeltaWriter {
public:
    explicit DeltaWriter(std::string_view before = {}) : before_(before) {}

    void copy(size_t offset, size_t length);  // range of the old text
    void add(std::string_view bytes);
    // Returns true if these bytes follow the current copy range in `before`.
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
// Returns std::nullopt if the delta is malformed or does not fit this text.
std::optional<std::string> apply_text_delta(std::string_view before, std::string_view delta);

}  // namespace wrinkle::editor
