#include "editor/view/panels/bake_rows.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <iterator>

#include "bake/bake.h"
#include "editor/model/bake/bake.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/browser.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/preview_parts.h"
#include "mesh/shapes.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

constexpr float label_wide = 96, bake_row_tall = 36;
constexpr float control_wide = bake_wide - 2 * bake_padding - label_wide - picture_side - 16;
constexpr float half_wide = (bake_wide - 2 * bake_padding - 16) / 2 - label_wide;
constexpr float map_tall = 28, max_map_rows = 4;
constexpr const char* packs_tip =
    "Maps of others' channels, with a ; between two: orm: r=occlusion g=roughness b=metalness";

// Draws a label with a tooltip; the cursor is then at its control.
void begin_bake_row(const State& state, const char* label, const char* tip = nullptr) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text(*ImGui::GetWindowDrawList(), state.fonts.regular(16), 16, at + ImVec2(0, 4),
              theme::text_dim, label);
    const bool near = ImGui::IsWindowHovered() &&
                      ImGui::IsMouseHoveringRect(at, at + ImVec2(label_wide, bake_row_tall - 4));
    if (near && tip) show_tooltip({at, at + ImVec2(label_wide, bake_row_tall - 4)}, tip);
    ImGui::SetCursorScreenPos(at + ImVec2(label_wide, 0));
}

// Begins the right one of two controls in a row.
void begin_beside(const State& state, float top, const char* label, const char* tip = nullptr) {
    ImGui::SetCursorPos({bake_padding + label_wide + half_wide + 16, top});
    begin_bake_row(state, label, tip);
}

void end_bake_row(float top) {
    ImGui::SetCursorPosY(std::max(top + bake_row_tall, ImGui::GetCursorPosY()));
}

void draw_mesh_row(State& state) {
    const float top = ImGui::GetCursorPosY();
    begin_bake_row(state, "Mesh");
    std::string& mesh = state.bake_dialog.choices.mesh;
    Choices all = mesh_choices(mesh);
    for (std::string& target : all.targets)
        target.insert(0, "bake:");
    const std::string& shown = state.view.preview_view.mesh;
    const size_t shapes_end = all.labels.size();
    size_t file = shapes_end;  // index of a mesh file: the preview's, or the chosen one
    for (const std::string& each : {shown, mesh})
        if (!make_shape(each) && file == shapes_end) {
            all.labels.push_back(mesh_label(each));
            all.targets.emplace_back("bake:mesh:file");
            if (each == mesh) all.chosen = static_cast<int>(file);
        }
    all.labels.emplace_back("Choose a file...");
    all.targets.emplace_back("bake:mesh:browse");
    const int picked =
        choose(state, "##bake-mesh", "bake:mesh", mesh_label(mesh), all, control_wide);
    end_bake_row(top);
    if (picked < 0) return;
    const auto index = static_cast<size_t>(picked);
    if (index < shapes_end)
        mesh = shapes()[index].name;
    else if (index + 1 < all.labels.size())
        mesh = make_shape(shown) ? mesh : shown;
    else
        browse(state, Browser::Purpose::bake_mesh,
               make_shape(mesh) ? state.folder() / "x" : fs::path(mesh));
}

bool draw_box(State& state, const std::string& label, const std::string& target, bool* on) {
    ImGui::PushStyleColor(ImGuiCol_Border, theme::control);
    const bool changed = ImGui::Checkbox(label.c_str(), on);
    ImGui::PopStyleColor();
    name_item(state, target);
    return changed;
}

// Toggles `map` in the chosen maps, which stay in the order of `all`.
void tick(BakeChoices& choices, const std::vector<std::string>& all, const std::string& map) {
    std::vector<std::string> ticked;
    for (const std::string& each : all) {
        const bool was =
            std::find(choices.maps.begin(), choices.maps.end(), each) != choices.maps.end();
        if (was != (each == map)) ticked.push_back(each);
    }
    choices.maps = std::move(ticked);
}

