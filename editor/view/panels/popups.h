// Popups over a field or a header: text field, list of choices or image files with a query field
// that filters it, color picker.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

// Opens the popup that edits the field: text, list or color. Tab continues with the next field.
void open_field(State& state, const Card& card, const Field& field);
void choose_picture(State& state);  // opens a list of images; the chosen one is added
void edit_values(State& state);     // opens the first field of the selected node

// Returns the image files below `folder`, relative to it, sorted: at most `limit`. The search stops
// after `max_entries` files and folders.
std::vector<std::string> image_files(const std::filesystem::path& folder, size_t limit = 500,
                                     size_t max_entries = 20'000);

}  // namespace wrinkle::editor
