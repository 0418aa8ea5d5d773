// Exports the document to a host (export/export.h): the files of `wrinkle export`, byte for byte.
// The work uses a snapshot, in the background.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "editor/model/hosts/host_choices.h"
#include "editor/model/session.h"

namespace wrinkle::editor {

// The document has the values of the preset as defaults (with_preset_as_defaults()), and
// `choices.into` is absolute (output_folder()).
struct HostJob {
    Model model;
    Document document;
    std::string graph;  // path of its file, for problems
    HostChoices choices;
};
// Exports on this thread.
TaskOutcome export_to_host(const HostJob& job, const Registry& registry, TaskProgress& progress);

// Exports the current document as a task; `then` is called after success. While another task runs
// it only sets the status.
void start_host_export(Session& session, const HostChoices& choices,
                       const std::function<void(Session&)>& then = {});

// Returns the folder that is proposed for a host, next to the graph: "strap_three".
std::filesystem::path usual_folder(const Session& session, const Host& host);

// Returns choices.into as a path on disk: relative to the graph's folder; "~" is the home folder.
std::filesystem::path output_folder(const Session& session, const HostChoices& choices);

}  // namespace wrinkle::editor
