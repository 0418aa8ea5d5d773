// Complete state of the editor: the sum of its parts. A panel is a free function that takes the
// part that it uses, or all of them.
//
// Only the session has the document (model/session.h). The other parts are not saved in the graph
// and not undoable.
#pragma once

#include <vector>

#include "editor/model/session.h"
#include "editor/view/canvas/card.h"
#include "editor/view/canvas/gesture.h"
#include "editor/view/drop/drop_state.h"
#include "editor/view/input/targets.h"
#include "editor/view/look/fonts.h"
#include "editor/view/look/look.h"
#include "editor/view/look/thumbnails.h"
#include "editor/view/panels/open.h"
#include "editor/view/panels/regions.h"
#include "editor/view/preview/graph_images.h"
#include "editor/view/preview/node_feed.h"
#include "editor/view/preview/play.h"
#include "editor/view/timings.h"
#include "editor/view/view.h"

namespace wrinkle::editor {

struct CanvasState {
    View view;
    std::vector<View> parent_views;  // same order as Session::parent_graphs
    Gesture gesture;
    Hit hovered;
    Layout layout;
    Document layout_of;
    bool layout_stale = true;
};

// Popups and dialogs, and data that panels store between frames.
struct Dialogs {
    Palette palette;
    Popup popup;
    ContextMenu context_menu;
    Recent recent;
    Browser browser;
    BakeDialog bake_dialog;
    HostDialog host_dialog;
    Start start;
    Help help;
    InputsPanel inputs_panel;
    Problems problems;
    DropState dropped;
    Offer offer;
    BoxText box_text;
    Eyedropper eyedropper;
    int field_wait = 0;        // frames left in which typing waits for a field (panels/panels.h)
    bool value_held = false;   // a control of a value was held down in the last frame
    bool holds_value = false;  // the same of the frame being drawn
};

// Used by every panel to draw.
struct Interface {
    Fonts fonts;
    Look look;
    Panes panes;
    Thumbnails thumbnails;
    GraphImages graph_images;
    Targets targets;
};

struct PreviewState {
    Preview* preview = nullptr;    // nullptr without GL
    Diagnostics preview_problems;  // reported by the newest rendering
    bool preview_stale = false;    // the rendering shows an older graph
    NodeFeed node_feed;
    FlatFeed flat;
    Play play;
    Timings* timings = nullptr;  // nullptr: not measured
};

struct State : Session, CanvasState, Dialogs, Interface, PreviewState {
    State();
    State(const State&) = delete;  // the session refers to it
    State& operator=(const State&) = delete;
};

}  // namespace wrinkle::editor
