#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>

#include "editor/model/document/expose.h"
#include "editor/model/document/field.h"
#include "editor/model/words.h"
#include "editor/view/canvas/gestures/gestures.h"
#include "editor/view/commands/commands.h"
#include "editor/view/drop/drop.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/browser.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/search.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

constexpr size_t max_without_field = 8;  // most choices without a query field
constexpr float choice_tall = 24, choices_shown = 10;

const Port* port_of(const State& state) {
    const NodeType* type = state.type_of(state.popup.node);
    const bool there = type && state.popup.port_index < type->ports.size();
    return there ? &type->ports[state.popup.port_index] : nullptr;
}

void accept_number(State& state) {
    const Port* port = port_of(state);
    char* end = nullptr;
    const double value = std::strtod(state.popup.text.c_str(), &end);
    if (!port || end == state.popup.text.c_str() || *end != 0) {
        state.status = "\"" + state.popup.text + "\" is not a number.";
        return;
    }
    state.commit(state.popup.node + ": " + port->name,
                 with_number(state.document(), state.popup.node, *port, state.popup.lane, value));
}

void accept_name(State& state) {
    const std::string& wanted = state.popup.text;
    if (const std::string problem = id_problem(wanted); !problem.empty()) {
        state.status = "\"" + wanted + "\" cannot be the name of a node: " + problem + ".";
    } else if (wanted != state.popup.node && state.document().find(wanted)) {
        state.status = "There is a node " + wanted + " already. Choose another name.";
    } else {
        state.commit("Rename to " + wanted,
                     rename_node(state.document(), state.popup.node, wanted));
        state.view.selected = {wanted};
    }
}

int on_entry_tab(ImGuiInputTextCallbackData* data) {
    static_cast<Popup*>(data->UserData)->next = ImGui::GetIO().KeyShift ? -1 : 1;
    return 0;
}

// Returns true when editing is finished.
bool draw_text_entry(State& state) {
    Popup& popup = state.popup;
    if (popup.opening) focus_field(state);
    ImGui::SetNextItemWidth(-1);
    // Each value has its own ImGui id, so that Tab does not carry over the text of the last field.
    const std::string id = "##" + popup.node +
                           std::to_string(popup.port_index * 4 + static_cast<uint32_t>(popup.lane));
    const bool entered =
        ImGui::InputText(id.c_str(), &popup.text,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
                             ImGuiInputTextFlags_CallbackCompletion,
                         on_entry_tab, &popup);
    note_field(state);
    if (!entered && popup.next == 0) return false;
    popup.kind == Popup::Kind::text ? accept_number(state) : accept_name(state);
    return true;
}

// Returns true on Enter; Tab sets `next`.
bool draw_query(Dialogs& dialogs, bool field) {
    Popup& popup = dialogs.popup;
    if (!field) {
        if (is_pressed(ImGuiKey_Tab, false)) popup.next = ImGui::GetIO().KeyShift ? -1 : 1;
        return !popup.opening && is_pressed(ImGuiKey_Enter, false);
    }
    if (popup.opening) focus_field(dialogs);
    ImGui::SetNextItemWidth(-1);
    const std::string before = popup.query;
    const bool entered = ImGui::InputTextWithHint(
        "##query", "Type a part of the name", &popup.query,
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackCompletion, on_entry_tab,
        &popup);
    note_field(dialogs);
    if (popup.query != before) popup.chosen = 0;
    return entered;
}

