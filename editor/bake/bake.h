// Maps of the document on a mesh's uv layout: the files of `wrinkle bake`, byte for byte. The work
// is done on a snapshot, in the background, on all cores.
#pragma once

#include "editor/bake/choices.h"
#include "editor/state.h"

namespace wrinkle::editor {

struct BakeJob {
    Model model;
    Document document;
    std::string graph;  // its file, as problems name it
    BakeChoices choices;
};

// All files appear when all of them are whole; where it fails or is cancelled nothing does, and no
// folder that was made for them stays. What is to be known of the mesh and of the numbers comes
// out as warnings.
TaskOutcome bake_maps(const BakeJob& job, const Registry& registry, TaskProgress& progress);

// The same of the document as it is now, as a task; the choices become the settings.
void start_bake(State& state, const BakeChoices& choices);

// Where they go on the disk: relative paths begin beside the graph, "~" at home.
std::filesystem::path place_of(const State& state, const BakeChoices& choices);

// The maps that the document's outputs give.
std::vector<std::string> maps_of(const Document& document);
// What a dialog begins with: the last choices, those of the maps that there are, on the preview's
// mesh, beside the graph.
BakeChoices usual_bake(const State& state);

// Why no map can be made, "" when some can.
std::string_view no_maps(const State& state);

}  // namespace wrinkle::editor
