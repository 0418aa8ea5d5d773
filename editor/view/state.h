// Complete state of the editor. Panels are free functions that take it.
//
// The document is a snapshot in `history`. All other data is view state (not saved in the graph,
// not undoable) or derived from the document (`model`, `built`) and updated by refresh()
// (document/refresh.h).
#pragma once

#include <filesystem>
#include <string>

#include "editor/model/code/code.h"
#include "editor/model/document/clip.h"
#include "editor/model/document/compile_state.h"
#include "editor/model/document/history.h"
#include "editor/model/document/intent.h"
#include "editor/model/document/level.h"
#include "editor/model/document/model.h"
#include "editor/model/document/persistence.h"
#include "editor/model/document/plugins.h"
#include "editor/model/document/used_files.h"
#include "editor/model/images/images.h"
#include "editor/model/tasks/task.h"
#include "editor/view/canvas/card.h"
#include "editor/view/canvas/gesture.h"
#include "editor/view/drop/dropped.h"
#include "editor/view/input/targets.h"
#include "editor/view/look/fonts.h"
#include "editor/view/look/look.h"
#include "editor/view/look/thumbnails.h"
#include "editor/view/panels/open.h"
#include "editor/view/panels/panes.h"
#include "editor/view/preview/node_feed.h"
#include "editor/view/timings.h"
#include "editor/view/view.h"

namespace wrinkle::editor {

// Returns the name without folder, "strap.json"; "untitled.json" if `path` is empty.
std::string file_name_of(const std::filesystem::path& path);

struct Counters {
    uint64_t builds = 0;    // compilations received
    uint64_t uniforms = 0;  // values sent to the running material
    uint64_t programs = 0;  // linked for the preview
};

struct State {
    const Registry* registry = nullptr;
    Plugins plugins;
    UsedFiles used;
    Images images;
    Fonts fonts;
    Look look;
    History history;
    std::filesystem::path path;
    std::filesystem::path unsaved_folder;  // for a graph without a file; "": working folder
    std::vector<Level> outer;              // parent graphs, outermost first
    static constexpr uint64_t never_saved = ~uint64_t{0};
    uint64_t saved_serial = 0;
    std::string save_refused;  // why the file must not be overwritten; "": it may be
    Persistence keeping;
    Question question;
    bool quit = false;

    View view;
    Panes panes;
    Gesture gesture;
    Hit hovered;
    Palette palette;
    Popup popup;
    Recent recent;
    Browser browser;
    BakeDialog bake_dialog;
    Start start;
    Thumbnails thumbnails;
    Help help;
    Problems problems;
    Dropped dropped;
    Code code;
    Clip clip;
    Offer offer;
    BoxText box_text;
    Tasks tasks;
    int field_wait = 0;  // frames left in which typing waits for a field (panels/fields.h)
    std::string status;  // result of the last action, or the reason for its failure

    Model model;
    Build built;
    CompileState follow;
    bool fresh = false;  // false: refresh() rebuilds the model and requests a build
    Layout layout;
    Document layout_of;
    bool layout_stale = true;

    Preview* preview = nullptr;    // nullptr without GL
    Diagnostics preview_problems;  // reported by the newest rendering
    bool preview_stale = false;    // the rendering shows an older graph
    NodeFeed node_feed;
    Counters counters;
    Timings* timings = nullptr;  // nullptr: not measured
    Targets targets;

    const Document& document() const { return history.now(); }
    // Returns the last counted costs of this file, else those of the newest build; nullptr if it
    // has no costs, no generated source or no build yet. Costs::nodes refers to costs_of().
    const Costs* costs() const;
    const Document& costs_of() const;
    bool dirty() const { return history.serial() != saved_serial; }
    // Folder that file names in the document are relative to: absolute, links resolved, as in
    // load_project(). For a graph without a file it is `unsaved_folder`.
    std::filesystem::path folder() const;
    std::filesystem::path root() const;  // files outside it are rejected
    std::string title() const;           // window title
    std::string file_name() const;       // file_name_of(path)
    const NodeType* type_of(std::string_view node) const { return model.type_of(node); }

    // If the document changed, adds a step to the history and sets the status to its name. A step
    // is merged into the previous one if both have the same non-empty `merge`.
    void commit(std::string name, Document document, const std::string& merge = {});
};

}  // namespace wrinkle::editor
