// What the parts of the canvas's drawing share, for one frame.
#pragma once

#include <string_view>
#include <vector>

#include "editor/canvas/layout.h"
#include "editor/look/draw.h"
#include "editor/look/magnified.h"
#include "editor/look/theme.h"
#include "editor/state.h"

namespace wrinkle::editor {

// The worst that is wrong with a card; nullptr: nothing.
struct Trouble {
    const Diagnostic* worst = nullptr;
    bool error() const { return worst && worst->severity == Severity::error; }
};

class Painter {
public:
    Painter(const State& state, ImDrawList& list);

    const State& state;
    ImDrawList& list;
    const View& view;
    const float zoom;
    const bool details;  // zoomed in far enough for fields
    const bool plain;    // zoomed out so far that a card is a rectangle

    ImVec2 at(ImVec2 canvas) const { return origin_ + canvas * zoom; }
    bool sees(const Extent& box) const { return box.touches(seen_); }  // canvas units
    void text(ImVec2 at, const TextStyle& style, ImU32 color, std::string_view what) const {
        draw_magnified(list, state.fonts, style, zoom, at, color, what);
    }
    bool is_selected(size_t card) const { return !selected_.empty() && selected_[card]; }
    Trouble trouble(size_t card) const { return troubles_.empty() ? Trouble{} : troubles_[card]; }
    // What is wrong at a port of a card that has troubles.
    const Diagnostic* fault(const Card& card, std::string_view port) const;
    bool is_primary(const Card& card) const { return &card == primary_; }
    // While tracing: on no way through the selection.
    bool fades(size_t card) const { return !related_.empty() && !related_[card]; }
    bool fades_wire(size_t wire) const { return !related_.empty() && !related_wires_[wire]; }
    const Price* price(const Card& card) const;  // nullptr: not known
    // How dear a card is beside the dearest, 0 to 1: by its reads or by its ops.
    float heat(const Price& price) const;

private:
    void find_selected();
    void find_troubles();
    void blame(const Diagnostic& problem);
    void find_related();
    void find_dearest();

    ImVec2 origin_;
    Extent seen_;
    std::vector<bool> selected_;                 // by card; empty: none
    std::vector<Trouble> troubles_;              // by card; empty: none
    std::vector<bool> related_, related_wires_;  // by card, by wire; empty: nothing fades
    ShaderCost dearest_;                         // the most reads and the most ops of a card
    const Card* primary_ = nullptr;              // of several that are selected the one chosen last
};

// What was drawn since `first` (a count of vertices) at 35 %.
void fade(ImDrawList& list, int first);

void draw_wires(const Painter& painter);
void draw_card(const Painter& painter, size_t index);
void draw_boxes(const Painter& painter);
void draw_reroute(const Painter& painter, size_t index);

}  // namespace wrinkle::editor
