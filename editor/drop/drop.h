// Files dropped on the window, by what they are and where they fall:
//
//   a picture on empty ground     a source node; shown when the graph has no output `normal` yet
//   a picture on a wire           its bump is laid over the one on the wire
//   a picture on a node with one  replaces the picture that it reads
//   a mesh, or an HDR picture on the preview   for the preview
//   a graph                       is opened
//
// The second of several pictures is laid over the first. A picture outside the graph's folder can
// only be read after it was copied into it, which is offered. A graph without a file that names no
// other file can have the folder of such pictures instead, so that they are read where they are.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

// At the end of a frame, when everything on the screen has its name.
void handle_drops(State& state);

// As the graph writes it; "" for a file outside its folder.
std::string path_in_graph(const State& state, const std::filesystem::path& file);

// Pictures of the graph's folder, at the place of the drop.
void add_pictures(State& state, const FileDrop& drop, const std::vector<std::string>& files);

// A picture chosen by name, a path as the graph writes it: laid over the selected wire or over what
// the output `normal` shows, else a source on empty ground.
void add_picture(State& state, const std::string& file);

// A picture from anywhere for a node, "" for a new one; asks about one outside the graph's folder.
void use_picture(State& state, const std::string& node, const std::string& port,
                 const std::string& file);

// The question whether files from elsewhere are to be copied into the graph's folder, or the graph
// is to have theirs.
void draw_copy_question(State& state);

}  // namespace wrinkle::editor