// `field`: draw a query field that filters the list. Returns the index of the chosen name.
std::optional<size_t> draw_list(State& state, const std::vector<std::string>& names, bool field) {
    Popup& popup = state.popup;
    const bool entered = draw_query(state, field);
    const std::vector<size_t> shown = find_matches(names, std::identity(), popup.query);
    const int before = popup.chosen;
    popup.chosen = moved_choice(popup.chosen, shown.size());
    const float rows =
        std::min(static_cast<float>(std::max<size_t>(shown.size(), 1)), choices_shown);
    ImGui::BeginChild("##names", {0, rows * choice_tall}, false, ImGuiWindowFlags_NoNavInputs);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    if (popup.chosen != before)
        ImGui::SetScrollY((static_cast<float>(popup.chosen) - rows / 2) * choice_tall);
    if (shown.empty()) ImGui::TextDisabled("No name matches.");
    std::optional<size_t> taken;
    if (entered && !shown.empty()) taken = shown[static_cast<size_t>(popup.chosen)];
    draw_rows(shown.size(), choice_tall, [&](size_t row) {
        const std::string& name = names[shown[row]];
        const bool chosen = static_cast<int>(row) == popup.chosen;
        if (ImGui::Selectable(("##" + name).c_str(), chosen, 0, {0, choice_tall}))
            taken = shown[row];
        name_item(state, "choice:" + name);
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        ImFont* font = state.fonts.regular(16);
        draw_text(*ImGui::GetWindowDrawList(), font, 16, low + ImVec2(8, 4), theme::text,
                  fitting(font, 16, name, high.x - low.x - 16));
    });
    ImGui::PopStyleVar();
    ImGui::EndChild();
    if (entered && !taken) popup.opening = true;  // focus the field again
    return taken;
}

bool draw_choices(State& state) {
    const Port* port = port_of(state);
    if (!port) return true;
    const std::string node = state.popup.node;
    const bool flag = port->kind == Port::Kind::flag;
    const std::vector<std::string> names =
        flag ? std::vector<std::string>{"no", "yes"} : port->choices;
    const auto taken = draw_list(state, names, names.size() > max_without_field);
    if (!taken) return state.popup.next != 0;
    const Document& now = state.document();
    state.commit(node + ": " + port->name,
                 flag ? with_flag(now, node, *port, *taken == 1)
                      : with_choice(now, node, *port, static_cast<uint32_t>(*taken)));
    return true;
}

// Chooses an image for the port; if the popup has no node, adds the image.
bool draw_files(State& state) {
    const bool adds = state.popup.node.empty();
    const Port* port = adds ? nullptr : port_of(state);
    if (!port && !adds) return true;
    const std::vector<std::string> files = state.popup.files;
    if (files.empty()) ImGui::TextDisabled("There are no images below the graph's folder.");
    const std::string node = state.popup.node, name = port ? port->name : "";
    if (button(state, "Browse...", "choice:browse")) {
        browse_image(state, node, name);
        return true;
    }
    const auto taken = draw_list(state, files, true);
    if (!taken) return state.popup.next != 0;
    if (adds)
        add_image(state, files[*taken]);
    else
        state.commit(node + ": " + name, with_file(state.document(), node, *port, files[*taken]));
    return true;
}

// All changes until the popup closes are one undo step.
bool draw_color(State& state) {
    const Port* port = port_of(state);
    const Node* node = state.document().find(state.popup.node);
    if (!port || !node) return true;
    const auto numbers = numbers_at(*node, *port);
    std::array<float, 3> color;
    for (size_t i = 0; i < 3; ++i)
        color[i] = static_cast<float>(numbers[i]);
    const bool changed = pick_color(state, "color", color);
    if (changed) {
        Document document = state.document();
        for (int i = 0; i < 3; ++i)
            document = with_number(document, state.popup.node, *port, i,
                                   static_cast<double>(color[static_cast<size_t>(i)]));
        state.commit(state.popup.node + ": " + port->name, document, state.popup.merge);
    }
    if (is_pressed(ImGuiKey_Tab, false)) state.popup.next = 1;
    return state.popup.next != 0 || is_pressed(ImGuiKey_Enter, false);
}

// Chooses the port that becomes an input of the graph, or all of them.
bool draw_exposable(State& state) {
    const std::vector<PortOfNode> ports = exposable_of_selected(state);
    if (ports.empty()) return true;
    const bool several = state.view.selected.size() > 1;
    std::vector<std::string> names{"All " + counted(ports.size(), "value")};
    for (const auto& [id, port] : ports)
        names.push_back(several ? id + "." + port->name : port->name);
    ImGui::TextDisabled("Expose as inputs of the graph");
    const auto taken = draw_list(state, names, names.size() > max_without_field);
    if (taken) expose_ports(state, *taken == 0 ? ports : std::vector{ports[*taken - 1]});
    state.popup.next = 0;  // no field is next to the list
    return taken.has_value();
}

// By Popup::Kind. Each returns true when the popup is to be closed.
constexpr bool (*draw_content_of[])(State&) = {nullptr,        draw_text_entry, draw_text_entry,
                                               draw_choices,   draw_files,      draw_color,
                                               draw_exposable, draw_ramp,       draw_curve};
