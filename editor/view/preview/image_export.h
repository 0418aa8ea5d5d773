// Exports the preview as an image file, rendered again in any size.
#pragma once

#include <filesystem>

#include "editor/view/state.h"

namespace wrinkle::editor {

struct ImageSize {
    int width = 0, height = 0;
};
// Sizes to choose from: the current size, then squares.
std::vector<ImageSize> image_sizes(const PreviewState& state);

// Runs in the background: the preview renders, the task writes. Includes a comparison as shown.
void start_image_export(State& state, const std::filesystem::path& file, ImageSize size);

// Returns "graph.png" next to the graph.
std::filesystem::path usual_image_path(const State& state);

// Returns the reason why there is no rendering to export; "" if there is one.
std::string_view why_no_image(const State& state);

}  // namespace wrinkle::editor
