// How the document is looked at: never saved in the graph, never undone.
#pragma once

#include <imgui.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/canvas/box_id.h"
#include "editor/preview/preview.h"
#include "editor/preview/request.h"
#include "graph/document.h"

namespace wrinkle::editor {

struct View {
    ImVec2 pan{0, 0};  // screen pixels from the canvas's corner to the canvas origin
    float zoom = 1;
    bool fitted = false;
    ImVec2 corner{0, 0}, extent{0, 0};  // the canvas on the screen
    std::set<std::string> selected;
    std::set<BoxId> boxes;           // selected frames and notes
    std::vector<std::string> order;  // raised nodes, the topmost last
    // Where the cards at the borders stand, once they have been put somewhere; canvas units.
    std::optional<ImVec2> surface_at, outputs_at;
    std::optional<Link> selected_wire;  // by its reading end; node "" is an output of the graph
    std::set<std::string> reveal;       // new nodes that the next frame brings in sight
    // A step of the history that moved the cards at the borders: from where to where.
    struct Borders {
        std::optional<ImVec2> surface, outputs;
    };
    struct Push {
        uint64_t serial = 0;  // of the state after it
        Borders from, to;
    };
    std::vector<Push> pushes;
    bool all_surface = false, all_outputs = false;
    bool pictures = true;          // of what nodes make, on their cards (canvas/make_card.h)
    std::set<std::string> turned;  // nodes whose picture is not as is usual for their type
    bool tracing = false;          // what is not on a way through the selection fades
    bool heat = false;             // costs are tinted
    PreviewView preview_view;
    CompareView compare;
    // `against` counts while something is compared.
    PreviewRequest preview_request{"", Against::blend, "udn", false};
};

}  // namespace wrinkle::editor
