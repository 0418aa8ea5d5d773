// The status bar: what came of the last compile, what the hand can do now, what is selected.
#include <algorithm>
#include <cstdio>

#include "editor/commands/commands.h"
#include "editor/look/draw.h"
#include "editor/look/icons.h"
#include "editor/look/theme.h"
#include "editor/panels/panels.h"

namespace wrinkle::editor {
namespace {

std::string_view hint_of_gesture(const Gesture& gesture) {
    switch (gesture.kind) {
        case Gesture::Kind::wire:
            return "Drop on a pin, or on empty ground for a node that fits   Esc to drop the wire";
        case Gesture::Kind::value:
            return "Ctrl is fine, Shift coarse   Esc gives the value back";
        case Gesture::Kind::move:
            return "Esc puts it back";
        case Gesture::Kind::box:
            return "Shift adds to the selection";
        case Gesture::Kind::cut:
            return "Wires under the stroke are cut when the button is let go   Esc keeps them";
        case Gesture::Kind::lazy:
            return "Let go on a node to connect what fits best   Esc to drop the wire";
        default:
            return {};
    }
}

std::string_view hint_of_place(const State& state) {
    switch (state.hovered.kind) {
        case Hit::Kind::pin:
            return "Drag to connect";
        case Hit::Kind::field:
            return "Drag to change   double-click to type";
        case Hit::Kind::header:
            return "Drag to move   double-click to rename";
        case Hit::Kind::card:
            return "Drag to move";
        case Hit::Kind::wire:
            return "Click to select   Delete removes it";
        default:
            return "Space adds a node   the wheel zooms   the middle button pans";
    }
}

struct Writer {
    const State& state;
    ImDrawList& list;
    ImFont* font;
    float y;

    float width(std::string_view text) const { return text_width(font, 14, text); }
    // The place after it.
    float write(float x, ImU32 color, std::string_view text) const {
        draw_text(list, font, 14, {x, y}, color, text);
        return x + width(text);
    }
};

float draw_result(const Writer& w, float x) {
    const Diagnostics& problems = w.state.built.problems;
    const size_t errors = problems.error_count(), warnings = problems.list().size() - errors;
    if (problems.has_errors() || !w.state.built.uniform) {
        draw_warning(w.list, {x + 7, w.y + 7}, 13, theme::error);
        x = w.write(x + 18, theme::error, errors ? counted(errors, "error") : "Not compiled");
    } else {
        char text[48];
        std::snprintf(text, sizeof text, "Compiled in %.1f ms", w.state.built.milliseconds);
        draw_icon(w.list, "check", {x + 7, w.y + 7}, theme::ok);
        x = w.write(x + 18, theme::text, text);
    }
    if (warnings > 0) x = w.write(x + 16, theme::warn, counted(warnings, "warning"));
    return x;
}

// What the last action did, and a way back.
float draw_action(State& state, const Writer& w, float x, float room) {
    if (state.status.empty()) return x;
    const std::string text = fitting(w.font, 14, state.status, std::max(room, 40.0F));
    x = w.write(x, theme::text_dim, text);
    if (!state.history.can_undo() || state.status != state.history.undo_name()) return x;
    ImGui::SetCursorScreenPos({x + 6, w.y - 4});
    const bool pressed = ImGui::InvisibleButton("undo", {w.width("Undo") + 8, 22});
    state.targets.add("status:undo", {x + 6, w.y - 4, x + 14 + w.width("Undo"), w.y + 18});
    if (ImGui::IsItemHovered())
        w.list.AddLine({x + 10, w.y + 15}, {x + 10 + w.width("Undo"), w.y + 15}, theme::accent);
    x = w.write(x + 10, theme::accent, "Undo");
    if (pressed) run_command(state, "undo");
    return x;
}

std::string sizes(const State& state) {
    const std::set<std::string>& selected = state.view.selected;
    std::string text;
    if (selected.size() == 1) text = *selected.begin() + " selected     ";
    if (selected.size() > 1) text = std::to_string(selected.size()) + " selected     ";
    char zoom[24];
    std::snprintf(zoom, sizeof zoom, "     %.0f %%", static_cast<double>(state.view.zoom) * 100);
    return text + counted(state.document().nodes.size(), "node") + ", " +
           counted(state.layout.wires.size(), "wire") + zoom;
}

}  // namespace

void draw_status_bar(State& state) {
    const ImVec2 size = ImGui::GetWindowSize(), at = ImGui::GetWindowPos();
    const Writer w{state, *ImGui::GetWindowDrawList(), state.fonts.regular(14), at.y + 5};
    const std::string right = fitting(w.font, 14, sizes(state), size.x * 0.4F);
    const float right_from = size.x - 12 - w.width(right);
    w.write(right_from, theme::text_dim, right);
    float x = draw_result(w, at.x + 12);
    x = draw_action(state, w, x + 24, (right_from - x) * 0.5F);
    std::string_view hint = hint_of_gesture(state.gesture);
    if (hint.empty()) hint = hint_of_place(state);
    const float hint_width = w.width(hint);
    const float hint_from = std::max(x + 24, (size.x - hint_width) / 2);
    if (hint_from + hint_width < right_from - 16) w.write(hint_from, theme::text_dim, hint);
}

}  // namespace wrinkle::editor
