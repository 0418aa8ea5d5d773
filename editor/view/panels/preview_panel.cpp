// Preview panel: header, views, image and comparison.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "editor/view/commands/commands.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/browser.h"
#include "editor/view/panels/dialog_rows.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/preview_parts.h"
#include "mesh/shapes.h"

namespace wrinkle::editor {
namespace {

constexpr float preview_head = 34, strip_height = 32, time_height = 34;

// Lights that can be chosen: the moods, a file if there is one, and Phong's.
constexpr gpu::Mood shown_moods[] = {gpu::Mood::studio, gpu::Mood::overcast, gpu::Mood::contrast,
                                     gpu::Mood::sun};

struct Light {
    Item item;
    gpu::Lighting lighting = gpu::Lighting::ggx;
    gpu::Mood mood = gpu::Mood::studio;
    std::string file = {};

    bool shown_in(const PreviewView& view) const {
        if (lighting != view.lighting || lighting == gpu::Lighting::phong)
            return lighting == view.lighting;
        return file == view.environment && (!file.empty() || mood == view.mood);
    }
};

std::vector<Light> lights(const PreviewView& view) {
    std::vector<Light> all;
    for (const gpu::Mood mood : shown_moods) {
        const std::string name(gpu::mood_names()[static_cast<size_t>(mood)]);
        all.push_back({{capitalised(name), "light:" + name}, gpu::Lighting::ggx, mood});
    }
    all.push_back({{"Phong", "light:phong"}, gpu::Lighting::phong});
    if (const std::string& file = view.environment; !file.empty())
        all.push_back({{std::filesystem::path(file).filename().string(), "light:file"},
                       gpu::Lighting::ggx,
                       view.mood,
                       file});
    return all;
}

void choose_light(State& state, float width) {
    PreviewView& view = state.view.preview_view;
    const std::vector<Light> all = lights(view);
    std::vector<Item> items;
    std::string shown;
    for (const Light& light : all) {
        items.push_back(light.item);
        if (light.shown_in(view)) shown = light.item.label;
    }
    items.push_back({"Choose a file...", "light:browse"});
    const int picked = choose(state, "preview:light", shown, items, width);
    if (picked < 0) return;
    if (static_cast<size_t>(picked) == all.size()) {
        const std::filesystem::path& file = view.environment;
        return browse(state, Browser::Purpose::preview_light,
                      file.empty() ? state.folder() / "x" : file);
    }
    const Light& light = all[static_cast<size_t>(picked)];
    view.lighting = light.lighting;
    if (light.lighting == gpu::Lighting::phong) return;
    view.mood = light.mood;
    view.environment = light.file;
}

void edit_path(Interface& interface, const char* label, const char* hint, const char* target,
               std::string& path, const char* none) {
    std::string text = path;
    ImGui::TextUnformatted(label);
    ImGui::SetNextItemWidth(280);
    ImGui::PushID(label);
    if (ImGui::InputTextWithHint("##path", hint, &text, ImGuiInputTextFlags_EnterReturnsTrue))
        path = text.empty() ? none : text;
    ImGui::PopID();
    name_item(interface, target);
}

void draw_more(State& state) {
    PreviewView& view = state.view.preview_view;
    if (icon_button(state, "more", "preview:more", "Scale, displacement, files"))
        ImGui::OpenPopup("preview-more");
    const PanelPopup popup("preview-more");
    if (!popup) return;
    ImGui::SetNextItemWidth(150);
    ImGui::DragFloat("Object scale", &view.scale, 0.01F, 0.01F, 100.0F, "%.2f x",
                     ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    name_item(state, "preview:scale");
    ImGui::Checkbox("Displaced", &view.displaced);
    name_item(state, "preview:displaced");
    edit_path(state, "Mesh file", "teapot.glb", "preview:mesh-file", view.mesh, "sphere");
    edit_path(state, "Environment", "sky.hdr", "preview:environment-file", view.environment, "");
}

std::string what_is_shown(const Session& session) {
    const std::string& node = session.follow.drawn.request.node;
    return node.empty() ? "output: normal" : "node: " + node + ", preview only";
}

// Icon button of a command; the tooltip has its title and keys.
void draw_command(State& state, const char* id, const char* icon, const char* target) {
    const Command& command = *find_command(id);
    const std::string why(command.why_not(state));
    std::string words = std::string(command.title) + "  " + std::string(command.keys);
    if (!why.empty()) words += "\n" + why;
    if (icon_button(state, icon, target, words, why.empty())) command.run(state);
    ImGui::SameLine(0, 4);
}

void draw_head_icons(State& state) {
    draw_command(state, "save-picture", "camera", "preview:picture");
    draw_command(state, "frame-preview", "fit", "preview:frame");
    Pane& maximised = state.panes.maximised;
    const bool whole = maximised == Pane::preview;
    if (icon_button(state, whole ? "restore" : "maximise", "preview:maximise",
                    whole ? "Back to its place  F11" : "As large as the window  F11"))
        maximised = whole ? Pane::none : Pane::preview;
    ImGui::SameLine(0, 4);
    draw_more(state);
}

void draw_preview_head(State& state) {
    const ImVec2 at = ImGui::GetWindowPos();
    const float width = ImGui::GetWindowWidth();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_text(list, state.fonts.bold(18), 18, at + ImVec2(12, 8), theme::text, "Preview");
    constexpr float icons = 4 * 28 + 8;
    const float controls = std::min(icons + 208, width - 84);
    ImFont* small = state.fonts.regular(14);
    const float free = width - controls - 106;
    if (free >= 60)
        draw_text(list, small, 14, at + ImVec2(90, 10), theme::text_dim,
                  fitting(small, 14, what_is_shown(state), free));
    PreviewView& view = state.view.preview_view;
    const float room = std::floor((controls - icons - 16) / 2);
    ImGui::SetCursorPos({width - controls, 5});
    choose_mesh(state, "preview", view.mesh, room, Browser::Purpose::preview_mesh);
    ImGui::SameLine(0, 6);
    choose_light(state, room);
    ImGui::SameLine(0, 8);
    draw_head_icons(state);
}

// Play or pause, a bar of the seconds, and back to the value of the input.
void draw_time(State& state, ImVec2 at, float width) {
    Play& play = state.play;
    ImGui::SetCursorScreenPos(at + ImVec2(12, 2));
    draw_command(state, "play", play.running ? "pause" : "play", "time:play");
    float seconds = static_cast<float>(play.seconds.value_or(0));
    ImGui::SetNextItemWidth(width - 24 - 2 * 32);
    if (ImGui::SliderFloat("##time", &seconds, 0, static_cast<float>(time_end(state)),
                           play.seconds ? "%.2f s" : "value of the input",
                           ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput)) {
        play.seconds = static_cast<double>(seconds);
        play.running = false;
    }
    name_item(state, "time:bar");
    ImGui::SameLine(0, 4);
    if (icon_button(state, "cross", "time:reset", "Show the value of the input",
                    play.seconds.has_value())) {
        play.seconds.reset();
        play.running = false;
    }
}

void draw_preview_strip(State& state) {
    constexpr gpu::View views[] = {gpu::View::shaded, gpu::View::normal, gpu::View::gradient,
                                   gpu::View::height, gpu::View::uv,     gpu::View::wireframe};
    PreviewView& view = state.view.preview_view;
    const float width = ImGui::GetWindowWidth() - 24;
    std::vector<Item> all;
    int chosen = -1;
    for (const gpu::View each : views) {
        const std::string name(gpu::view_names()[static_cast<size_t>(each)]);
        const std::string label = each == gpu::View::uv ? "UV" : capitalised(name);
        if (each == view.view) chosen = static_cast<int>(all.size());
        const std::string key = std::to_string(all.size() + 1);
        all.push_back({label, "view:" + name, label + "  " + key});
    }
    const auto flat = static_cast<int>(all.size());
    all.push_back({"2D", "view:flat", "Values of a node in 2D  7"});
    if (state.view.flat.on) chosen = flat;
    ImGui::SetCursorPos({12, preview_head + 2});
    const std::string shown = chosen < 0 ? "Difference" : all[static_cast<size_t>(chosen)].label;
    const int picked = width >= 540 ? segments(state, all, chosen, width)
                                    : choose(state, "preview:view", shown, all, width);
    if (picked < 0) return;
    state.view.flat.on = picked == flat;
    if (picked != flat) view.view = views[picked];
}

}  // namespace

std::string capitalised(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

std::string mesh_label(const std::string& mesh) {
    return is_shape(mesh) ? capitalised(mesh) : std::filesystem::path(mesh).filename().string();
}

void draw_preview(State& state) {
    const ImVec2 corner = ImGui::GetWindowPos(), whole = ImGui::GetWindowSize();
    draw_preview_head(state);
    draw_preview_strip(state);
    const float compare = compare_height(whole.x);
    const ImVec2 at = corner + ImVec2(0, preview_head + strip_height);
    const float time = has_time(state) && !state.view.flat.on ? time_height : 0;
    const ImVec2 size(whole.x, whole.y - preview_head - strip_height - time - compare);
    if (size.x >= 1 && size.y >= 1)
        state.view.flat.on ? draw_flat(state, at, size) : draw_preview_image(state, at, size);
    if (time > 0) draw_time(state, corner + ImVec2(0, whole.y - compare - time), whole.x);
    draw_compare(state, corner + ImVec2(0, whole.y - compare), whole.x);
}

}  // namespace wrinkle::editor
