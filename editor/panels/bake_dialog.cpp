#include "editor/panels/bake_dialog.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <iterator>

#include "editor/bake/bake.h"
#include "editor/document/words.h"
#include "editor/look/draw.h"
#include "editor/look/theme.h"
#include "editor/panels/browser.h"
#include "editor/panels/panels.h"
#include "editor/panels/preview_parts.h"
#include "mesh/shapes.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

constexpr float bake_wide = 560, bake_padding = 24, label_wide = 84, picture_side = 160;
constexpr float control_wide = bake_wide - 2 * bake_padding - label_wide - picture_side - 16;
constexpr float map_tall = 28, most_map_rows = 4;
constexpr size_t most_names = 4;  // of files that are listed one by one

void begin_bake_row(const State& state, const char* label) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text(*ImGui::GetWindowDrawList(), state.fonts.regular(16), 16, at + ImVec2(0, 4),
              theme::text_dim, label);
    ImGui::SetCursorScreenPos(at + ImVec2(label_wide, 0));
}

void end_bake_row(float top) {
    ImGui::SetCursorPosY(std::max(top + 36, ImGui::GetCursorPosY()));
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
    size_t file = shapes_end;  // behind it: of the preview, or chosen here
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

// The graph's maps that are ticked, in their order.
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
    begin_bake_row(state, "Maps");
    const auto rows = static_cast<float>((all.size() + 1) / 2);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::BeginChild("##maps", {control_wide, std::min(rows, most_map_rows) * map_tall}, false);
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

void draw_size_row(State& state) {
    uint32_t& size = state.bake_dialog.choices.size;
    const float top = ImGui::GetCursorPosY();
    begin_bake_row(state, "Size");
    Choices all;
    for (const uint32_t each : bake_sizes) {
        if (each == size) all.chosen = static_cast<int>(all.labels.size());
        all.labels.push_back(grouped(each) + " px");
        all.targets.push_back("bake:size:" + std::to_string(each));
    }
    const int picked =
        choose(state, "##bake-size", "bake:size", grouped(size) + " px", all, control_wide);
    if (picked >= 0) size = bake_sizes[picked];
    end_bake_row(top);
}

// Two ways, side by side.
void draw_ways(State& state, const char* label, const Segment& off, const Segment& on, bool& way) {
    const float top = ImGui::GetCursorPosY();
    begin_bake_row(state, label);
    const Segment both[] = {off, on};
    const int picked = segments(state, both, way ? 1 : 0, control_wide);
    if (picked >= 0) way = picked == 1;
    end_bake_row(top);
}

void draw_stored_row(State& state) {
    BakeChoices& choices = state.bake_dialog.choices;
    const float top = ImGui::GetCursorPosY();
    begin_bake_row(state, "Stored as");
    Choices all;
    for (const StoredAs& each : stored_kinds()) {
        if (&each == choices.stored) all.chosen = static_cast<int>(all.labels.size());
        all.labels.emplace_back(each.label);
        all.targets.push_back("bake:stored:" + std::string(each.key));
    }
    for (std::string& target : all.targets)
        std::replace(target.begin(), target.end(), ' ', '-');
    const int picked = choose(state, "##bake-stored", "bake:stored",
                              std::string(choices.stored->label), all, control_wide);
    if (picked >= 0) choices.stored = &stored_kinds()[static_cast<size_t>(picked)];
    ImGui::SameLine(0, 16);
    draw_box(state, "UDIM tiles", "bake:udim", &choices.udim);
    end_bake_row(top);
}

// True on Enter.
bool draw_place_row(State& state) {
    BakeDialog& dialog = state.bake_dialog;
    const float top = ImGui::GetCursorPosY();
    begin_bake_row(state, "Into");
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
        browse(state, Browser::Purpose::bake_into, state.folder() / dialog.choices.into);
    end_bake_row(top);
    return entered;
}

// What is shown on the object now, its middle square.
void draw_object(const State& state, ImVec2 at) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end = at + ImVec2(picture_side, picture_side);
    list.AddRectFilled(at, end, theme::rgb(0x212326), 4);
    const PreviewPicture* shown = state.preview ? &state.preview->shown() : nullptr;
    if (shown && shown->texture && shown->width > 0 && shown->height > 0) {
        const auto wide = static_cast<float>(shown->width),
                   tall = static_cast<float>(shown->height);
        const float side = std::min(wide, tall), x = side / wide / 2, y = side / tall / 2;
        list.AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(shown->texture)),
                             at, end, {0.5F - x, 0.5F + y}, {0.5F + x, 0.5F - y}, IM_COL32_WHITE,
                             4);
    }
    list.AddRect(at, end, theme::border, 4);
}

std::string what_is_replaced(const State& state) {
    BakeChoices choices = state.bake_dialog.choices;
    choices.into = state.folder() / choices.into;
    std::vector<std::string> there;
    std::error_code error;
    for (const fs::path& file : baked_files(choices))
        if (fs::exists(file, error)) there.push_back(file.filename().string());
    if (there.empty()) return {};
    if (there.size() > most_names) return counted(there.size(), "file") + " there are replaced.";
    return listed(there) +
           (there.size() == 1 ? " is there already and is" : " are there already and are") +
           " replaced.";
}

