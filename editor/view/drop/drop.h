// Handles files dropped on the window, by their type and the target.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

// Called at the end of a frame, when all widgets on screen are registered by name.
//
//   an image on empty canvas      a source node; shown if the graph has no output `normal` yet
//   an image on a wire            its bump is added to the one on the wire
//   an image on a node with one   replaces the node's image
//   an HDR image on the preview   becomes its environment
//   a mesh, anywhere              becomes the preview's mesh
//   a graph                       is opened; below the folder of an open graph that has nodes, a
//                                 dialog offers to use it as a node instead
//   a preset file                 becomes a preset of the graph, and is chosen
//   a folder                      its textures become a new graph (document/texture_import.h)
//
// The second of several images is layered over the first. An image outside the graph's folder must
// be copied into it to be read, which a dialog offers. A graph without a file that names no other
// file can adopt the folder of such images instead, so that they are read at their location.
void handle_drops(State& state);

// Returns the path as written in the graph; "" for a file outside its folder.
std::string path_in_graph(const Session& session, const std::filesystem::path& file);

// Returns the folder for new images: the graph's `textures` folder if it exists, else the graph's
// folder.
std::filesystem::path image_folder(const Session& session);

// Adds images of the graph's folder at the drop position.
void add_images(State& state, const FileDrop& drop, const std::vector<std::string>& files);

// Handles a dropped graph, the first file of `drop`.
void take_graph(State& state, const FileDrop& drop);

// Adds an image chosen by name, a path as written in the graph: layered over the selected wire or
// over the bump that the output `normal` shows, else as a source on empty canvas.
void add_image(State& state, const std::string& file);

// Sets an image from anywhere on a node, "" for a new one; prompts if it is outside the graph's
// folder.
void use_image(State& state, const std::string& node, const std::string& port,
               const std::string& file);

}  // namespace wrinkle::editor
