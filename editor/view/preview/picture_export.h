// Exports the preview as an image file, rendered again in any size.
#pragma once

#include <filesystem>
#include <span>

#include "editor/view/state.h"

namespace wrinkle::editor {

struct PictureSize {
    int width = 0, height = 0;
};
// Sizes to choose from: the current size, then squares.
std::vector<PictureSize> picture_sizes(const State& state);

// Runs in the background: the preview renders, the task writes. Includes a comparison as shown.
void start_picture_export(State& state, const std::filesystem::path& file, PictureSize size);

// Returns "graph.png" next to the graph.
std::filesystem::path usual_picture(const State& state);

// Returns the reason why there is no rendering to export; "" if there is one.
std::string_view no_picture(const State& state);

}  // namespace wrinkle::editor
