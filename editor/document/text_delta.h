// How one text becomes another: ranges copied from the old one, and new bytes between them. Found
// line by line, in time linear in the texts; an edit of a graph touches few lines of its text.
//
// A delta is a row of "=OFFSET,LENGTH\n" (copy) and "+LENGTH\n" followed by that many bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace wrinkle::editor {

std::string text_delta(std::string_view before, std::string_view after);
// Nothing when the delta is none, or not of this text.
std::optional<std::string> apply_text_delta(std::string_view before, std::string_view delta);

}  // namespace wrinkle::editor
