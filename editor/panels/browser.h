// The file browser: folders and files of one kind, with a field to type into. What is typed narrows
// the list, or is a name to save under, or a path to go to.
//
//   Up, Down, Page Up, Page Down   choose        Enter   opens the folder or takes the file
//   Backspace in an empty field    one folder up  Escape  closes
#pragma once

#include "editor/panels/listing.h"
#include "editor/state.h"

namespace wrinkle::editor {

// Opens the browser in the folder of `file`; the name is proposed when something is saved.
void browse(State& state, Browser::Purpose purpose, const std::filesystem::path& file);
// For a picture of a node.
void browse_picture(State& state, const std::string& node, const std::string& port);

void draw_browser(State& state);

}  // namespace wrinkle::editor
