#include "editor/view/panels/bake_dialog.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <iterator>

#include "bake/bake.h"
#include "editor/model/bake/bake.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/browser.h"
#include "editor/view/panels/dialog_rows.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/preview_parts.h"
#include "mesh/shapes.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

constexpr float control_wide = bake_wide - 2 * bake_padding - label_wide - preview_side - 16;
constexpr float half_wide = (bake_wide - 2 * bake_padding - 16) / 2 - label_wide;
constexpr float right_half = bake_padding + label_wide + half_wide + 16;
constexpr float map_tall = 28, max_map_rows = 4;
constexpr const char* packs_tip =
    "Maps of others' channels, with a ; between two: orm: r=occlusion g=roughness b=metalness";

bool draw_box(Interface& interface, const std::string& label, const std::string& target, bool* on) {
    return draw_control(interface, target, 0, [&] { return ImGui::Checkbox(label.c_str(), on); });
}

bool is_ticked(const BakeChoices& choices, const std::string& map) {
    return std::ranges::find(choices.maps, map) != choices.maps.end();
}

// Toggles `map` in the chosen maps, which stay in the order of `all`.
void tick(BakeChoices& choices, const std::vector<std::string>& all, const std::string& map) {
    std::vector<std::string> ticked;
    for (const std::string& each : all)
        if (is_ticked(choices, each) != (each == map)) ticked.push_back(each);
    choices.maps = std::move(ticked);
}

void draw_maps_row(State& state) {
    BakeChoices& choices = state.bake_dialog.choices;
    const std::vector<std::string> all = maps_of(state.document());
    begin_control(state.fonts, "Maps", bake_words::map);
    const auto rows = static_cast<float>((all.size() + 1) / 2);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::BeginChild("##maps", {control_wide, std::min(rows, max_map_rows) * map_tall}, false);
    ImGui::PopStyleVar();
    const float column = control_wide / 2;
    for (size_t i = 0; i < all.size(); ++i) {
        ImGui::SetCursorPos({i % 2 == 0 ? 0 : column, static_cast<float>(i / 2) * map_tall});
        bool on = is_ticked(choices, all[i]);
        ImFont* font = state.fonts.regular(16);
        const std::string label = fitting(font, 16, all[i], column - 44) + "##" + all[i];
        if (draw_box(state, label, "bake:map:" + all[i], &on)) tick(choices, all, all[i]);
    }
    ImGui::EndChild();
}

// The map is square unless a height is chosen.
void draw_size_row(State& state) {
    BakeChoices& choices = state.bake_dialog.choices;
    constexpr float gap = 8, each_wide = (control_wide - gap) / 2;
    begin_control(state.fonts, "Size", "Width and height of a map, in texels");
    draw_numbers(state, "bake:size", bake_sizes, choices.width, each_wide,
                 [](uint32_t texels) { return grouped(texels) + " px"; });
    ImGui::SameLine(0, gap);
    std::vector<uint32_t> heights(std::begin(bake_sizes), std::end(bake_sizes));
    heights.insert(heights.begin(), 0);
    draw_numbers(
        state, "bake:height", heights, choices.square_or_height, each_wide,
        [](uint32_t texels) { return texels ? "\u00D7 " + grouped(texels) + " px" : "Square"; });
}

// Two segments that set a flag.
void draw_ways(Interface& interface, const Item& off, const Item& on, bool& way) {
    const Item both[] = {off, on};
    const int picked = segments(interface, both, way ? 1 : 0, half_wide);
    if (picked >= 0) way = picked == 1;
}

void draw_normal_rows(State& state) {
    BakeChoices& choices = state.bake_dialog.choices;
    begin_control(state.fonts, "Space", "Space of normals");
    draw_ways(state, {"Tangent", "bake:tangent", "The frame of the mesh's uvs"},
              {"Object", "bake:object", "The mesh's own axes"}, choices.object_space);
    begin_control(state.fonts, "Green", "Green of normals", right_half);
    draw_ways(state, {"Up (gl)", "bake:gl", "OpenGL, Blender, Unity, glTF"},
              {"Down (dx)", "bake:dx", "DirectX, Unreal"}, choices.green_down);
}

void draw_scale_row(State& state) {
    begin_control(state.fonts, "Scale", bake_words::scale);
    draw_control(state, "bake:scale", control_wide, [&] {
        return ImGui::InputDouble("##scale", &state.bake_dialog.choices.tuning.scale, 0, 0, "%g");
    });
}

void draw_packs_row(State& state) {
    begin_control(state.fonts, "Packed", packs_tip);
    draw_control(state, "bake:packs", bake_wide - 2 * bake_padding - label_wide, [&] {
        return ImGui::InputTextWithHint("##packs", "orm: r=occlusion g=roughness b=metalness",
                                        &state.bake_dialog.choices.packs);
    });
}

