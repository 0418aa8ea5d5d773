// Drops files on the window of another process as a file manager does: XDND protocol, version 5, on
// an X display.
#pragma once

#include <string>
#include <vector>

#include "virtual_screen.h"

namespace wrinkle::editor {

// Drops the files (absolute paths) at a screen position, in pixels, on the only window that accepts
// drops; waits for such a window. Returns "" if the window accepted them, else the reason.
std::string drop_files(const VirtualScreen& screen, int x, int y,
                       const std::vector<std::string>& files);

}  // namespace wrinkle::editor
