// What was copied last, beyond its text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "editor/document/wiring.h"

namespace wrinkle::editor {

struct Clip {
    std::string text;                // as it was put on the clipboard
    std::filesystem::path document;  // where it came from
    std::vector<Connection> outer;   // wires into the copied nodes that the text leaves out
};

}  // namespace wrinkle::editor