void draw_maps_row(State& state) {
    BakeChoices& choices = state.bake_dialog.choices;
    const std::vector<std::string> all = maps_of(state.document());
    const float top = ImGui::GetCursorPosY();
    begin_bake_row(state, "Maps", bake_words::map);
    const auto rows = static_cast<float>((all.size() + 1) / 2);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::BeginChild("##maps", {control_wide, std::min(rows, max_map_rows) * map_tall}, false);
    ImGui::PopStyleVar();
    const float column = control_wide / 2;
    for (size_t i = 0; i < all.size(); ++i) {
        ImGui::SetCursorPos({i % 2 == 0 ? 0 : column, static_cast<float>(i / 2) * map_tall});
        bool on = std::find(choices.maps.begin(), choices.maps.end(), all[i]) != choices.maps.end();
        ImFont* font = state.fonts.regular(16);
        const std::string label = fitting(font, 16, all[i], column - 44) + "##" + all[i];
        if (draw_box(state, label, "bake:map:" + all[i], &on)) tick(choices, all, all[i]);
    }
    ImGui::EndChild();
    end_bake_row(top);
}

// Combo box of numbers; `word` returns the label of each.
template <class Numbers, class Word>
void draw_numbers(State& state, const char* id, const std::string& target, const Numbers& numbers,
                  uint32_t& chosen, float wide, Word word) {
    Choices all;
    for (const uint32_t each : numbers) {
        if (each == chosen) all.chosen = static_cast<int>(all.labels.size());
        all.labels.push_back(word(each));
        all.targets.push_back(target + ":" + std::to_string(each));
    }
    const int picked = choose(state, id, target, word(chosen), all, wide);
    if (picked >= 0) chosen = numbers[static_cast<size_t>(picked)];
}

// The map is square unless a height is chosen.
void draw_size_row(State& state) {
    BakeChoices& choices = state.bake_dialog.choices;
    const float top = ImGui::GetCursorPosY();
    constexpr float gap = 8, each_wide = (control_wide - gap) / 2;
    begin_bake_row(state, "Size", "Width and height of a map, in texels");
    draw_numbers(state, "##bake-size", "bake:size", bake_sizes, choices.width, each_wide,
                 [](uint32_t texels) { return grouped(texels) + " px"; });
    ImGui::SetCursorPos({bake_padding + label_wide + each_wide + gap, top});
    std::vector<uint32_t> heights(std::begin(bake_sizes), std::end(bake_sizes));
    heights.insert(heights.begin(), 0);
    draw_numbers(
        state, "##bake-height", "bake:height", heights, choices.square_or_height, each_wide,
        [](uint32_t texels) { return texels ? "\u00D7 " + grouped(texels) + " px" : "Square"; });
    end_bake_row(top);
}

// Two segments that set a flag.
void draw_ways(State& state, const Segment& off, const Segment& on, bool& way) {
    const Segment both[] = {off, on};
    const int picked = segments(state, both, way ? 1 : 0, half_wide);
    if (picked >= 0) way = picked == 1;
}

void draw_normal_rows(State& state) {
    BakeChoices& choices = state.bake_dialog.choices;
    const float top = ImGui::GetCursorPosY();
    begin_bake_row(state, "Space", "Of normals");
    draw_ways(state, {"Tangent", "bake:tangent", "The frame of the mesh's uvs"},
              {"Object", "bake:object", "The mesh's own axes"}, choices.object_space);
    begin_beside(state, top, "Green", "Of normals");
    draw_ways(state, {"Up (gl)", "bake:gl", "OpenGL, Blender, Unity, glTF"},
              {"Down (dx)", "bake:dx", "DirectX, Unreal"}, choices.green_down);
    end_bake_row(top);
}

void draw_scale_row(State& state) {
    const float top = ImGui::GetCursorPosY();
    begin_bake_row(state, "Scale", bake_words::scale);
    ImGui::SetNextItemWidth(control_wide);
    ImGui::PushStyleColor(ImGuiCol_Border, theme::control);
    ImGui::InputDouble("##bake-scale", &state.bake_dialog.choices.tuning.scale, 0, 0, "%g");
    ImGui::PopStyleColor();
    name_item(state, "bake:scale");
    end_bake_row(top);
}

void draw_packs_row(State& state) {
    const float top = ImGui::GetCursorPosY();
    begin_bake_row(state, "Packed", packs_tip);
    ImGui::SetNextItemWidth(bake_wide - 2 * bake_padding - label_wide);
    ImGui::PushStyleColor(ImGuiCol_Border, theme::control);
    ImGui::InputTextWithHint("##packs", "orm: r=occlusion g=roughness b=metalness",
                             &state.bake_dialog.choices.packs);
    ImGui::PopStyleColor();
    name_item(state, "bake:packs");
    end_bake_row(top);
}

