// The picture of the preview as a file, drawn anew in any size.
#pragma once

#include <filesystem>
#include <span>

#include "editor/state.h"

namespace wrinkle::editor {

struct PictureSize {
    int width = 0, height = 0;
};
// Those to choose from: as it is shown, then squares.
std::vector<PictureSize> picture_sizes(const State& state);

// In the background: drawn by the preview, written by the task. What is compared is in it as shown.
void start_picture_export(State& state, const std::filesystem::path& file, PictureSize size);

// "graph.png" beside the graph.
std::filesystem::path usual_picture(const State& state);

// Why there is no picture to write; "" when there is one.
std::string_view no_picture(const State& state);

}  // namespace wrinkle::editor
