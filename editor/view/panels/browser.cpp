#include "editor/view/panels/browser.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "editor/model/code/code.h"
#include "editor/model/document/files.h"
#include "editor/model/document/intent.h"
#include "editor/view/drop/drop.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"
#include "editor/view/preview/image_export.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

using Purpose = Browser::Purpose;
constexpr float file_tall = 28, places_width = 176;

struct PurposeInfo {
    const char* title;
    void (*take)(State&, const fs::path& file);  // uses the chosen file
    std::vector<std::string> extensions;         // files to list
    const char* added = "";  // extension of a name without one, if it saves; not of a text
    bool saves = false;
};

void take_export_image(State& state, const fs::path& file) {
    const std::vector<ImageSize> sizes = image_sizes(state);
    start_image_export(state, file, sizes[std::min(state.browser.size, sizes.size() - 1)]);
}

void take_image(State& state, const fs::path& file) {
    use_image(state, state.browser.node, state.browser.port, file.string());
}

// The suffixes of all targets' texts, in both forms.
std::vector<std::string> text_extensions() {
    std::vector<std::string> extensions{".frag", ".vert"};
    for (const Target& target : targets())
        extensions.emplace_back(function_suffix(target));
    return extensions;
}

std::vector<std::string> mesh_extensions() {
    return {".obj", ".gltf", ".glb"};
}

const PurposeInfo& info(Purpose purpose) {
    static const PurposeInfo infos[] = {
        {"", nullptr, {}},
        {"Open a graph", open_chosen, {".json"}},
        {"Save the graph as", save_chosen, {".json"}, ".json", true},
        {"Export GLSL", [](State& s, const fs::path& file) { start_code_export(s, file); },
         text_extensions(), "", true},
        {"Save the image of the preview",
         take_export_image,
         {".png", ".jpg", ".jpeg", ".tif", ".tiff"},
         ".png",
         true},
        {"Choose an image",
         take_image,
         {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".hdr", ".pfm", ".pnm", ".ppm"}},
        {"Choose a mesh",
         [](State& s, const fs::path& file) { s.bake_dialog.choices.mesh = file.string(); },
         mesh_extensions()},
        {"Bake into a folder, or a file",
         [](State& s, const fs::path& file) { s.bake_dialog.choices.into = file; },
         {".png", ".tif", ".exr"},
         "",
         true},
        {"Choose a mesh",
         [](State& s, const fs::path& file) { s.host_dialog.choices.mesh = file.string(); },
         mesh_extensions()},
        {"Export into a folder",
         [](State& s, const fs::path& file) { s.host_dialog.choices.into = file; },
         {},
         "",
         true},
        {"Choose a mesh",
         [](State& s, const fs::path& file) { s.view.preview_view.mesh = file.string(); },
         mesh_extensions()},
        {"Choose an environment",
         [](State& s, const fs::path& file) { s.view.preview_view.environment = file.string(); },
         {".hdr", ".exr"}},
    };
    return infos[static_cast<size_t>(purpose)];
}

bool saves(const Browser& browser) {
    return info(browser.purpose).saves;
}

void go_to(Browser& browser, const fs::path& folder) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(folder, error);
    browser.folder = error ? folder : whole;
    browser.listing = list_folder(browser.folder, info(browser.purpose).extensions);
    browser.chosen = 0;
    browser.focus = true;
    browser.shown = filtered(browser.listing, "");
    if (!saves(browser)) browser.text.clear();
    browser.filtered_by = browser.text;
}

std::string with_extension(const State& state, const std::string& name) {
    if (fs::path(name).has_extension()) return name;
    const bool text = state.browser.purpose == Purpose::export_text;
    return name + (text ? export_suffix(state.code.options) : info(state.browser.purpose).added);
}

// Opens the chosen folder or takes the chosen file. Returns true when the browser is to be closed.
bool enter_chosen(State& state) {
    Browser& browser = state.browser;
    const Entry entry = browser.listing.entries[browser.shown[static_cast<size_t>(browser.chosen)]];
    const fs::path path = browser.folder / entry.name;
    entry.folder ? go_to(browser, path) : info(browser.purpose).take(state, path);
    return !entry.folder;
}

// Uses the typed path or the chosen entry. Returns true when the browser is to be closed.
bool enter(State& state) {
    Browser& browser = state.browser;
    std::error_code ignored;
    const bool path = browser.text.find('/') != browser.text.npos || browser.text == "..";
    const fs::path typed = browser.folder / with_home(browser.text);
    if (path && fs::is_directory(typed, ignored)) {
        browser.text.clear();
        go_to(browser, typed);
        return false;
    }
    const bool named = saves(browser) || path;
    if (named || browser.shown.empty()) {
        if (browser.text.empty() || (!named && browser.purpose != Purpose::open_graph))
            return false;
        info(browser.purpose).take(state, with_extension(state, typed.string()));
        return true;
    }
    return enter_chosen(state);
}

