// Enters and leaves sub-graphs. The parent graphs of the one on the canvas stay open with their
// history, view and recovery file; each is a separate file, saved separately.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "editor/model/session.h"

namespace wrinkle::editor {

// Opens the graph of a sub-graph node. Reports in the status if its file does not exist or is
// already open as a parent graph.
void open_group(Session& session, const Node& node);

// Returns to session.parent_graphs[depth] and reloads the files that it uses. The graphs inside it
// are closed and their unsaved edits discarded: request_action() prompts first.
void leave_subgraphs(Session& session, size_t depth);
// Closes the parent graphs of the current one and discards their unsaved edits.
void close_outer(Session& session);

// Returns the files with unsaved edits that the intent would close, the innermost first.
std::vector<std::string> unsaved(const Session& session, const PendingAction& intent);

// Returns true if both paths exist and are the same file.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

// Returns the names of the open files, from the outermost to the one on the canvas.
std::vector<std::string> open_files(const Session& session);

}  // namespace wrinkle::editor
