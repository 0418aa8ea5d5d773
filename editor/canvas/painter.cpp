#include "editor/canvas/painter.h"

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
    find_selected();
    find_troubles();
}

void Painter::find_selected() {
    if (view.selected.empty()) return;
    selected_.assign(state.layout.cards.size(), false);
    for (size_t i = 0; i < selected_.size(); ++i)
        if (sees(state.layout.card_boxes[i]) || view.selected.size() < 64)
            selected_[i] = view.selected.contains(state.layout.cards[i].id);
    if (view.selected.size() > 1 && !view.order.empty())
        primary_ = state.layout.find(view.order.back());
}

void Painter::find_troubles() {
    for (const Diagnostic& problem : state.built.problems.list()) {
        const std::string_view path = problem.node;
        const Card* card =
            path.empty() ? nullptr : state.layout.find(path.substr(0, path.find('/')));
        if (!card) continue;
        troubles_.resize(state.layout.cards.size());
        Trouble& trouble = troubles_[static_cast<size_t>(card - state.layout.cards.data())];
        if (!trouble.worst || (!trouble.error() && problem.severity == Severity::error))
            trouble.worst = &problem;
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
    return nullptr;
}

}  // namespace wrinkle::editor
