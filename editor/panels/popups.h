// What opens over a field or a header: a text to type, a list of choices or of image files with a
// field that narrows it, a colour.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

void draw_popup(State& state);

// Opens what changes the field: a text, a list or a colour. Tab goes on to the next one.
void open_field(State& state, const Card& card, const Field& field);
void choose_picture(State& state);  // that is to be added
void edit_values(State& state);     // the first one of the selected node

// The image files below the graph's folder, relative to it, sorted; at most `limit`, looked for
// among `most_entries` files and folders.
std::vector<std::string> image_files(const std::filesystem::path& folder, size_t limit = 500,
                                     size_t most_entries = 20'000);

}  // namespace wrinkle::editor
