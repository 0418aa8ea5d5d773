// Bakes maps of the document on a mesh's uv layout: the files of `wrinkle bake`, byte for byte. The
// work uses a snapshot, in the background, on all cores.
#pragma once

#include "editor/model/bake/choices.h"
#include "editor/model/session.h"

namespace wrinkle::editor {

struct BakeJob {
    Model model;
    Document document;
    std::string graph;  // path of its file, for problems
    BakeChoices choices;
};

// Files are renamed from temporary files when all are complete; on failure or cancellation before
// that, no file appears and folders made for them are removed. Warnings: faults of the mesh and its
// uvs, numbers that are not finite or were clamped.
TaskOutcome bake_maps(const BakeJob& job, const Registry& registry, TaskProgress& progress);

// Bakes the current document as a task; stores the choices in the settings.
void start_bake(Session& session, const BakeChoices& choices);

// Returns choices.into as a path on disk: relative to the graph's folder; "~" is the home folder.
std::filesystem::path output_folder(const Session& session, const BakeChoices& choices);

// Returns the maps that the document's outputs provide.
std::vector<std::string> maps_of(const Document& document);
// Returns the initial choices of the dialog: the last ones, with the maps that exist, on a mesh,
// next to the graph.
BakeChoices usual_bake(const Session& session, const std::string& mesh);

// Returns the reason why no map can be baked, "" if some can.
std::string_view no_maps(const Session& session);

}  // namespace wrinkle::editor
