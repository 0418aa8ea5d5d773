// The document's file: opening and saving. What a file holds that cannot be read whole is never
// written over.
#pragma once

#include <filesystem>

#include "editor/state.h"

namespace wrinkle::editor {

// Opens a graph. A file that does not exist is a new graph under that name.
void open_file(State& state, const std::filesystem::path& path);
bool save_file(State& state);  // false, and why in the status, when nothing was written

}  // namespace wrinkle::editor
