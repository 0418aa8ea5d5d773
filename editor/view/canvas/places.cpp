// Positions of cards without one in the document.
#include <algorithm>
#include <cmath>

#include "editor/view/canvas/columns.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"
#include "graph/order.h"

namespace wrinkle::editor {
namespace {

// Returns the length in links of the longest path to each node, by index.
std::vector<size_t> depths(const Document& document) {
    std::vector<size_t> depth(document.nodes.size(), 0);
    std::vector<bool> done(document.nodes.size(), false);
    for (const uint32_t index : evaluation_order(document)) {
        for (const Input& input : document.nodes[index]->inputs) {
            if (input.kind != Input::Kind::link || !input.link.is_node()) continue;
            const size_t from = document.nodes.index_of(input.link.node);
            if (from != Table<NodePtr>::npos && done[from])
                depth[index] = std::max(depth[index], depth[from] + 1);
        }
        done[index] = true;
    }
    return depth;
}

// Columns by depth, each as wide as its widest card; the nodes of a column are stacked from
// `corner` down. A column without nodes has no width.
class Columns {
public:
    Columns(const Document& document, const std::vector<ImVec2>& sizes,
            const std::vector<size_t>& nodes, ImVec2 corner)
        : depth_(depths(document)), left_(depth_.size() + 1, 0), next_(depth_.size(), corner.y) {
        std::vector<float> width(depth_.size(), 0);
        for (const size_t i : nodes)
            width[depth_[i]] = std::max(width[depth_[i]], sizes[i].x);
        left_[0] = corner.x;
        for (size_t i = 0; i < width.size(); ++i)
            left_[i + 1] = left_[i] + (width[i] > 0 ? grid_up(width[i]) + column_gap : 0);
    }

    ImVec2 take(size_t node, ImVec2 size) {
        const size_t column = depth_[node];
        const ImVec2 at(left_[column], next_[column]);
        next_[column] += grid_up(size.y) + row_gap;
        return at;
    }

private:
    std::vector<size_t> depth_;
    std::vector<float> left_, next_;
};

}  // namespace

std::vector<ImVec2> places_of(const Document& document, const std::vector<ImVec2>& sizes) {
    std::vector<ImVec2> places;
    std::vector<size_t> without;
    ImVec2 corner(0, 0);
    for (size_t i = 0; i < document.nodes.size(); ++i) {
        const Position* at = document.positions.find(document.nodes[i]->id);
        const ImVec2 place =
            at ? ImVec2(static_cast<float>(at->x), static_cast<float>(at->y)) : ImVec2(0, 0);
        if (!at) without.push_back(i);
        const bool first = at && places.size() == without.size();
        if (at) corner.x = first ? place.x : std::min(corner.x, place.x);
        if (at) corner.y = std::max(first ? place.y : corner.y, place.y + sizes[i].y + row_gap);
        places.push_back(place);
    }
    if (without.empty()) return places;
    Columns columns(document, sizes, without, {corner.x, grid_up(corner.y)});
    for (const size_t i : without)
        places[i] = columns.take(i, sizes[i]);
    return places;
}

}  // namespace wrinkle::editor
