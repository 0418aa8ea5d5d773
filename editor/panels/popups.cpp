#include "editor/panels/popups.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <deque>

#include "editor/canvas/field.h"
#include "editor/commands/commands.h"
#include "editor/look/theme.h"
#include "editor/panels/panels.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

const Port* port_of(const State& state) {
    const NodeType* type = state.type_of(state.popup.node);
    return type ? &type->ports[state.popup.port_index] : nullptr;
}

void accept_number(State& state) {
    const Port* port = port_of(state);
    char* end = nullptr;
    const double value = std::strtod(state.popup.text.c_str(), &end);
    if (!port || end == state.popup.text.c_str() || *end != 0) {
        state.status = "'" + state.popup.text + "' is not a number";
        return;
    }
    state.commit(state.popup.node + ": " + port->name,
                 with_number(state.document(), state.popup.node, *port, state.popup.lane, value));
}

void accept_name(State& state) {
    const std::string& wanted = state.popup.text;
    if (const std::string problem = id_problem(wanted); !problem.empty()) {
        state.status = "'" + wanted + "': " + problem;
    } else if (wanted != state.popup.node && state.document().find(wanted)) {
        state.status = "there is a node '" + wanted + "' already";
    } else {
        state.commit("Rename to " + wanted,
                     rename_node(state.document(), state.popup.node, wanted));
        state.view.selected = {wanted};
    }
}

// True when it is done with.
bool draw_text_entry(State& state) {
    if (state.popup.opening) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::InputText("##text", &state.popup.text,
                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll))
        return false;
    state.popup.kind == Popup::Kind::text ? accept_number(state) : accept_name(state);
    return true;
}

bool draw_list(State& state, const std::vector<std::string>& names, size_t& taken) {
    for (size_t i = 0; i < names.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const bool chosen = ImGui::Selectable(names[i].c_str());
        name_item(state, "choice:" + names[i]);
        ImGui::PopID();
        if (chosen) {
            taken = i;
            return true;
        }
    }
    return false;
}

bool draw_choices(State& state) {
    const Port* port = port_of(state);
    size_t taken = 0;
    if (!port || !draw_list(state, port->choices, taken)) return !port;
    state.commit(
        state.popup.node + ": " + port->name,
        with_choice(state.document(), state.popup.node, *port, static_cast<uint32_t>(taken)));
    return true;
}

bool draw_files(State& state) {
    const Port* port = port_of(state);
    const std::vector<std::string> files = state.popup.files;
    if (files.empty()) ImGui::TextDisabled("There are no images below the graph's folder.");
    size_t taken = 0;
    if (!port || !draw_list(state, files, taken)) return !port;
    state.commit(state.popup.node + ": " + port->name,
                 with_file(state.document(), state.popup.node, *port, files[taken]));
    return true;
}

bool draw_content(State& state) {
    switch (state.popup.kind) {
        case Popup::Kind::text:
        case Popup::Kind::rename:
            return draw_text_entry(state);
        case Popup::Kind::choice:
            return draw_choices(state);
        case Popup::Kind::file:
            return draw_files(state);
        case Popup::Kind::none:
            break;
    }
    return true;
}

}  // namespace

// Folder by folder, so that of too many files those nearest to the graph are found.
std::vector<std::string> image_files(const fs::path& folder, size_t limit, size_t most_entries) {
    constexpr std::string_view known[] = {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".hdr"};
    std::vector<std::string> files;
    std::deque<fs::path> folders{folder};
    size_t entries = 0;
    for (; !folders.empty() && files.size() < limit && entries < most_entries;
         folders.pop_front()) {
        std::set<fs::path> inner, images;
        std::error_code error, ignored;
        for (fs::directory_iterator at(folders.front(), error), end; !error && at != end;
             at.increment(error)) {
            if (++entries > most_entries) break;
            const std::string extension = at->path().extension().string();
            if (at->is_directory(ignored) && !at->is_symlink(ignored))
                inner.insert(at->path());
            else if (std::find(std::begin(known), std::end(known), extension) != std::end(known))
                images.insert(at->path());
        }
        folders.insert(folders.end(), inner.begin(), inner.end());
        for (const fs::path& image : images)
            if (files.size() < limit)
                files.push_back(image.lexically_relative(folder).generic_string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

void draw_popup(State& state) {
    if (state.popup.kind == Popup::Kind::none) return;
    const bool list =
        state.popup.kind == Popup::Kind::choice || state.popup.kind == Popup::Kind::file;
    ImGui::SetNextWindowPos(state.popup.at);
    const float width = std::max(state.popup.width, list ? 160.0F : 0.0F);
    ImGui::SetNextWindowSizeConstraints({width, 0}, {std::max(width, 360.0F), 320});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, list ? ImVec2(6, 6) : ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleColor(ImGuiCol_Border, theme::accent);
    if (state.popup.opening) ImGui::SetNextWindowFocus();
    if (!list) ImGui::SetNextWindowSize({width, 0});
    ImGui::Begin("##popup", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings |
                     (list ? ImGuiWindowFlags_AlwaysAutoResize : 0));
    const bool was_opening = state.popup.opening;
    const bool done = draw_content(state);
    const bool away = !was_opening && !ImGui::IsWindowFocused();
    state.popup.opening = false;
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
    if (done || away || ImGui::IsKeyPressed(ImGui::GetIO().KeyMap[ImGuiKey_Escape]))
        state.popup = {};
}

}  // namespace wrinkle::editor
