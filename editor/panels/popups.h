// What opens over a field or a header: a text to type, a list of choices, a list of image files.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

void draw_popup(State& state);

// The image files below the graph's folder, relative to it, sorted; at most `limit`, looked for
// among `most_entries` files and folders.
std::vector<std::string> image_files(const std::filesystem::path& folder, size_t limit = 500,
                                     size_t most_entries = 20'000);

}  // namespace wrinkle::editor
