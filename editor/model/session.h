// The open graph and all data derived from it without a window: history and file, parent graphs,
// files that it uses, results of compilation, and background work.
//
// The document is a snapshot in `history`. `model` and `built` are derived from it and updated by
// refresh() (view/refresh.h).
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "editor/model/code/code.h"
#include "editor/model/document/compiler.h"
#include "editor/model/document/history.h"
#include "editor/model/document/intent.h"
#include "editor/model/document/model.h"
#include "editor/model/document/plugins.h"
#include "editor/model/document/recovery.h"
#include "editor/model/document/recovery_file.h"
#include "editor/model/document/used_files.h"
#include "editor/model/document/watch.h"
#include "editor/model/document/wiring.h"
#include "editor/model/hosts/host_choices.h"
#include "editor/model/images/images.h"
#include "editor/model/tasks/task.h"

namespace wrinkle::editor {

// Returns the name without folder, "strap.json"; "untitled.json" if `path` is empty.
std::string file_name_of(const std::filesystem::path& path);

struct Counters {
    uint64_t builds = 0;    // compilations received
    uint64_t uniforms = 0;  // values sent to the running material
    uint64_t programs = 0;  // linked for the preview
};

// A graph with its undo history and its file.
struct OpenGraph {
    std::filesystem::path path;
    History history;
    static constexpr uint64_t never_saved = ~uint64_t{0};
    uint64_t saved_serial = 0;
    std::string save_refused;  // why the file must not be overwritten; "": it may be
    DiskCopy disk;
    Stamp postponed;  // of a change by another program that the user decides on later
    RecoveryFile recovery_file;
    uint64_t recovery_serial = 0;  // serial of the state in the recovery file, if there is one
    RepeatedExports repeated_exports;

    const Document& document() const { return history.now(); }
    bool dirty() const { return history.serial() != saved_serial; }
};

// The most recent copy: its clipboard text and the data that the text does not contain.
struct Clip {
    std::string text;                // as put on the clipboard
    std::filesystem::path document;  // path of the source document
    std::vector<Connection> outer;   // wires into the copied nodes that are not in the text
};

// How another graph became the current one.
enum class GraphSwitch : uint8_t {
    opened,   // without parent graphs
    entered,  // as a sub-graph; the previous one is the last parent graph
    left,     // a parent graph again; the inner ones are closed
};

// The base is the current graph.
struct Session : OpenGraph {
    const Registry* registry = nullptr;
    Plugins plugins;
    UsedFiles used;
    Images images;
    std::filesystem::path unsaved_folder;  // for a graph without a file; "": working folder
    std::vector<OpenGraph> parent_graphs;  // outermost first
    Persistence keeping;
    Question question;
    bool quit = false;
    Code code;
    Clip clip;
    Tasks tasks;
    std::string status;  // result of the last action, or the reason for its failure

    Model model;
    Build built;
    CompileState follow;
    bool is_synced = false;  // false: refresh() rebuilds the model and requests a build
    Counters counters;

    // Called after another graph became the current one; the view shows it.
    std::function<void(GraphSwitch)> on_switch;

    bool building() const { return built.version < follow.requested_version; }
    // Returns the last counted costs of this file, else those of the newest build; nullptr if it
    // has no costs, no generated source or no build yet.
    const Costs* costs() const;
    // Folder that file names in the document are relative to: absolute, links resolved, as in
    // load_project(). For a graph without a file it is `unsaved_folder`.
    std::filesystem::path folder() const;
    std::filesystem::path root() const;  // files outside it are rejected
    std::string title() const;           // window title
    std::string file_name() const { return file_name_of(path); }
    const NodeType* type_of(std::string_view node) const { return model.type_of(node); }

    // If the document changed, adds a step to the history and sets the status to its name. A step
    // is merged into the previous one if both have the same non-empty `merge`.
    void commit(std::string name, Document document, const std::string& merge = {});
};

}  // namespace wrinkle::editor