void draw_sentence(ImU32 color, const std::string& text) {
    if (text.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(bake_wide - bake_padding);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void draw_consequences(State& state) {
    BakeDialog& dialog = state.bake_dialog;
    if (!dialog.looked || *dialog.looked != dialog.choices) {
        dialog.looked = dialog.choices;
        dialog.replaces = what_is_replaced(state);
    }
    const std::string why = why_no_bake(state);
    draw_sentence(why.empty() ? theme::text_dim : theme::warn,
                  why.empty() ? what_is_written(dialog.choices) : why);
    draw_sentence(theme::warn, dialog.replaces);
    if (state.view.preview_view.scale != 1)
        draw_sentence(theme::text_dim, "The mesh is taken in its own size, not in the preview's.");
    ImGui::Dummy({0, 8});
}

// True when the dialog is done with.
bool draw_bake_buttons(State& state, bool entered) {
    const bool ready = why_no_bake(state).empty();
    const auto pressed = [](ImGuiKey key) {
        return ImGui::IsKeyPressed(ImGui::GetIO().KeyMap[key], false);
    };
    const bool alone = !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
    ImGui::BeginDisabled(!ready);
    ImGui::PushStyleColor(ImGuiCol_Button, theme::accent_fill);
    ImGui::PushStyleColor(ImGuiCol_Text, theme::on_accent);
    bool bake = button(state, "Bake", "bake:start", false, {104, 28});
    ImGui::PopStyleColor(2);
    ImGui::EndDisabled();
    const bool enter = entered || (alone && !ImGui::IsAnyItemActive() && pressed(ImGuiKey_Enter));
    bake |= enter && ready && !state.bake_dialog.opening;
    ImGui::SameLine();
    const bool cancel = button(state, "Cancel", "bake:cancel", false, {104, 28});
    if (bake) start_bake(state, state.bake_dialog.choices);
    return bake || cancel || (alone && pressed(ImGuiKey_Escape));
}

bool draw_bake_rows(State& state) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text(*ImGui::GetWindowDrawList(), state.fonts.bold(24), 24, at, theme::text, "Bake maps");
    ImGui::Dummy({1, 32});
    draw_object(state, at + ImVec2(bake_wide - 2 * bake_padding - picture_side, 40));
    BakeChoices& choices = state.bake_dialog.choices;
    draw_mesh_row(state);
    draw_maps_row(state);
    draw_size_row(state);
    draw_ways(state, "Space",
              {"Tangent", "bake:tangent", "Of normals: the frame of the mesh's uvs"},
              {"Object", "bake:object", "Of normals: the mesh's own axes"}, choices.object_space);
    draw_ways(state, "Green", {"Up (gl)", "bake:gl", "OpenGL, Blender, Unity, glTF"},
              {"Down (dx)", "bake:dx", "DirectX, Unreal"}, choices.green_down);
    draw_stored_row(state);
    const bool entered = draw_place_row(state);
    draw_consequences(state);
    return draw_bake_buttons(state, entered);
}

}  // namespace

std::string why_no_bake(const State& state) {
    const BakeChoices& choices = state.bake_dialog.choices;
    if (choices.maps.empty()) return "Choose a map.";
    if (choices.into.empty()) return "Say where the maps go.";
    if (state.built.problems.has_errors())
        return "The graph has errors. They are in the list of problems.";
    if (state.tasks.running) return state.tasks.running->order().name + " is not done yet.";
    return {};
}

std::string what_is_written(const BakeChoices& choices) {
    const std::vector<fs::path> files = baked_files(choices, choices.udim ? ".1001" : "");
    const bool many = files.size() > most_names;
    std::vector<std::string> names;
    for (const fs::path& file : files)
        names.push_back(file.filename().string());
    std::string text = "Writes " + (many ? counted(files.size(), "map") : listed(names));
    if (!choices.one_file()) text += " into " + choices.into.string();
    return text + (choices.udim ? ", and so on for each tile." : ".");
}

void open_bake_dialog(State& state) {
    state.bake_dialog = {};
    state.bake_dialog.choices = usual_bake(state);
    state.bake_dialog.open = state.bake_dialog.opening = true;
}

void draw_bake_dialog(State& state) {
    BakeDialog& dialog = state.bake_dialog;
    if (!dialog.open || state.question.open() || state.browser.purpose != Browser::Purpose::none)
        return;
    if (!ImGui::IsPopupOpen("##bake")) ImGui::OpenPopup("##bake");
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({room.x / 2, room.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({bake_wide, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(bake_padding, 20));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8);
    const bool shown =
        ImGui::BeginPopupModal("##bake", nullptr,
                               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar(2);  // lists and tooltips have their own
    if (!shown) return;
    const bool done = draw_bake_rows(state);
    dialog.opening = false;
    if (done) dialog = {};
    if (done || state.browser.purpose != Browser::Purpose::none) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace wrinkle::editor
