// A frame or a note by its name; the two have name spaces of their own.
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
