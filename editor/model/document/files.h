// The document's file: opens, saves, and detects changes by other programs. A file that could not
// be read completely is never overwritten, and neither is a version that another program wrote
// meanwhile.
//
// These functions act at once; intent.h prompts for unsaved work first.
#pragma once

#include <filesystem>

#include "editor/model/document/moved_paths.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

// Creates an empty graph without a file, in `folder` if it exists, else in the working folder.
void new_file(State& state, const std::filesystem::path& folder = {});
// Opens a graph. If the file does not exist, the graph is new under that name.
void open_file(State& state, const std::filesystem::path& path);
// Opens a graph without closing its parent graphs (levels.h).
void load_file(State& state, const std::filesystem::path& path);
// Resets all interaction and derived state when another graph is on the canvas: gestures, popups,
// build and previews.
void reset_interaction(State& state);

// Returns false, with the reason in the status, if nothing was written; prompts for a name if there
// is none, and for a decision if the file on disk changed or cannot be written.
bool save_file(State& state);
// Saves under another name and makes it the document's. Replaces an existing file unless it is
// read-only. In another folder, image and sub-graph names are updated in an undoable step; files
// that are not below it are copied or listed in the status.
bool save_file_as(State& state, const std::filesystem::path& path,
                  OutsideFiles files = OutsideFiles::referred);
// Returns the files named by the document that are not below the folder of `path`, as named there.
std::vector<std::string> files_outside(const State& state, const std::filesystem::path& path);

// Compares with the disk. Reads a changed file again, in an undoable step, if there are no unsaved
// edits; otherwise prompts which version to use.
void check_disk_changes(State& state);
void reload_from_disk(State& state);
void keep_local_version(State& state);

// Called once a frame, and occasionally while nothing is drawn: journals the edits; at most once a
// second, writes the settings and checks the disk. Returns true if the window must be redrawn.
bool tend(State& state);
// Called at the start and before the end of the program.
void use_settings(State& state, const Settings& settings);
void finish(State& state);

}  // namespace wrinkle::editor
