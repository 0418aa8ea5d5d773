#include "editor/view/panels/help.h"

#include <algorithm>
#include <optional>

#include "base/text.h"
#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/commands/commands.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

constexpr float rest = 0.6F;  // seconds until a tooltip shows
constexpr float tip_width = 360;

// A pointer gesture on the canvas and its effect; gestures are not commands.
struct GestureHelp {
    std::string_view hand, what;
};
constexpr GestureHelp table[] = {
    {"Drag from pin to pin", "connects; from a connected input takes the wire off"},
    {"Drag a pin into the open", "searches what fits there"},
    {"Drag a value", "changes it; Ctrl fine, Shift coarse, both scale all numbers of a vector"},
    {"Click a value", "opens its list, its color or its images"},
    {"Double-click a value", "types it; Tab moves to the next"},
    {"Double-click a name", "renames the node"},
    {"Double-click a sub-graph", "opens it"},
    {"Drag empty ground", "selects what the box touches"},
    {"Middle drag, Alt + drag", "moves the view"},
    {"Wheel", "zooms at the pointer"},
    {"Right-click empty ground", "searches nodes"},
    {"Right-click a card, a value, a wire, a frame", "opens its menu"},
    {"Drop an image", "adds it as a source, on a wire as a layer"},
};

std::string default_text(const Port& port) {
    const double first = port.default_value[0];
    if (port.kind == Port::Kind::choice) {
        const auto index = static_cast<size_t>(first);
        return index < port.choices.size() ? port.choices[index] : "";
    }
    if (port.kind == Port::Kind::flag) return first != 0 ? "yes" : "no";
    if (port.kind == Port::Kind::count) return shortest(static_cast<float>(first));
    if (port.default_kind == Port::Default::surface)
        return std::string(surface_properties()[port.default_surface].name);
    if (port.default_kind != Port::Default::constant) return {};
    const std::span lanes(port.default_value.data(), static_cast<size_t>(lanes_of(port.type)));
    return joined(lanes, " ", [](double lane) { return shortest(static_cast<float>(lane)); });
}

std::string type_text(const Port& port) {
    if (port.kind == Port::Kind::choice) return "choice";
    if (port.kind == Port::Kind::count) return "count";
    if (port.kind == Port::Kind::flag) return "yes or no";
    return (port.kind == Port::Kind::field ? "any " : "") + std::string(name_of(port.type));
}

void draw_port(const Fonts& fonts, const Port& port) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (!port.is_option())
        draw_pin(list, port.type, at + ImVec2(8, 9), 6, theme::of(port.type), true, theme::node);
    ImGui::Indent(24);
    write_wrapped(fonts, port.name, theme::text, true);
    ImGui::SameLine(0, 10);
    write_wrapped(fonts, port_facts(port), theme::text_dim, false, 14);
    write_wrapped(fonts, port.doc, theme::text_dim, false, 14);
    ImGui::Unindent(24);
    ImGui::Dummy({1, 2});
}

void draw_node_page(State& state, const NodeType& type) {
    write_wrapped(state.fonts, type.title, theme::text, true, 24);
    write_wrapped(state.fonts, type.id + "   " + type.family, theme::text_dim, false, 14);
    write_wrapped(state.fonts, type.doc, theme::text);
    if (const Node* node = state.document().find(state.help.node))
        draw_image_sections(state, *node);
    for (const bool outputs : {true, false}) {
        ImGui::Dummy({1, 6});
        write_wrapped(state.fonts, outputs ? "Outputs" : "Inputs and values", theme::text, true,
                      18);
        for (const Port& port : type.ports)
            if ((port.kind == Port::Kind::output) == outputs) draw_port(state.fonts, port);
    }
}

void draw_pair(const Fonts& fonts, std::string_view left, std::string_view right, float width) {
    write_wrapped(fonts, std::string(left), theme::text);
    ImGui::SameLine(width);
    write_wrapped(fonts, std::string(right), theme::text_dim);
}

void draw_shortcuts(const Fonts& fonts) {
    write_wrapped(fonts, "Shortcuts", theme::text, true, 24);
    std::string menu;
    for (const Command& command : commands()) {
        if (menu != command.menu) {
            menu = command.menu;
            ImGui::Dummy({1, 6});
            write_wrapped(fonts, menu, theme::text, true, 18);
        }
        draw_pair(fonts, command.title, command.keys, 260);
    }
    ImGui::Dummy({1, 6});
    write_wrapped(fonts, "By hand", theme::text, true, 18);
    for (const GestureHelp& each : table)
        draw_pair(fonts, each.hand, each.what, 260);
}

const NodeType* help_type(const State& state) {
    return state.help.type.empty() ? nullptr : state.type_of(state.help.node);
}

// Tooltip for the element under the pointer.
struct HoverWords {
    std::string target, title, doc, facts, image;
    std::string previewed;  // node with the preview to enlarge; "": none
};

bool is_on_preview(const State& state, const Card& card) {
    const float y = to_canvas(state.view, ImGui::GetIO().MousePos).y - card.at.y - card.preview_y;
    return state.hovered.kind == Hit::Kind::card && card.preview_y >= 0 && y >= 0 &&
           y < node_preview_height;
}

