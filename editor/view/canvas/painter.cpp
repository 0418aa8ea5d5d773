#include "editor/view/canvas/painter.h"

#include <algorithm>

namespace wrinkle::editor {

Painter::Painter(const State& state, ImDrawList& list)
    : state(state),
      list(list),
      view(state.view),
      zoom(state.view.zoom),
      details(zoom >= detail_zoom),
      plain(zoom < plain_zoom),
      origin_(to_screen(state.view, {0, 0})),
      seen_{to_canvas(state.view, view.corner), to_canvas(state.view, view.corner + view.extent)} {
    if (view.selected.size() > 1 && !view.order.empty())
        primary_ = state.layout.find(view.order.back());
    find_issues();
    if (view.tracing && !view.selected.empty()) find_related();
    if (view.heat && state.costs()) find_most_expensive();
}

void Painter::find_issues() {
    for (const Diagnostic& problem : state.built.problems.list())
        add_issue(problem);
    for (const ImageWarning& remark : state.images.remarks)
        add_issue(remark.problem);
}

void Painter::add_issue(const Diagnostic& problem) {
    const std::string_view path = problem.node;
    const Card* card = path.empty() ? nullptr : state.layout.find(path.substr(0, path.find('/')));
    if (!card) return;
    issues_.resize(state.layout.cards.size());
    const Diagnostic*& issue = issues_[static_cast<size_t>(card - state.layout.cards.data())];
    if (!issue || (issue->severity != Severity::error && problem.severity == Severity::error))
        issue = &problem;
}

// Marks cards upstream and downstream of the selection, and the wires on these paths.
void Painter::find_related() {
    const Layout& layout = state.layout;
    const size_t cards = layout.cards.size();
    related_.assign(cards, false);
    related_wires_.assign(layout.wires.size(), false);
    std::vector<uint32_t> open;
    for (const bool up : {true, false}) {
        std::vector<std::vector<uint32_t>> wires_at(cards);
        for (uint32_t i = 0; i < layout.wires.size(); ++i)
            wires_at[up ? layout.wires[i].to_card : layout.wires[i].from_card].push_back(i);
        std::vector<bool> reached(cards, false);
        for (uint32_t i = 0; i < cards; ++i)
            if (view.selected.contains(layout.cards[i].id)) reached[i] = true, open.push_back(i);
        while (!open.empty()) {
            const uint32_t card = open.back();
            open.pop_back();
            related_[card] = true;
            for (const uint32_t i : wires_at[card]) {
                related_wires_[i] = true;
                const uint32_t next = up ? layout.wires[i].from_card : layout.wires[i].to_card;
                if (!reached[next]) reached[next] = true, open.push_back(next);
            }
        }
    }
}

void Painter::find_most_expensive() {
    for (const Price& price : state.costs()->nodes) {
        max_cost_.reads = std::max(max_cost_.reads, price.cost.reads);
        max_cost_.alu = std::max(max_cost_.alu, price.cost.alu);
    }
}

// The costs may belong to an earlier document; a node renamed since has the same index.
const Price* Painter::price(const Card& card) const {
    const Costs* costs = state.costs();
    if (!costs || card.kind != Card::Kind::node || card.reroute) return nullptr;
    const Table<NodePtr>& before = costs->document.nodes;
    const Table<NodePtr>& now = state.document().nodes;
    size_t index = before.index_of(card.id);
    if (index == before.npos && before.size() == now.size()) index = now.index_of(card.id);
    return index < costs->nodes.size() ? &costs->nodes[index] : nullptr;
}

float Painter::heat(const Price& price) const {
    const auto part = [](uint32_t of, uint32_t whole) {
        return whole == 0 ? 0.0F : static_cast<float>(of) / static_cast<float>(whole);
    };
    return std::max(part(price.cost.reads, max_cost_.reads), part(price.cost.alu, max_cost_.alu));
}

void fade(ImDrawList& list, int first) {
    for (int i = first; i < list.VtxBuffer.Size; ++i) {
        ImU32& color = list.VtxBuffer[i].col;
        const auto alpha = static_cast<float>(color >> IM_COL32_A_SHIFT);
        color = theme::with_alpha(color, alpha * 0.35F / 255);
    }
}

const Diagnostic* Painter::fault(const Card& card, std::string_view port) const {
    constexpr std::string_view inputs = "/in/";
    for (const Diagnostic& problem : state.built.problems.list()) {
        if (problem.node != card.id) continue;
        std::string_view at = problem.pointer;
        const size_t found = at.find(inputs);
        if (found == at.npos) continue;
        at.remove_prefix(found + inputs.size());
        if (at.substr(0, at.find('/')) == port) return &problem;
    }
    for (const ImageWarning& remark : state.images.remarks)
        if (remark.problem.node == card.id && remark.port == port) return &remark.problem;
    return nullptr;
}

}  // namespace wrinkle::editor