bool draw_field(State& state) {
    Browser& browser = state.browser;
    if (browser.focus) focus_field(state);
    browser.focus = false;
    ImGui::SetNextItemWidth(-1);
    const bool was_empty = browser.text.empty();
    const char* hint = saves(browser) ? "Name of the file" : "Type a part of the name, or a path";
    const bool entered = ImGui::InputTextWithHint("##name", hint, &browser.text,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    note_field(state);
    name_item(state, "browser:name");
    name_item(state, "answer:path");
    write_paragraph(theme::error, browser.error_text);
    if (was_empty && browser.text.empty() && is_pressed(ImGuiKey_Backspace, false))
        go_to(browser, browser.folder.parent_path());
    if (entered) browser.focus = true;
    if (browser.filtered_by != browser.text) {
        browser.filtered_by = browser.text;
        browser.chosen = 0;
        if (!saves(browser)) browser.shown = filtered(browser.listing, browser.text);
    }
    return entered;
}

// Breadcrumb of the current path, one button for each folder.
void draw_path(State& state) {
    Browser& browser = state.browser;
    fs::path whole, wanted;
    int index = 0;
    for (const fs::path& part : browser.folder) {
        whole /= part;
        ImGui::PushID(index);
        if (index > 0) ImGui::SameLine(0, 2);
        if (button(state, part.string().c_str(), "browser:part" + std::to_string(index)))
            wanted = whole;
        ImGui::PopID();
        ++index;
    }
    if (!wanted.empty()) go_to(browser, wanted);
}

void draw_places(State& state) {
    ImGui::BeginChild("##places", {places_width, -36}, false);
    std::vector<std::pair<std::string, fs::path>> places{{"Graph's folder", state.folder()}};
    if (const char* home = std::getenv("HOME")) places.emplace_back("Home", home);
    for (const fs::path& file : state.keeping.settings.recent)
        places.emplace_back(file.filename().string(), file);
    std::error_code ignored;
    for (size_t i = 0; i < places.size(); ++i) {
        const auto& [name, path] = places[i];
        const bool folder = fs::is_directory(path, ignored);
        if (!folder && state.browser.purpose != Purpose::open_graph) continue;
        ImGui::PushID(static_cast<int>(i));
        const bool taken = ImGui::Selectable(name.c_str(), false, 0, {places_width - 12, 22});
        name_item(state, "browser:place" + std::to_string(i));
        if (ImGui::IsItemHovered()) show_tooltip(beside_window(), path.string());
        ImGui::PopID();
        if (taken && folder) go_to(state.browser, path);
        if (taken && !folder) {
            open_chosen(state, path);
            state.browser = {};
            break;
        }
    }
    ImGui::EndChild();
}

void paint_entry(State& state, const Entry& entry, ImVec2 low, ImVec2 high, bool chosen) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool has_thumbnail = state.browser.purpose == Purpose::image && !entry.folder;
    const uint32_t thumbnail =
        has_thumbnail ? state.thumbnails.of(state.browser.folder / entry.name) : 0;
    if (chosen) list.AddRectFilled(low, high, theme::accent_soft, 4);
    if (entry.folder) {
        list.AddRectFilled(low + ImVec2(9, 8), low + ImVec2(16, 12), theme::text_dim, 1);
        list.AddRectFilled(low + ImVec2(9, 10), low + ImVec2(25, 21), theme::text_dim, 2);
    } else if (thumbnail) {
        list.AddImage(texture_id(thumbnail), low + ImVec2(5, 2), low + ImVec2(29, 26), {0, 1},
                      {1, 0});
    } else {
        list.AddRect(low + ImVec2(11, 6), low + ImVec2(23, 22), theme::text_dim, 2, 0, 1.5F);
    }
    ImFont* font = state.fonts.regular(16);
    draw_text(list, font, 16, low + ImVec2(36, 6), theme::text,
              fitting(font, 16, entry.name, high.x - low.x - 44));
}

// Returns true if the entry was clicked and is a folder, or was double-clicked.
bool draw_entry(State& state, int index) {
    Browser& browser = state.browser;
    const Entry& entry = browser.listing.entries[browser.shown[static_cast<size_t>(index)]];
    const ImVec2 size(std::max(ImGui::GetContentRegionAvail().x, 1.0F), file_tall);
    const Area area = area_button(state, "file:" + entry.name, size);
    if (area.pressed) {
        browser.chosen = index;
        if (saves(browser) && !entry.folder) browser.text = entry.name;
    }
    paint_entry(state, entry, area.low, area.high, index == browser.chosen);
    return (area.pressed && entry.folder) || (area.hovered && ImGui::IsMouseDoubleClicked(0));
}

