// Controls of the comparison: mode, side B, display as image or difference.
#include <algorithm>

#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/preview_parts.h"

namespace wrinkle::editor {
namespace {

struct Other {
    const char* name;  // a `blend` of compare_bump_blend
    const char* label;
};
constexpr Other blends[] = {{"udn", "UDN blend"},
                            {"whiteout", "Whiteout blend"},
                            {"rnm", "RNM"},
                            {"linear", "Linear blend"},
                            {"partial_derivative", "Partial derivatives"}};

constexpr float row = 42;

std::vector<PreviewRequest> others(const State& state) {
    std::vector<PreviewRequest> all;
    for (const Other& blend : blends)
        all.push_back({"", Against::blend, blend.name, false});
    for (const Output& output : state.document().outputs) {
        const PortType type = state.model.type_of(output.from.link).value_or(PortType::float_);
        if (output.name != "normal" && (type == PortType::normal_ || type == PortType::gradient_))
            all.push_back({"", Against::output, output.name, false});
    }
    if (state.view.selected.size() == 1)
        all.push_back({"", Against::node, *state.view.selected.begin(), false});
    return all;
}

void choose_other(State& state, float width) {
    PreviewRequest& request = state.view.preview_request;
    const std::vector<PreviewRequest> all = others(state);
    std::vector<Item> items;
    for (const PreviewRequest& other : all)
        items.push_back({against_label(other), "against:" + other.name});
    const int picked = choose(state, "compare:against", against_label(request), items, width);
    if (picked < 0) return;
    request.against = all[static_cast<size_t>(picked)].against;
    request.name = all[static_cast<size_t>(picked)].name;
}

void word(const Fonts& fonts, const char* text) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImFont* font = fonts.regular(16);
    draw_text(*ImGui::GetWindowDrawList(), font, 16, at + ImVec2(0, 5), theme::text_dim, text);
    ImGui::Dummy({text_width(font, 16, text), 24});
    ImGui::SameLine(0, 8);
}

void draw_modes(State& state) {
    CompareView& compare = state.view.compare;
    static const Item all[] = {{"Off", "compare:off"},
                               {"Split", "compare:split", "Side by side  S"},
                               {"Flip", "compare:flip", "Turn to the other side  X"}};
    const int picked = segments(state, all, static_cast<int>(compare.mode), 156);
    ImGui::SameLine(0, 12);
    if (picked < 0) return;
    const auto mode = static_cast<CompareView::Mode>(picked);
    compare.flipped = mode == CompareView::Mode::flip && (compare.mode != mode || !compare.flipped);
    compare.mode = mode;
}

}  // namespace

std::string against_label(const PreviewRequest& request) {
    for (const Other& blend : blends)
        if (request.against == Against::blend && request.name == blend.name) return blend.label;
    if (request.against == Against::output) return "output " + request.name;
    return "node " + request.name;
}

float compare_height(float width) {
    return width < 520 ? row + 32 : row;
}

void draw_compare(State& state, ImVec2 at, float width) {
    CompareView& compare = state.view.compare;
    ImGui::SetCursorScreenPos(at + ImVec2(12, 8));
    word(state.fonts, "Compare");
    draw_modes(state);
    if (width < 520) ImGui::SetCursorScreenPos(at + ImVec2(12, 40));
    const bool off = compare.mode == CompareView::Mode::off;
    ImGui::BeginDisabled(off);
    word(state.fonts, "against");
    const float left = at.x + width - ImGui::GetCursorScreenPos().x - 16 - 8 - 12 - 16;
    choose_other(state, std::max(left * 0.55F, 60.0F));
    ImGui::SameLine(0, 8);
    word(state.fonts, "as");
    static const Item as[] = {{"Image", "as:picture"}, {"Difference", "as:difference"}};
    const int picked = choose(state, "compare:as", as[compare.difference ? 1 : 0].label, as,
                              std::max(left * 0.45F, 60.0F));
    if (picked >= 0) compare.difference = picked == 1;
    ImGui::EndDisabled();
}

}  // namespace wrinkle::editor