void draw_edge_rows(State& state) {
    BakeTuning& tuning = state.bake_dialog.choices.tuning;
    const float top = ImGui::GetCursorPosY();
    begin_bake_row(state, "Samples", bake_words::samples);
    draw_numbers(state, "##bake-samples", "bake:samples", bake_sample_counts, tuning.samples,
                 half_wide, [](uint32_t count) { return std::to_string(count); });
    begin_beside(state, top, "Dilation", bake_words::dilate);
    ImGui::SetNextItemWidth(half_wide);
    ImGui::PushStyleColor(ImGuiCol_Border, theme::control);
    auto texels = static_cast<int>(tuning.dilate);
    ImGui::InputInt("##bake-dilate", &texels, 0, 0);
    ImGui::PopStyleColor();
    tuning.dilate = static_cast<uint32_t>(std::clamp(texels, 0, static_cast<int>(max_dilation)));
    name_item(state, "bake:dilate");
    end_bake_row(top);
}

void draw_stored(State& state) {
    BakeChoices& choices = state.bake_dialog.choices;
    Choices all;
    for (const StoredAs& each : stored_kinds()) {
        if (&each == choices.stored) all.chosen = static_cast<int>(all.labels.size());
        all.labels.emplace_back(each.label);
        all.targets.push_back("bake:stored:" + each.key);
    }
    for (std::string& target : all.targets)
        std::replace(target.begin(), target.end(), ' ', '-');
    const int picked =
        choose(state, "##bake-stored", "bake:stored", choices.stored->label, all, half_wide);
    if (picked >= 0) choices.stored = &stored_kinds()[static_cast<size_t>(picked)];
}

// Compression for the chosen format. A format without compression does not change the setting.
void draw_compression(State& state) {
    BakeChoices& choices = state.bake_dialog.choices;
    const std::vector<std::string_view> known = compressions_of(*choices.stored);
    const std::string own = choices.compression_in(*choices.stored);
    Choices all;
    all.labels = {"Usual"};
    all.targets = {"bake:compression:usual"};
    all.chosen = 0;
    for (const std::string_view each : known) {
        if (each == own) all.chosen = static_cast<int>(all.labels.size());
        all.labels.emplace_back(each);
        all.targets.push_back("bake:compression:" + std::string(each));
    }
    ImGui::BeginDisabled(known.empty());
    const int picked = choose(state, "##bake-compression", "bake:compression",
                              own.empty() ? "Usual" : own, all, half_wide);
    ImGui::EndDisabled();
    if (picked >= 0) choices.tuning.compression = picked == 0 ? "" : known[picked - 1];
}

void draw_stored_rows(State& state) {
    BakeChoices& choices = state.bake_dialog.choices;
    float top = ImGui::GetCursorPosY();
    begin_bake_row(state, "Stored as", bake_words::type);
    draw_stored(state);
    begin_beside(state, top, "Compression", bake_words::compression);
    draw_compression(state);
    end_bake_row(top);
    top = ImGui::GetCursorPosY();
    begin_bake_row(state, "Tiled", bake_words::tile);
    const bool tiles = choices.tile_in(*choices.stored) == choices.tuning.tile;
    ImGui::BeginDisabled(!tiles || compressions_of(*choices.stored).empty());
    draw_numbers(state, "##bake-tile", "bake:tile", bake_tiles, choices.tuning.tile, half_wide,
                 [](uint32_t side) { return side ? std::to_string(side) + " px" : "In rows"; });
    ImGui::EndDisabled();
    begin_beside(state, top, "UDIM", bake_words::udim);
    draw_box(state, "All tiles", "bake:udim", &choices.udim);
    end_bake_row(top);
}

// Returns true on Enter.
bool draw_place_row(State& state) {
    BakeDialog& dialog = state.bake_dialog;
    const float top = ImGui::GetCursorPosY();
    begin_bake_row(state, "Into", "A folder, or of one map its file; ~ is the home folder");
    std::string text = dialog.choices.into.string();
    ImGui::SetNextItemWidth(bake_wide - 2 * bake_padding - label_wide - 112);
    ImGui::PushStyleColor(ImGuiCol_Border, theme::control);
    const bool entered = ImGui::InputTextWithHint("##into", "A folder, or of one map its file",
                                                  &text, ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::PopStyleColor();
    name_item(state, "bake:into");
    dialog.choices.into = text;
    ImGui::SameLine(0, 8);
    if (button(state, "Browse...", "bake:browse", false, {104, 0}))
        browse(state, Browser::Purpose::bake_into, place_of(state, dialog.choices));
    end_bake_row(top);
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
    draw_mesh_row(state);
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
    draw_stored_rows(state);
    return draw_place_row(state);
}

}  // namespace wrinkle::editor
