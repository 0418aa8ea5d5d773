// What the browser and the start page do with a file once it is chosen.
#pragma once

#include <filesystem>
#include <vector>

#include "editor/state.h"

namespace wrinkle::editor {

void open_chosen(State& state, const std::filesystem::path& file);
// False, and why in the status, when nothing was written.
bool save_chosen(State& state, const std::filesystem::path& file);
void new_chosen(State& state);
std::vector<std::filesystem::path> recent_files(const State& state);

}  // namespace wrinkle::editor
