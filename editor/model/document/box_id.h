// Identifies a frame or a note; frames and notes have separate name spaces.
#pragma once

#include <compare>
#include <string>

namespace wrinkle::editor {

struct BoxId {
    bool note = false;
    std::string id;
    auto operator<=>(const BoxId&) const = default;
};

}  // namespace wrinkle::editor
