// Actions of the file browser and the start page for a chosen file.
#pragma once

#include <filesystem>

#include "editor/view/state.h"

namespace wrinkle::editor {

// Opens the file; prompts for unsaved work first, and for another path if opening fails.
void open_chosen(State& state, const std::filesystem::path& file);
// Saves to the file; prompts before it replaces one, and for another path if saving fails.
void save_chosen(State& state, const std::filesystem::path& file);

}  // namespace wrinkle::editor
