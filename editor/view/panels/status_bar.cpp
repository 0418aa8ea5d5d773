// Status bar: result of the last compile, last action, hint, selection; under the side column the
// cost of the material, the preview's time and the save state.
#include <algorithm>

#include "editor/model/document/recovery.h"
#include "editor/model/hosts/repeated_exports.h"
#include "editor/view/commands/commands.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/regions.h"

namespace wrinkle::editor {
namespace {

struct Note {
    std::string text;
    ImU32 color = theme::text_dim;
};

struct Writer {
    const State& state;
    ImDrawList& list;
    ImFont* font;
    float y;

    float width(std::string_view text) const { return text_width(font, 14, text); }
    // Returns the x position after the text.
    float write(float x, ImU32 color, std::string_view text) const {
        draw_text(list, font, 14, {x, y}, color, text);
        return x + width(text);
    }
    // The text ends at `right`; returns the x position of its beginning.
    float write_before(float right, const Note& note) const {
        const float x = right - width(note.text);
        write(x, note.color, note.text);
        return x;
    }
};

float draw_result(const Writer& w, float x) {
    const Build& built = w.state.built;
    const size_t errors = built.problems.error_count();
    const size_t warnings = built.problems.list().size() - errors;
    if (errors > 0) {
        draw_error(w.list, {x + 7, w.y + 7}, 13, theme::error);
        x = w.write(x + 18, theme::error, counted(errors, "error"));
    } else if (built.uniform) {
        draw_icon(w.list, "check", {x + 7, w.y + 7}, theme::ok);
        x = w.write(x + 18, theme::text, "Compiled in " + milliseconds(built.milliseconds));
    } else if (holds_nothing(w.state.document())) {
        x = w.write(x, theme::text_dim, "Empty graph");
    } else {
        draw_warning(w.list, {x + 7, w.y + 7}, 13, theme::warn);
        x = w.write(x + 18, theme::warn, "Nothing to compile");
    }
    if (warnings > 0) x = w.write(x + 16, theme::warn, counted(warnings, "warning"));
    return x;
}

// Draws the last action, with an Undo button if it can be undone; returns the x position after it.
float draw_action(State& state, const Writer& w, float x, float room) {
    if (state.status.empty()) return x;
    const std::string text = fitting(w.font, 14, state.status, std::max(room, 40.0F));
    x = w.write(x, theme::text_dim, text);
    if (!state.history.can_undo() || state.status != state.history.undo_name()) return x;
    ImGui::SetCursorScreenPos({x + 6, w.y - 4});
    const Area area = area_button(state, "status:undo", {w.width("Undo") + 8, 22});
    if (area.hovered)
        w.list.AddLine({x + 10, w.y + 15}, {x + 10 + w.width("Undo"), w.y + 15}, theme::accent);
    x = w.write(x + 10, theme::accent, "Undo");
    if (area.pressed) run_command(state, "undo");
    return x;
}

std::string sizes(const State& state) {
    const std::set<std::string>& selected = state.view.selected;
    std::string text;
    if (selected.size() == 1) {
        std::string name = *selected.begin();
        if (name.starts_with('$')) name.erase(0, 1);  // the outputs, the surface
        text = name + " selected     ";
    }
    if (selected.size() > 1) text = std::to_string(selected.size()) + " selected     ";
    return text + counted(state.document().nodes.size(), "node") + ", " +
           counted(state.layout.wires.size(), "wire") + "     " + percent(state.view.zoom);
}

Note save_state(const Session& session) {
    const bool unkept = session.dirty() && !session.keeping.unkept.empty();
    return {kept_words(session), unkept ? theme::warn : theme::text_dim};
}

// Draws a light and the time of the exports that are repeated at every save, before `right` if they
// fit; returns the x position of their beginning.
float draw_repeated_exports(State& state, const Writer& w, float left, float right) {
    const std::string words = words_on_repeats(state);
    const float x = right - 16 - w.width(words) - 14;
    if (words.empty() || x < left) return right;
    const RepeatState repeat = state_of_repeats(state);
    const ImU32 light = repeat == RepeatState::written  ? theme::ok
                        : repeat == RepeatState::failed ? theme::error
                                                        : theme::accent;
    w.list.AddCircleFilled({x + 5, w.y + 8}, 4, light);
    w.write(x + 14, repeat == RepeatState::failed ? theme::error : theme::text_dim, words);
    state.targets.add("status:exported", {x, w.y - 4, right - 16, w.y + 18});
    return x;
}

// Draws the part under the side column: at the left the cost of the material; from the right the
// save state and the preview's time.
void draw_under_side(State& state, const Writer& w, float left, float right) {
    const Note saved = save_state(state);
    if (const Costs* costs = state.costs()) {
        const std::string cost = in_words(costs->total, costs->estimated);
        const ImVec2 low(left, w.y - 4), high(left + w.width(cost), w.y + 18);
        name_area(state, "status:cost", low, high);
        if (ImGui::IsMouseHoveringRect(low, high))
            show_tooltip({low, high}, state.fonts.bold(16), cost, in_full(costs->total, *costs));
        left = w.write(left, theme::text_dim, cost) + 16;
    }
    float x = right - w.width(saved.text);
    if (x < left) return;
    w.write(x, saved.color, saved.text);
    state.targets.add("status:saved", {x, w.y - 4, right, w.y + 18});
    x = draw_repeated_exports(state, w, left, x);
    const PreviewImage* image = state.preview ? &state.preview->shown() : nullptr;
    if (!image || !image->texture || image->first) return;
    const std::string time = "Preview " + milliseconds(image->milliseconds);
    x -= w.width(time) + (saved.text.empty() ? 0 : 16);
    if (x < left) return;
    w.write(x, theme::text_dim, time);
    state.targets.add("status:preview", {x, w.y - 4, x + w.width(time), w.y + 18});
}

}  // namespace

void draw_status_bar(State& state) {
    const Regions regions = regions_of(state);
    const ImVec2 size = ImGui::GetWindowSize(), at = ImGui::GetWindowPos();
    const Writer w{state, *ImGui::GetWindowDrawList(), state.fonts.regular(14), at.y + 5};
    w.list.AddLine(at, at + ImVec2(size.x, 0), theme::border);
    const bool column = regions.preview.size.x > 0 && regions.canvas.size.x > 0;
    const float side = column ? regions.preview.at.x : size.x;
    float end = side - 12;
    if (column) {
        w.list.AddLine({side, at.y + 1}, {side, at.y + size.y}, theme::border);
        draw_under_side(state, w, side + 12, size.x - 12);
    } else {
        const Note saved = save_state(state);
        end = w.write_before(end, saved) - (saved.text.empty() ? 0 : 16);
    }
    const float right_from = w.write_before(end, {fitting(w.font, 14, sizes(state), end * 0.4F)});
    float x = draw_result(w, at.x + 12);
    x = draw_action(state, w, x + 24, (right_from - x) * 0.5F);
    const std::string_view hint = hint_of(state, regions);
    const float hint_width = w.width(hint);
    const float hint_from = std::max(x + 24, (side - hint_width) / 2);
    if (hint_from + hint_width < right_from - 16) w.write(hint_from, theme::text_dim, hint);
}

}  // namespace wrinkle::editor
