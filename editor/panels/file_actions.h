// What the browser and the start page do with a file once it is chosen.
#pragma once

#include <filesystem>

#include "editor/state.h"

namespace wrinkle::editor {

// Asks about unsaved work first, and again where there is no such file.
void open_chosen(State& state, const std::filesystem::path& file);
// Asks before anything is replaced, and again where it cannot be written.
void save_chosen(State& state, const std::filesystem::path& file);

}  // namespace wrinkle::editor
