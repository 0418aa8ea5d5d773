// Where cards stand: those without a place, all of them when the graph is tidied, and a new one.
#include <algorithm>
#include <cmath>

#include "editor/canvas/layout.h"
#include "editor/look/draw.h"
#include "graph/edit.h"
#include "graph/order.h"

namespace wrinkle::editor {
namespace {

// Depth in wires from the first nodes.
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

// The depth as a column; nodes of one column below each other.
std::vector<ImVec2> automatic_places(const Document& document) {
    std::vector<float> next;
    std::vector<ImVec2> places;
    const auto depth = depths(document);
    for (size_t i = 0; i < depth.size(); ++i) {
        if (next.size() <= depth[i]) next.resize(depth[i] + 1, 0);
        places.push_back({static_cast<float>(depth[i]) * 256, next[depth[i]]});
        next[depth[i]] +=
            72 + row_height * static_cast<float>(document.nodes[i]->inputs.size() + 2);
    }
    return places;
}

}  // namespace

std::vector<ImVec2> places_of(const Document& document, bool* all_given) {
    std::vector<ImVec2> places;
    std::vector<size_t> without;
    for (size_t i = 0; i < document.nodes.size(); ++i) {
        const Position* at = document.positions.find(document.nodes[i]->id);
        places.push_back(at ? ImVec2(static_cast<float>(at->x), static_cast<float>(at->y))
                            : ImVec2(0, 0));
        if (!at) without.push_back(i);
    }
    if (all_given) *all_given = without.empty();
    if (without.empty()) return places;
    const std::vector<ImVec2> automatic = automatic_places(document);
    for (const size_t i : without)
        places[i] = automatic[i];
    return places;
}

Document tidied(const State& state) {
    const Document& document = state.document();
    const auto depth = depths(document);
    std::vector<float> next(document.nodes.size(), 0), width(document.nodes.size(), 0);
    std::vector<ImVec2> size(document.nodes.size(), ImVec2(0, 0));
    for (const Card& card : state.layout.cards)
        if (card.kind == Card::Kind::node) {
            const size_t i = document.nodes.index_of(card.id);
            size[i] = card.size;
            width[depth[i]] = std::max(width[depth[i]], card.size.x);
        }
    std::vector<float> left(document.nodes.size() + 1, 0);
    for (size_t i = 0; i < width.size(); ++i)
        left[i + 1] = left[i] + std::ceil(width[i] / 8) * 8 + 64;
    std::vector<NodePosition> places;
    for (size_t i = 0; i < depth.size(); ++i) {
        places.push_back({document.nodes[i]->id, left[depth[i]], next[depth[i]]});
        next[depth[i]] += std::ceil(size[i].y / 8) * 8 + 32;
    }
    return move_nodes(document, places);
}

ImVec2 free_place(const Layout& layout, ImVec2 at) {
    at = {std::round(at.x / 8) * 8, std::round(at.y / 8) * 8};
    const auto covered = [&] {
        return std::any_of(layout.cards.begin(), layout.cards.end(), [&](const Card& card) {
            return std::fabs(card.at.x - at.x) < 24 && std::fabs(card.at.y - at.y) < 24;
        });
    };
    while (covered())
        at = at + ImVec2(32, 32);
    return at;
}

}  // namespace wrinkle::editor
