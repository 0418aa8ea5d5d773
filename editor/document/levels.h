// Going into sub-graphs and coming back. The graphs around the one on the canvas stay open with
// their history, their view and their journal; each is a file of its own, saved by itself.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "editor/document/intent.h"
#include "editor/state.h"

namespace wrinkle::editor {

// The node of the selection when it is a sub-graph; nullptr else.
const Node* selected_group(const State& state);

// Opens the sub-graph of the one selected node inside the present graph; the status says why it
// cannot: its file is not there, or is one of those that are open around it.
void open_group(State& state);
// Opens a file inside the present graph.
void dive(State& state, const std::filesystem::path& file);

// state.outer[depth] on the canvas again, read anew as far as it shows other files. The graphs
// that were open inside it are closed, unsaved edits with them: intend() asks first.
void come_back(State& state, size_t depth);
// The graphs around the present one are given up.
void close_outer(State& state);

// The files with unsaved edits that the intent would put away, the innermost first.
std::vector<std::string> unsaved(const State& state, const Intent& intent);

// Of two paths that both lead somewhere.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

// The names of the open files from the outermost to the one on the canvas.
std::vector<std::string> open_files(const State& state);

}  // namespace wrinkle::editor
