// What the browser and the start page do with a file once it is chosen.
#pragma once

#include <filesystem>
#include <vector>

#include "editor/state.h"

namespace wrinkle::editor {

// Asks about unsaved work first, and again where there is no such file.
void open_chosen(State& state, const std::filesystem::path& file);
// Asks before anything is replaced, and again where it cannot be written.
void save_chosen(State& state, const std::filesystem::path& file);
void new_chosen(State& state);
std::vector<std::filesystem::path> recent_files(const State& state);

}  // namespace wrinkle::editor
