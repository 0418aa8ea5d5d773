// The document's file: opening, saving, noticing what other programs do to it. What a file holds
// that cannot be read whole is never written over, and nothing is written over that another program
// wrote meanwhile.
//
// These do at once what they say; intent.h asks about unsaved work first.
#pragma once

#include <filesystem>

#include "editor/document/moved_paths.h"
#include "editor/state.h"

namespace wrinkle::editor {

// An empty graph without a file, in `folder` if that is there, else in the working folder.
void new_file(State& state, const std::filesystem::path& folder = {});
// Opens a graph. A file that does not exist is a new graph under that name.
void open_file(State& state, const std::filesystem::path& path);
// The same inside the graphs that are open around it (levels.h).
void load_file(State& state, const std::filesystem::path& path);
// Another graph is on the canvas: gestures in the former one end, and nothing that was made of it
// is shown any more.
void let_go(State& state);

// False when nothing was written, and why in the status; asks for a name where there is none, and
// what to do where the file is no longer the one that was read, or cannot be written.
bool save_file(State& state);
// Writes under another name, which is the document's from then on. Replaces what is there, unless
// that is read-only. In another folder pictures and sub-graphs are named from there, as a step that
// can be undone; those that are not below it are copied, or named by the status.
bool save_file_as(State& state, const std::filesystem::path& path,
                  OutsideFiles files = OutsideFiles::referred);
// The files that the document names and that are not below the folder of `path`, as it names them.
std::vector<std::string> files_outside(const State& state, const std::filesystem::path& path);

// Compares with the disk now. A changed file is read again when nothing here is unsaved, as a step
// that can be undone; otherwise it is asked which one to keep.
void look_at_disk(State& state);
void load_theirs(State& state);
void keep_mine(State& state);

// Once a frame, and now and then while nothing is drawn: keeps the edits for recovery; at most once
// a second the settings and the disk. True when something is to be shown.
bool tend(State& state);
// At the start of the program, and before it ends.
void use_settings(State& state, const Settings& settings);
void finish(State& state);

}  // namespace wrinkle::editor