std::optional<HoverWords> hover_words(const State& state) {
    const Hit& hit = state.hovered;
    if (!hit.on_card(state.layout)) return std::nullopt;
    const Card& card = state.layout.cards[hit.card];
    if (!card.type) return std::nullopt;
    const Port* port = nullptr;
    if (hit.kind == Hit::Kind::field && hit.part < card.fields.size())
        port = &card.type->ports[card.fields[hit.part].index];
    if (hit.kind == Hit::Kind::pin && hit.part < card.pins.size()) {
        const Pin& pin = card.pins[hit.part];
        port = pin.output ? output_port(card.type, pin.port) : input_port(card.type, pin.port);
    }
    const std::string previewed = state.node_feed.previews.places.contains(card.id) ? card.id : "";
    if (hit.kind == Hit::Kind::header)
        return HoverWords{card.type->id, card.type->title, card.type->doc, "F1 says more", "",
                          previewed};
    if (!previewed.empty() && is_on_preview(state, card))
        return HoverWords{card.id, card.id, "", "", "", previewed};
    if (!port) return std::nullopt;
    const bool image = port->is_value() && port->type == PortType::image_;
    return HoverWords{port->name,
                      port->name,
                      port->doc,
                      port_facts(*port),
                      image ? image_words(state, card.id, port->name) : "",
                      ""};
}

void draw_enlarged(State& state, const std::string& node) {
    const ImVec2 size(tip_width, tip_width * NodePreviews::height / NodePreviews::width);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy(size);
    if (const auto at = preview_place(state.node_feed, node))
        ImGui::GetWindowDrawList()->AddImage(texture_id(state.node_feed.atlas.texture()), low,
                                             low + size, {at->u0, at->v1}, {at->u1, at->v0});
    name_area(state, "tip:preview", low, low + size);
}

void write_if_any(const State& state, const std::string& text, ImU32 color, float size = 16) {
    if (!text.empty()) write_wrapped(state.fonts, text, color, false, size);
}

}  // namespace

std::string port_facts(const Port& port) {
    std::string text = type_text(port);
    if (!port.unit.empty()) text += ", " + (port.unit == "x" ? std::string("\u00D7") : port.unit);
    if (const std::string value = default_text(port);
        !value.empty() && port.kind != Port::Kind::output)
        text += ", default " + value;
    const bool hard = port.has_hard_range();
    if (hard || port.has_soft_range())
        text += ", " + shortest(static_cast<float>(hard ? port.hard_min : port.soft_min)) + " to " +
                shortest(static_cast<float>(hard ? port.hard_max : port.soft_max));
    if (port.kind != Port::Kind::output && port.is_required()) text += ", required";
    for (size_t i = 0; i < port.choices.size(); ++i)
        text += (i == 0 ? ": " : ", ") + port.choices[i];
    return text;
}

std::string shortcuts_markdown() {
    std::string text = "| command | keys | menu |\n|---|---|---|\n";
    for (const Command& command : commands())
        text += "| " + std::string(command.title) + " | " + std::string(command.keys) + " | " +
                std::string(command.menu) + " |\n";
    text += "\n| by hand | |\n|---|---|\n";
    for (const GestureHelp& each : table)
        text += "| " + std::string(each.hand) + " | " + std::string(each.what) + " |\n";
    return text;
}

void show_shortcuts(State& state) {
    state.help = {true, true, "", ""};
}

void show_help(State& state) {
    show_shortcuts(state);
    const Node* node = selected_node(state);
    if (const NodeType* type = node ? state.type_of(node->id) : nullptr)
        state.help = {true, true, node->id, type->id};
}

void write_wrapped(const Fonts& fonts, const std::string& text, ImU32 color, bool bold,
                   float size) {
    ImGui::PushFont(bold ? fonts.bold(size) : fonts.regular(size));
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void draw_help(State& state) {
    if (!state.help.open) return;
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const ImVec2 size(std::min(560.0F, room.x - 32), std::min(640.0F, room.y - 96));
    const ImVec2 low((room.x - size.x) / 2, (room.y - size.y) / 2);
    const FixedWindow window("##help", low, size,
                             {.padding = {24, 20},
                              .ground = theme::panel,
                              .border = theme::border,
                              .rounding = 8,
                              .flags = 0,
                              .opening = state.help.opening});
    ImGui::PushTextWrapPos(0);
    const NodeType* type = help_type(state);
    if (type)
        draw_node_page(state, *type);
    else
        draw_shortcuts(state.fonts);
    ImGui::PopTextWrapPos();
    name_area(state, type ? "help:" + type->id : "help:shortcuts", low, low + size);
    state.help.opening = false;
    if (window.has_lost_focus() || is_pressed(ImGuiKey_Escape)) state.help = {};
}

// Draws a tooltip after the pointer has rested (0.6 s) on a node, a pin or a value.
void draw_hover_docs(State& state) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool still = io.MouseDelta.x == 0 && io.MouseDelta.y == 0 && !io.MouseDown[0] &&
                       state.gesture.kind == Gesture::Kind::none && !state.palette.open &&
                       !state.help.open && state.popup.kind == Popup::Kind::none;
    state.help.rested = still ? state.help.rested + io.DeltaTime : 0;
    const auto words = still ? hover_words(state) : std::nullopt;
    state.help.waiting = words && state.help.rested < rest;
    if (!words || state.help.waiting) return;
    const Tooltip tip(about_hit(state, state.hovered), tip_width);
    if (!tip) return;
    write_wrapped(state.fonts, words->title, theme::text, true);
    write_if_any(state, words->doc, theme::text);
    write_if_any(state, words->facts, theme::text_dim, 14);
    if (!words->image.empty())
        write_wrapped(state.fonts, words->image + " F1 says more.", theme::text);
    if (!words->previewed.empty()) draw_enlarged(state, words->previewed);
    name_area(state, "tip:" + words->target, io.MousePos, io.MousePos);
}

}  // namespace wrinkle::editor
