#include "editor/view/panels/knot_popup.h"

#include <algorithm>

#include "editor/model/document/wiring.h"

namespace wrinkle::editor {

void KnotEditor::commit(Document document) const {
    state.commit(node->id + ": " + ports.count->name, std::move(document), state.popup.merge);
}

bool KnotEditor::has_wire(std::string_view name) const {
    return link_at(state.document(), node->id, repeated_name(name, selected())).has_value();
}

bool KnotEditor::is_on_wire(std::string_view name) const {
    const bool wired = has_wire(name);
    if (wired) state.status = repeated_name(name, selected()) + " is set by a wire.";
    return wired;
}

bool KnotEditor::is_full() const {
    const bool full = count() >= ports.most();
    if (full)
        state.status = node->id + " has at most " + std::to_string(ports.most()) + " " +
                       ports.count->name + ".";
    return full;
}

void KnotEditor::remove_selected() const {
    commit(without_item(state.document(), *node, ports, selected()));
    select(selected() > 0 ? selected() - 1 : 0);
}

std::optional<KnotEditor> edit_knots(State& state, RepeatedPorts (*ports_of)(const NodeType*)) {
    const Card* card = state.layout.find(state.popup.node);
    const NodePtr* node = state.document().nodes.find(state.popup.node);
    const RepeatedPorts ports = ports_of(card ? card->type : nullptr);
    if (!node || !ports) return std::nullopt;
    KnotEditor editor{state, *card, *node, ports};
    editor.select(std::min(editor.selected(), editor.count() - 1));
    if (!ImGui::IsAnyItemActive())
        state.popup.merge = "knots " + std::to_string(state.history.serial());
    return editor;
}

bool end_knots(State& state) {
    // The key that opened it is still pressed, or a field takes it.
    if (state.popup.opening || ImGui::GetIO().WantTextInput) return false;
    if (is_pressed(ImGuiKey_Tab, false)) state.popup.next = 1;
    return state.popup.next != 0 || is_pressed(ImGuiKey_Enter, false);
}

bool draw_knot_buttons(const KnotEditor& editor, const char* name, const std::string& target) {
    const bool add = button(editor.state, "Add", target + ":add");
    ImGui::SameLine();
    if (button(editor.state, "Remove", target + ":remove")) editor.remove_selected();
    ImGui::SameLine(0, 12);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s %zu of %zu", name, editor.selected() + 1, editor.count());
    return add;
}

KnotKeys read_knot_keys(const KnotEditor& editor) {
    if (ImGui::GetIO().WantTextInput || editor.state.popup.opening) return {};
    const int x = is_pressed(ImGuiKey_RightArrow) - is_pressed(ImGuiKey_LeftArrow);
    const int y = is_pressed(ImGuiKey_UpArrow) - is_pressed(ImGuiKey_DownArrow);
    if (is_pressed(ImGuiKey_Delete)) editor.remove_selected();
    if (ImGui::GetIO().KeyShift) return {{static_cast<float>(x), static_cast<float>(y)}, false};
    if (x > 0) editor.select(std::min(editor.selected() + 1, editor.count() - 1));
    if (x < 0 && editor.selected() > 0) editor.select(editor.selected() - 1);
    return {{0, 0}, is_pressed(ImGuiKey_Insert)};
}

}  // namespace wrinkle::editor
