// Menu of the card, port, wire or box under the pointer, with its actions.
#include <algorithm>

#include "editor/model/document/expose.h"
#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/gestures/gestures.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/commands/commands.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

constexpr float entry_tall = 26, menu_wide = 328;

// Commands by the part that they concern, in the order of the menu.
constexpr std::string_view node_entries[] = {
    "edit-values", "preview-node",     "picture", "mute",  "ports",
    "swap-inputs", "open-group",       "ungroup", "group", "frame",
    "help",        "tidy-selection",   "cut",     "copy",  "duplicate",
    "delete",      "delete-with-wires"};
constexpr std::string_view wire_entries[] = {"add-node", "delete"};
constexpr std::string_view box_entries[] = {"cut", "copy", "duplicate", "delete"};

struct MenuEntry {
    std::string title, keys, target;
    const Command* command = nullptr;
    void (*run)(State&, const ContextMenu&) = nullptr;  // if `command` is nullptr
};

void expose_entry(State& state, const ContextMenu& menu) {
    if (const Port* port = input_port(state.type_of(menu.node), menu.port))
        expose_ports(state, {{menu.node, port}});
}
void copy_value_entry(State& state, const ContextMenu& menu) {
    if (const Port* port = input_port(state.type_of(menu.node), menu.port))
        copy_value(state, {menu.node, port});
}
void reset_entry(State& state, const ContextMenu& menu) {
    state.commit("Reset " + menu.node + "." + menu.port,
                 reset_value(state.document(), menu.node, menu.port));
}
void disconnect_entry(State& state, const ContextMenu& menu) {
    const std::string end = menu.node.empty() ? menu.port : menu.node + "." + menu.port;
    state.commit("Disconnect " + end, menu.node.empty()
                                          ? remove_output(state.document(), menu.port)
                                          : disconnect(state.document(), menu.node, menu.port));
}
void bend_entry(State& state, const ContextMenu& menu) {
    const auto& wires = state.layout.wires;
    const auto found = std::ranges::find_if(wires, [&](const Wire& wire) {
        return wire.ends_at({menu.node, menu.port});
    });
    if (found == wires.end()) return;
    reroute_wire(state, static_cast<size_t>(found - wires.begin()), to_canvas(state.view, menu.at));
}
void write_entry(State& state, const ContextMenu& menu) {
    edit_box_text(state, menu.box);
}

std::vector<MenuEntry> port_entries(const State& state, const ContextMenu& menu) {
    std::vector<MenuEntry> entries;
    const Node* node = state.document().find(menu.node);
    const Port* port = node ? input_port(state.type_of(menu.node), menu.port) : nullptr;
    const Input* input = node ? node->find(menu.port) : nullptr;
    if (port && why_not_exposed(*node, *port).empty())
        entries.push_back(
            {"Expose " + menu.port + " as an input", "E", "expose", nullptr, expose_entry});
    if (!copy_targets(state, {menu.node, port}).empty())
        entries.push_back({"Copy " + menu.port + " to the selected nodes", "Shift+Enter",
                           "copy-value", nullptr, copy_value_entry});
    if (input && input->kind == Input::Kind::literal)
        entries.push_back({"Reset " + menu.port, "", "reset", nullptr, reset_entry});
    if (state.layout.wire_to({menu.node, menu.port}))
        entries.push_back({"Disconnect " + menu.port, "", "disconnect", nullptr, disconnect_entry});
    return entries;
}

std::vector<MenuEntry> entries_of(const State& state, const ContextMenu& menu) {
    using Part = ContextMenu::Part;
    std::vector<MenuEntry> entries;
    std::span<const std::string_view> ids;
    if (menu.part == Part::card) {
        if (!menu.port.empty()) entries = port_entries(state, menu);
        if (!menu.node.empty()) ids = node_entries;
    } else if (menu.part == Part::wire) {
        entries.push_back({"Bend here", "", "bend", nullptr, bend_entry});
        ids = wire_entries;
    } else {
        entries.push_back({"Edit text", "", "text", nullptr, write_entry});
        ids = box_entries;
    }
    for (const std::string_view id : ids) {
        const Command* command = find_command(id);
        const bool fits = id != "ungroup" || selected_group(state);
        if (fits && command->enabled(state))
            entries.push_back({std::string(command->title), std::string(command->keys),
                               std::string(id), command});
    }
    return entries;
}

// Returns the size of the menu, placed so that all of it is in the window.
ImVec2 menu_corner(ImVec2 at, size_t entries) {
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const float tall = entry_tall * static_cast<float>(entries) + 12;
    return {std::clamp(at.x, 0.0F, std::max(room.x - menu_wide - 4, 0.0F)),
            std::clamp(at.y, 0.0F, std::max(room.y - tall - 4, 0.0F))};
}

