// Exports the document to a host (export/export.h): the files of `wrinkle export`, byte for byte.
// The work uses a snapshot, in the background.
#pragma once

#include <filesystem>
#include <string>

#include "editor/model/session.h"
#include "export/export.h"

namespace wrinkle::editor {

inline constexpr uint32_t host_sizes[] = {256, 512, 1024, 2048, 4096, max_export_size};

struct HostChoices {
    const Host* host = &hosts().front();
    std::string mesh;    // a shape's name, or the path of an OBJ or glTF file
    std::string preset;  // name in the graph; "": the defaults of its inputs
    uint32_t size = 1024;
    std::filesystem::path into;  // a folder
};

struct HostJob {
    Model model;
    Document document;
    std::string graph;  // path of its file, for problems
    HostChoices choices;
};
TaskOutcome export_to_host(const HostJob& job, const Registry& registry, TaskProgress& progress);

// Exports the current document as a task.
void start_host_export(Session& session, const HostChoices& choices);

// Returns the folder that is proposed for a host, next to the graph: "strap_three".
std::filesystem::path usual_folder(const Session& session, const Host& host);

// Returns choices.into as a path on disk: relative to the graph's folder; "~" is the home folder.
std::filesystem::path place_of(const Session& session, const HostChoices& choices);

}  // namespace wrinkle::editor
