// The document's file: opens, saves, and detects changes by other programs. A file that could not
// be read completely is never overwritten, and neither is a version that another program wrote
// meanwhile.
//
// These functions act at once; intent.h prompts for unsaved work first.
#pragma once

#include <filesystem>

#include "editor/model/document/moved_paths.h"
#include "editor/model/session.h"

namespace wrinkle::editor {

// Creates an empty graph without a file, in `folder` if it exists, else in the working folder.
void new_file(Session& session, const std::filesystem::path& folder = {});
// Opens a graph. If the file does not exist, the graph is new under that name.
void open_file(Session& session, const std::filesystem::path& path);
// Reads a graph as the current one, without closing parent graphs; reset_derived() must follow.
void load_file(Session& session, const std::filesystem::path& path);
// Resets the data derived from the previous graph, and calls Session::on_switch.
void reset_derived(Session& session, GraphSwitch how);

// Returns false, with the reason in the status, if nothing was written; prompts for a name if there
// is none, and for a decision if the file on disk changed or cannot be written.
bool save_file(Session& session);
// Saves under another name and makes it the document's. Replaces an existing file unless it is
// read-only. In another folder, image and sub-graph names are updated in an undoable step; files
// that are not below it are copied or listed in the status.
bool save_file_as(Session& session, const std::filesystem::path& path,
                  OutsideFiles files = OutsideFiles::referred);
// Returns the document and its files for a graph at `path` (document/moved_paths.h).
MovedPaths moved_to(const Session& session, const std::filesystem::path& path, OutsideFiles files);
// Returns the files named by the document that are not below the folder of `path`, as named there.
std::vector<std::string> files_outside(const Session& session, const std::filesystem::path& path);

// Compares with the disk. Reads a changed file again, in an undoable step, if there are no unsaved
// edits; otherwise prompts which version to use.
void check_disk_changes(Session& session);
void reload_from_disk(Session& session);
void keep_local_version(Session& session);
// Prompts again when the user saves, or when the file changes again.
void decide_later(Session& session);

}  // namespace wrinkle::editor
