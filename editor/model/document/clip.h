// The most recent copy: its clipboard text and the data that the text does not contain.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "editor/model/document/wiring.h"

namespace wrinkle::editor {

struct Clip {
    std::string text;                // as put on the clipboard
    std::filesystem::path document;  // path of the source document
    std::vector<Connection> outer;   // wires into the copied nodes that are not in the text
};

}  // namespace wrinkle::editor