// Returns true if the entry was clicked.
bool draw_entry(State& state, const MenuEntry& entry, bool& chosen) {
    const Area area = area_button(state, "context:" + entry.target, {menu_wide - 12, entry_tall});
    if (area.hovered) chosen = true;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (chosen) list.AddRectFilled(area.low, area.high, theme::accent_soft, 4);
    const float key_wide = text_width(state.fonts.regular(14), 14, entry.keys);
    const float room = area.high.x - area.low.x - key_wide - 48;
    draw_icon(list, entry.target, area.low + ImVec2(14, entry_tall / 2), theme::text_dim);
    draw_text(list, state.fonts.regular(16), 16, area.low + ImVec2(30, 5), theme::text,
              fitting(state.fonts.regular(16), 16, entry.title, room));
    draw_text(list, state.fonts.regular(14), 14, {area.high.x - 8, area.low.y + 6}, theme::text_dim,
              entry.keys, true);
    return area.pressed;
}

void run_entry(State& state, const MenuEntry& entry, const ContextMenu& menu) {
    if (!entry.command) return entry.run(state, menu);
    if (entry.command->enabled(state)) entry.command->run(state);
}

// Selects the card unless it is one of the selected ones.
void select_for_menu(State& state, const Hit& hit, ContextMenu& menu) {
    const Card& card = state.layout.cards[hit.card];
    menu.part = ContextMenu::Part::card;
    menu.node = card.link_id();
    if (hit.kind == Hit::Kind::field) menu.port = card.fields[hit.part].port;
    if (hit.kind == Hit::Kind::pin && !card.pins[hit.part].output)
        menu.port = card.pins[hit.part].port;
    if (card.kind != Card::Kind::node || state.view.selected.contains(card.id)) return;
    state.view.selected = {};
    state.view.boxes.clear();
    state.view.selected_wire.reset();
    select_card(state, std::string(card.id));
}

}  // namespace

void open_context_menu(State& state, const Hit& hit, ImVec2 at) {
    ContextMenu menu{.open = true, .opening = true, .at = at};
    if (hit.on_card(state.layout) && hit.kind != Hit::Kind::box) {
        if (state.layout.cards[hit.card].kind != Card::Kind::node &&
            state.layout.cards[hit.card].kind != Card::Kind::outputs)
            return;
        select_for_menu(state, hit, menu);
    } else if (hit.kind == Hit::Kind::wire) {
        const Wire& wire = state.layout.wires[hit.part];
        menu.part = ContextMenu::Part::wire;
        menu.node = wire.node;
        menu.port = wire.port;
        state.view.selected.clear();
        state.view.boxes.clear();
        state.view.selected_wire = Link{wire.node, wire.port};
    } else if (hit.kind == Hit::Kind::box) {
        menu.part = ContextMenu::Part::box;
        menu.box = all_boxes(state.document())[hit.part];
        if (!state.view.boxes.contains(menu.box)) {
            state.view.selected.clear();
            state.view.boxes = {menu.box};
        }
        state.view.selected_wire.reset();
    } else {
        return;
    }
    if (!entries_of(state, menu).empty()) state.context_menu = std::move(menu);
}

void open_selection_menu(State& state) {
    const std::string id = *state.view.selected.begin();
    const auto& cards = state.layout.cards;
    for (size_t i = 0; i < cards.size(); ++i)
        if (cards[i].kind == Card::Kind::node && cards[i].id == id)
            open_context_menu(state, {Hit::Kind::card, i},
                              to_screen(state.view, cards[i].at + ImVec2(24, 24)));
}

void draw_context_menu(State& state) {
    ContextMenu& menu = state.context_menu;
    if (!menu.open) return;
    const std::vector<MenuEntry> entries = entries_of(state, menu);
    const auto tall = entry_tall * static_cast<float>(entries.size()) + 12;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    const FixedWindow window("##context", menu_corner(menu.at, entries.size()), {menu_wide, tall},
                             {.padding = {6, 6},
                              .ground = theme::panel,
                              .border = theme::control,
                              .rounding = 8,
                              .opening = menu.opening});
    menu.chosen = moved_choice(menu.chosen, entries.size());
    const MenuEntry* taken = nullptr;
    for (size_t i = 0; i < entries.size(); ++i) {
        bool chosen = static_cast<int>(i) == menu.chosen;
        if (draw_entry(state, entries[i], chosen)) taken = &entries[i];
        if (chosen && ImGui::GetIO().MouseDelta.x + ImGui::GetIO().MouseDelta.y != 0)
            menu.chosen = static_cast<int>(i);
    }
    ImGui::PopStyleVar();
    if (!menu.opening && !entries.empty() && is_pressed(ImGuiKey_Enter, false))
        taken = &entries[static_cast<size_t>(menu.chosen)];
    const bool left = window.has_lost_focus() || is_pressed(ImGuiKey_Escape, false);
    menu.opening = false;
    if (!taken && !left && !entries.empty()) return;
    const ContextMenu closed = std::exchange(menu, {});
    if (taken) run_entry(state, *taken, closed);
}

}  // namespace wrinkle::editor
