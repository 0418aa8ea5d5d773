// View state of a document: not saved in the graph, not undoable.
#pragma once

#include <imgui.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/model/document/boxes.h"
#include "editor/model/document/request.h"
#include "editor/view/preview/flat.h"
#include "editor/view/preview/preview.h"
#include "graph/document.h"

namespace wrinkle::editor {

// Positions of the border cards in canvas units; std::nullopt: not placed yet.
struct Borders {
    std::optional<ImVec2> surface_at, outputs_at;
};

struct View : Borders {
    ImVec2 pan{0, 0};  // from the canvas's corner to the canvas origin, screen pixels
    float zoom = 1;
    bool fitted = false;
    ImVec2 corner{0, 0}, extent{0, 0};  // canvas rectangle, screen pixels
    std::set<std::string> selected;
    std::set<BoxId> boxes;              // selected frames and notes
    std::vector<std::string> order;     // raised cards, topmost last
    std::optional<Link> selected_wire;  // by its input end; node "": an output of the graph
    std::set<std::string> reveal;       // new nodes; the next frame scrolls to them
    // Positions of the border cards before and after a history step that moved them.
    struct Push {
        uint64_t serial = 0;  // serial of the state after the step
        Borders from, to;
    };
    std::vector<Push> pushes;
    bool all_surface = false, all_outputs = false;
    std::set<std::string> unfolded;  // nodes with all ports shown (canvas/make_card.h)
    bool node_previews = true;       // node previews on the cards (canvas/make_card.h)
    std::set<std::string> turned;    // nodes with preview visibility opposite to the default
    bool tracing = false;            // dims cards not up- or downstream of the selection
    bool heat = false;               // tints cards by cost
    PreviewView preview_view;
    FlatView flat;
    CompareView compare;
    // `against` is ignored while `compare` is off.
    PreviewRequest preview_request{"", Against::blend, "udn", false};
};

}  // namespace wrinkle::editor
