// Connects document and preview: sends programs and values, and collects the preview's problems.
#pragma once

#include "editor/model/document/change.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

// Returns the preview request for the current document. Without outputs it is of the selected node.
PreviewRequest wanted_request(const State& state);

// Returns true if the requests are equal, or differ in their presets.
bool differ_in_preset_only(PreviewRequest a, const PreviewRequest& b);

// Files of that use are read again, for the preview and for node previews.
void forget_files(PreviewState& state, Use use);

// Called after a build: replaces the program only if more than names and values differ.
void apply_latest_build(State& state);
// Sends the values that differ from those in the preview, also those of another preset; returns
// false if one is not a uniform.
bool send_values(State& state);
// Returns true if the running program reads the input of the graph.
bool reads_input(const CompileState& follow, const std::string& input);
// Sends the number, or without one the value of the shown preset, to the uniform of the input, a
// float. Precondition: reads_input().
void send_number(State& state, const std::string& input, std::optional<double> number);
// Updates the node ids in the request after a renaming.
void rename_in_request(State& state, const Document& before);

// Collects the problems of the newest preview; maps a driver's errors to nodes by their source
// lines.
void poll_preview_diagnostics(State& state);

// Returns the output with the other normal of the running program; "" if nothing is compared.
std::string other_normal(const State& state);

// Maps a driver's error to a node: the first line number in its message is looked up in the
// reflection; without a line number the error is returned unchanged.
Diagnostic at_node(const Diagnostic& refusal, const Reflection& reflection,
                   const std::map<std::string, std::string>& copied);

}  // namespace wrinkle::editor