static_assert(std::size(draw_content_of) == static_cast<size_t>(Popup::Kind::curve) + 1);

Popup::Kind kind_of(const Port& port, const Field& field) {
    if (field.shows == Field::Shows::strip) return Popup::Kind::ramp;
    if (field.shows == Field::Shows::curve) return Popup::Kind::curve;
    if (port.kind == Port::Kind::choice || port.kind == Port::Kind::flag)
        return Popup::Kind::choice;
    if (port.is_value() && port.type == PortType::image_) return Popup::Kind::file;
    if (port.is_value() && port.type == PortType::color_) return Popup::Kind::color;
    return Popup::Kind::text;
}

void open_next(State& state, const Popup& popup) {
    const Card* found = state.layout.find(popup.node);
    if (!found || found->fields.empty()) return;
    const Card card = *found;
    const auto count = static_cast<int>(card.fields.size());
    for (int i = 0; i < count; ++i) {
        const Field& field = card.fields[static_cast<size_t>(i)];
        if (field.index != popup.port_index || field.lane != popup.lane) continue;
        int to = (i + popup.next + count) % count;
        // The components of a color are one field.
        while (popup.kind == Popup::Kind::color && to != i &&
               card.fields[static_cast<size_t>(to)].index == popup.port_index)
            to = (to + popup.next + count) % count;
        return open_field(state, card, card.fields[static_cast<size_t>(to)]);
    }
}

}  // namespace

void open_field(State& state, const Card& card, const Field& field) {
    const Port& port = card.type->ports[field.index];
    const Node* node = state.document().find(card.id);
    if (!node) return;
    const Popup::Kind kind = kind_of(port, field);
    open_popup(state, card, &field, kind);
    if (kind == Popup::Kind::choice)
        state.popup.chosen = static_cast<int>(numbers_at(*node, port)[0]);
    state.popup.merge = "popup " + std::to_string(state.history.serial());
}

void edit_values(State& state) {
    const Card* card = state.layout.find(*state.view.selected.begin());
    if (card && !card->fields.empty()) open_field(state, Card(*card), Field(card->fields.front()));
}

void choose_image(State& state) {
    constexpr float width = 360;
    const View& view = state.view;
    state.popup = {.kind = Popup::Kind::file,
                   .opening = true,
                   .at = view.corner + ImVec2((view.extent.x - width) / 2, 64),
                   .width = width,
                   .files = image_files(state.folder())};
}

void draw_popup(State& state) {
    if (state.popup.kind == Popup::Kind::none) return;
    const Popup::Kind kind = state.popup.kind;
    const bool list =
        kind == Popup::Kind::choice || kind == Popup::Kind::file || kind == Popup::Kind::expose;
    const bool color = kind == Popup::Kind::color,
               knots = kind == Popup::Kind::ramp || kind == Popup::Kind::curve;
    const bool opening = state.popup.opening;
    const float width = color || knots ? 0 : std::max(state.popup.width, list ? 240.0F : 0.0F);
    const float padding = knots ? 12 : list || color ? 6 : 0;
    ImVec2 at = state.popup.at;
    if (list || color || knots) {
        const ImVec2 size = state.popup.size, room = ImGui::GetIO().DisplaySize;
        at.x = std::max(std::min(at.x, room.x - std::max(width, size.x) - 8), 0.0F);
        at.y = std::max(std::min(at.y, room.y - size.y - 8), 0.0F);
    }
    const FixedWindow window("##popup", at, {width, 0},
                             {.padding = {padding, padding},
                              .ground = theme::panel,
                              .border = theme::accent,
                              .opening = opening});
    const bool covered = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    bool done = draw_content_of[static_cast<size_t>(kind)](state);
    if (opening) state.popup.opening = false;
    state.popup.size = ImGui::GetWindowSize();
    done |= window.has_lost_focus() && !covered;
    const bool escape = is_pressed(ImGuiKey_Escape) && !covered;
    if (!done && !escape) return;
    const Popup closed = std::exchange(state.popup, {});
    if (escape && color) state.history.cancel(closed.merge);
    if (closed.next != 0 && !escape) open_next(state, closed);
}

}  // namespace wrinkle::editor
