#include "editor/view/panels/fields.h"

#include <algorithm>

namespace wrinkle::editor {

void focus_field(State& state) {
    constexpr int max_frames = 6;
    ImGui::SetKeyboardFocusHere();
    state.field_wait = max_frames;
}

void note_field(State& state) {
    if (ImGui::IsItemActive()) state.field_wait = 0;
}

bool typing_waits(const State& state) {
    const bool browsing = state.browser.purpose != Browser::Purpose::none && state.browser.focus;
    return state.field_wait > 0 || browsing || state.popup.opening || state.palette.opening ||
           state.box_text.opening;
}

void age_field_wait(State& state) {
    state.field_wait = std::max(state.field_wait - 1, 0);
}

}  // namespace wrinkle::editor
