// Files dropped on the window of another program as a file manager does it: the XDND protocol,
// version 5, on an X display.
#pragma once

#include <string>
#include <vector>

#include "virtual_screen.h"

namespace wrinkle::editor {

// Drops the files (absolute paths) at a place of the screen, in pixels, on the only window there
// that takes drops; waits for such a window. "" when that window has taken them, else the reason.
std::string drop_files(const VirtualScreen& screen, int x, int y,
                       const std::vector<std::string>& files);

}  // namespace wrinkle::editor