void draw_edge_rows(State& state) {
    BakeTuning& tuning = state.bake_dialog.choices.tuning;
    begin_control(state.fonts, "Samples", bake_words::samples);
    draw_numbers(state, "bake:samples", bake_sample_counts, tuning.samples, half_wide,
                 [](uint32_t count) { return std::to_string(count); });
    begin_control(state.fonts, "Dilation", bake_words::dilate, right_half);
    auto texels = static_cast<int>(tuning.dilate);
    draw_control(state, "bake:dilate", half_wide,
                 [&] { return ImGui::InputInt("##dilate", &texels, 0, 0); });
    tuning.dilate = static_cast<uint32_t>(std::clamp(texels, 0, static_cast<int>(max_dilation)));
}

void draw_stored(State& state) {
    BakeChoices& choices = state.bake_dialog.choices;
    std::vector<Item> items;
    for (const StoredAs& each : stored_kinds()) {
        items.push_back({each.label, "bake:stored:" + each.key});
        std::ranges::replace(items.back().target, ' ', '-');
    }
    const int picked = choose(state, "bake:stored", choices.stored->label, items, half_wide);
    if (picked >= 0) choices.stored = &stored_kinds()[static_cast<size_t>(picked)];
}

// Compression for the chosen format. A format without compression does not change the setting.
void draw_compression(State& state) {
    BakeChoices& choices = state.bake_dialog.choices;
    const std::vector<std::string_view> known = compressions_of(*choices.stored);
    const std::string own = choices.compression_in(*choices.stored);
    std::vector<Item> items{{"Usual", "bake:compression:usual"}};
    for (const std::string_view each : known)
        items.push_back({std::string(each), "bake:compression:" + std::string(each)});
    ImGui::BeginDisabled(known.empty());
    const int picked =
        choose(state, "bake:compression", own.empty() ? "Usual" : own, items, half_wide);
    ImGui::EndDisabled();
    if (picked >= 0) choices.tuning.compression = picked == 0 ? "" : known[picked - 1];
}

void draw_stored_row(State& state) {
    begin_control(state.fonts, "Stored as", bake_words::type);
    draw_stored(state);
    begin_control(state.fonts, "Compression", bake_words::compression, right_half);
    draw_compression(state);
}

void draw_tiles_row(State& state) {
    BakeChoices& choices = state.bake_dialog.choices;
    begin_control(state.fonts, "Tiled", bake_words::tile);
    const bool tiles = choices.tile_in(*choices.stored) == choices.tuning.tile;
    ImGui::BeginDisabled(!tiles || compressions_of(*choices.stored).empty());
    draw_numbers(state, "bake:tile", bake_tiles, choices.tuning.tile, half_wide,
                 [](uint32_t side) { return side ? std::to_string(side) + " px" : "In rows"; });
    ImGui::EndDisabled();
    begin_control(state.fonts, "UDIM", bake_words::udim, right_half);
    draw_box(state, "All tiles", "bake:udim", &choices.udim);
}

// Returns true on Enter.
bool draw_place_row(State& state) {
    BakeDialog& dialog = state.bake_dialog;
    begin_control(state.fonts, "Into", "A folder, or of one map its file; ~ is the home folder");
    std::string text = dialog.choices.into.string();
    const float wide = bake_wide - 2 * bake_padding - label_wide - 112;
    const bool entered = draw_control(state, "bake:into", wide, [&] {
        return ImGui::InputTextWithHint("##into", "A folder, or of one map its file", &text,
                                        ImGuiInputTextFlags_EnterReturnsTrue);
    });
    dialog.choices.into = text;
    ImGui::SameLine(0, 8);
    if (button(state, "Browse...", "bake:browse", false, {104, 0}))
        browse(state, Browser::Purpose::bake_into, output_folder(state, dialog.choices));
    return entered;
}

// Horizontal line between groups of rows.
void draw_rule() {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine(
        at + ImVec2(0, 2), at + ImVec2(bake_wide - 2 * bake_padding, 2), theme::border);
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 12);
}

}  // namespace

void draw_map_rows(State& state) {
    begin_control(state.fonts, "Mesh");
    choose_mesh(state, "bake", state.bake_dialog.choices.mesh, control_wide,
                Browser::Purpose::bake_mesh);
    draw_maps_row(state);
    draw_size_row(state);
    draw_scale_row(state);
}

bool draw_file_rows(State& state) {
    draw_packs_row(state);
    draw_rule();
    draw_normal_rows(state);
    draw_edge_rows(state);
    draw_rule();
    draw_stored_row(state);
    draw_tiles_row(state);
    return draw_place_row(state);
}

}  // namespace wrinkle::editor
