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
}

void Painter::find_troubles() {
    for (const Diagnostic& problem : state.built.problems.list()) {
        const std::string_view id =
            std::string_view(problem.node).substr(0, problem.node.find('/'));
        const Card* card = id.empty() ? nullptr : state.layout.find(id);
        if (!card) continue;
        troubles_.resize(state.layout.cards.size());
        Trouble& trouble = troubles_[static_cast<size_t>(card - state.layout.cards.data())];
        trouble.any = true;
        trouble.error |= problem.severity == Severity::error;
    }
}

}  // namespace wrinkle::editor
