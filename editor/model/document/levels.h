// Enters and leaves sub-graphs. The parent graphs of the one on the canvas stay open with their
// history, view and journal; each is a separate file, saved separately.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "editor/model/document/intent.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

// Returns the selected node if it is the only one and a sub-graph; otherwise nullptr.
const Node* selected_group(const State& state);

// Opens the sub-graph of the one selected node. Reports in the status if its file does not exist or
// is already open as a parent graph.
void open_group(State& state);
// Opens a file as a sub-graph of the current graph.
void enter_subgraph(State& state, const std::filesystem::path& file);

// Returns to state.outer[depth] and reloads the files that it uses. The graphs inside it are closed
// and their unsaved edits discarded: request_action() prompts first.
void leave_subgraphs(State& state, size_t depth);
// Closes the parent graphs of the current one and discards their unsaved edits.
void close_outer(State& state);

// Returns the files with unsaved edits that the intent would close, the innermost first.
std::vector<std::string> unsaved(const State& state, const PendingAction& intent);

// Returns true if both paths exist and are the same file.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

// Returns the names of the open files, from the outermost to the one on the canvas.
std::vector<std::string> open_files(const State& state);

}  // namespace wrinkle::editor