// Returns true if a folder was clicked or a file double-clicked; it is then the chosen entry.
bool draw_list(State& state) {
    Browser& browser = state.browser;
    bool taken = false;
    ImGui::BeginChild("##entries", {0, -36}, true, ImGuiWindowFlags_NoNavInputs);
    if (!browser.listing.error_text.empty()) {
        write_paragraph(theme::text, browser.listing.error_text);
    } else if (browser.shown.empty()) {
        ImGui::TextDisabled("%s", browser.listing.entries.empty() ? "Nothing here can be opened."
                                                                  : "No name matches.");
    }
    if (browser.scroll) ImGui::SetScrollY(static_cast<float>(browser.chosen - 5) * file_tall);
    browser.scroll = false;
    draw_rows(browser.shown.size(), file_tall,
              [&](size_t row) { taken |= draw_entry(state, static_cast<int>(row)); });
    ImGui::EndChild();
    return taken;
}

void move_choice(Browser& browser) {
    const int before =
        std::exchange(browser.chosen, moved_choice(browser.chosen, browser.shown.size(), 12));
    browser.scroll |= browser.chosen != before;
}

void draw_sizes(State& state) {
    std::vector<Item> items;
    for (const ImageSize& size : image_sizes(state))
        items.push_back({grouped(static_cast<size_t>(size.width)) + " \u00D7 " +
                             grouped(static_cast<size_t>(size.height)) + " px",
                         "size:" + std::to_string(items.size())});
    size_t& chosen = state.browser.size;
    chosen = std::min(chosen, items.size() - 1);
    const int picked = choose(state, "browser:size", items[chosen].label, items, 176);
    if (picked >= 0) chosen = static_cast<size_t>(picked);
    ImGui::SameLine();
}

// Returns true when the browser is to be closed.
bool draw_content(State& state) {
    Browser& browser = state.browser;
    draw_text(*ImGui::GetWindowDrawList(), state.fonts.bold(24), 24, ImGui::GetCursorScreenPos(),
              theme::text, info(browser.purpose).title);
    ImGui::Dummy({1, 28});
    draw_path(state);
    bool done = draw_field(state) && enter(state);
    move_choice(browser);
    draw_places(state);
    if (browser.purpose == Purpose::none) return true;
    ImGui::SameLine();
    if (draw_list(state)) done |= enter_chosen(state);
    if (browser.purpose == Purpose::export_image) draw_sizes(state);
    const std::string label = saves(browser) ? "Save" : "Open";
    if (button(state, label.c_str(), "browser:take", true, {104, 28})) done |= enter(state);
    name_item(state, saves(browser) ? "answer:save" : "answer:open");
    ImGui::SameLine();
    const bool escape = is_pressed(ImGuiKey_Escape);
    return button(state, "Cancel", "browser:cancel", false, {104, 28}) || escape || done;
}

}  // namespace

void browse(Dialogs& dialogs, Purpose purpose, const fs::path& file) {
    Browser browser;
    browser.purpose = purpose;
    if (saves(browser)) browser.text = file.filename().string();
    const fs::path folder = file.parent_path();
    go_to(browser, folder.empty() ? fs::path(".") : folder);
    dialogs.browser = std::move(browser);
}

void browse_image(State& state, const std::string& node, const std::string& port) {
    browse(state, Purpose::image, image_folder(state) / "x");
    state.browser.node = node;
    state.browser.port = port;
}

namespace {

// Opens the browser for a question of kind open or save_as.
void take_question(State& state) {
    const Question asked = std::exchange(state.question, {});
    const bool saving = asked.kind == Question::Kind::save_as;
    const fs::path file = asked.text.empty() ? state.folder() / (saving ? state.file_name() : "x")
                                             : fs::path(asked.text);
    browse(state, saving ? Purpose::save_graph : Purpose::open_graph, file);
    if (!saving) state.browser.text = asked.text.empty() ? "" : file.filename().string();
    state.browser.then = asked.then;
    state.browser.error_text = asked.error_text;
}

}  // namespace

void draw_browser(State& state) {
    if (state.question.wants_path()) take_question(state);
    if (state.browser.purpose == Purpose::none) return;
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const ImVec2 size(std::min(760.0F, room.x - 32), std::min(560.0F, room.y - 32));
    const Dialog dialog("##browser", size, {24, 20}, 0);
    if (!dialog || !draw_content(state)) return;
    ImGui::CloseCurrentPopup();
    state.browser = {};
}

void open_chosen(State& state, const fs::path& file) {
    state.question = {.kind = Question::Kind::open, .text = file.string()};
    answer_path(state);
}

void save_chosen(State& state, const fs::path& file) {
    state.question = {
        .kind = Question::Kind::save_as, .then = state.browser.then, .text = file.string()};
    answer_path(state);
}

}  // namespace wrinkle::editor
