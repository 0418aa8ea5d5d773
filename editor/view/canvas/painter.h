// State shared by the drawing functions of the canvas, for one frame.
#pragma once

#include <string_view>
#include <vector>

#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/magnified.h"
#include "editor/view/look/theme.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

class Painter {
public:
    Painter(const State& state, ImDrawList& list);

    const State& state;
    ImDrawList& list;
    const View& view;
    const float zoom;
    const bool details;  // zoom >= detail_zoom: fields are shown
    const bool plain;    // zoom < plain_zoom: cards are rectangles

    ImVec2 at(ImVec2 canvas) const { return origin_ + canvas * zoom; }
    bool sees(const Extent& box) const { return box.touches(seen_); }  // canvas units
    void text(ImVec2 at, const TextStyle& style, ImU32 color, std::string_view what) const {
        draw_magnified(list, state.fonts, style, zoom, at, color, what);
    }
    bool is_selected(size_t card) const {
        return view.selected.contains(state.layout.cards[card].id);
    }
    // The most severe diagnostic of a card; nullptr: none.
    const Diagnostic* issue(size_t card) const { return issues_.empty() ? nullptr : issues_[card]; }
    // The first diagnostic at a port of the card; nullptr: none.
    const Diagnostic* fault(const Card& card, std::string_view port) const;
    bool is_primary(const Card& card) const { return &card == primary_; }
    // Tracing: true if the card is not upstream or downstream of the selection.
    bool fades(size_t card) const { return !related_.empty() && !related_[card]; }
    bool fades_wire(size_t wire) const { return !related_.empty() && !related_wires_[wire]; }
    const Price* price(const Card& card) const;  // nullptr: unknown
    // Cost of a card relative to the most expensive one, 0 to 1: the larger of reads and ops.
    float heat(const Price& price) const;

private:
    void find_issues();
    void add_issue(const Diagnostic& problem);
    void find_related();
    void find_most_expensive();

    ImVec2 origin_;
    Extent seen_;
    std::vector<const Diagnostic*> issues_;      // by card; empty: none
    std::vector<bool> related_, related_wires_;  // by card, by wire; empty: nothing fades
    ShaderCost max_cost_;                        // maximum reads and maximum ops of any node
    const Card* primary_ = nullptr;              // the last selected card, if several are selected
};

// Multiplies the alpha of all vertices from index `first` on by 0.35.
void fade(ImDrawList& list, int first);

void draw_wires(const Painter& painter);
void draw_card(const Painter& painter, size_t index);
void draw_boxes(const Painter& painter);
void draw_reroute(const Painter& painter, size_t index);

}  // namespace wrinkle::editor
