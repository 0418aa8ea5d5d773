// File browser: folders and files of one kind, with a text field. The typed text filters the list;
// it may also be a path to open or the name of a file to save.
//
//   Up, Down, Page Up, Page Down   choose        Enter   opens the folder or chooses the file
//   Backspace in an empty field    one folder up  Escape  closes
#pragma once

#include "editor/view/panels/listing.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

// Opens the browser in the folder of `file`; if the purpose is to save, proposes its name.
void browse(Dialogs& dialogs, Browser::Purpose purpose, const std::filesystem::path& file);
// Opens the browser to choose an image for an input of a node; "" as `node` adds a node.
void browse_image(State& state, const std::string& node, const std::string& port);

// Actions of the browser and the start page for a chosen file.
//
// Opens the file; prompts for unsaved work first, and for another path if opening fails.
void open_chosen(State& state, const std::filesystem::path& file);
// Saves to the file; prompts before it replaces one, and for another path if saving fails.
void save_chosen(State& state, const std::filesystem::path& file);

}  // namespace wrinkle::editor
