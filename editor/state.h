// All that the editor knows. Panels are free functions over it.
//
// The document is a snapshot in `history`; everything else is view (never saved in the graph, never
// undone) or follows from the document (`model`, `built`), brought up to date by refresh()
// (document/refresh.h).
#pragma once

#include <filesystem>
#include <string>

#include "editor/canvas/card.h"
#include "editor/canvas/gesture.h"
#include "editor/code/code.h"
#include "editor/document/clip.h"
#include "editor/document/follow.h"
#include "editor/document/history.h"
#include "editor/document/intent.h"
#include "editor/document/keeping.h"
#include "editor/document/level.h"
#include "editor/document/model.h"
#include "editor/document/plugins.h"
#include "editor/document/used_files.h"
#include "editor/drop/dropped.h"
#include "editor/images/images.h"
#include "editor/input/targets.h"
#include "editor/look/fonts.h"
#include "editor/look/look.h"
#include "editor/look/thumbnails.h"
#include "editor/panels/open.h"
#include "editor/panels/panes.h"
#include "editor/preview/node_feed.h"
#include "editor/tasks/task.h"
#include "editor/timings.h"
#include "editor/view.h"

namespace wrinkle::editor {

// "strap.json"; "untitled.json" where there is no file yet.
std::string file_name_of(const std::filesystem::path& path);

struct Counters {
    uint64_t builds = 0;    // texts generated
    uint64_t uniforms = 0;  // values sent to the running material
    uint64_t programs = 0;  // built for the preview
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
    std::filesystem::path unsaved_folder;  // of a graph without a file; "": the working folder
    std::vector<Level> outer;  // the graphs that this one was opened from, the outermost first
    static constexpr uint64_t never_saved = ~uint64_t{0};
    uint64_t saved_serial = 0;
    std::string save_refused;  // why this file is not written: what reading it would lose
    Keeping keeping;
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
    int field_wait = 0;  // frames that typing may still wait for a field (panels/fields.h)
    std::string status;  // what the last action did, or why it was refused

    Model model;
    Build built;
    Follow follow;
    bool fresh = false;  // model and build exist
    Layout layout;
    Document layout_of;
    bool layout_stale = true;

    Preview* preview = nullptr;    // nullptr without GL
    Diagnostics preview_problems;  // of the newest picture
    bool preview_stale = false;    // the picture is of a former graph
    NodeFeed node_feed;
    Counters counters;
    Timings* timings = nullptr;  // somebody measures
    Targets targets;

    const Document& document() const { return history.now(); }
    // What is known of the newest text's costs, and the document whose nodes they are of; nullptr:
    // there is no text, or none of this file yet.
    const Costs* costs() const;
    const Document& costs_of() const;
    bool dirty() const { return history.serial() != saved_serial; }
    // The folder that the document's files are named from: absolute, links resolved, as
    // load_project() has it. That of a graph without a file is `unsaved_folder`.
    std::filesystem::path folder() const;
    std::filesystem::path root() const;  // no name leads out of it
    std::string title() const;           // of the window
    std::string file_name() const;       // of `path`, by file_name_of()
    const NodeType* type_of(std::string_view node) const { return model.type_of(node); }

    // One step of history; says so in the status.
    void commit(std::string name, Document document, const std::string& merge = {});
};

}  // namespace wrinkle::editor
