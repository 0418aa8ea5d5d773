// Start page, shown while there is no graph: drop area for images, buttons, recent files, and the
// samples: materials and techniques.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/file.h"
#include "base/folders.h"
#include "editor/view/commands/commands.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/browser.h"
#include "editor/view/panels/help.h"
#include "editor/view/panels/listing.h"
#include "editor/view/panels/panels.h"
#include "graph/read.h"

namespace wrinkle::editor {
namespace {

constexpr float drop_tall = 160, recent_tall = 24;
constexpr float card_width = 168, card_tall = 178, gap = 16, thumbnail_tall = 122;
constexpr int most_columns = 4;
constexpr size_t recent_shown = 5, name_lines = 3;
constexpr ImU32 thumbnail_ground = theme::rgb(0x282A2D);

void dash(ImDrawList& list, ImVec2 from, ImVec2 to) {
    const ImVec2 whole = to - from;
    const float length = std::max(std::abs(whole.x), std::abs(whole.y));
    for (float at = 0; at < length; at += 12)
        list.AddLine(from + whole * (at / length),
                     from + whole * (std::min(at + 7, length) / length), theme::control, 1.5F);
}

// Draws wrapped, centered lines of text; returns the y position below them.
float draw_centered(ImDrawList& list, const Fonts& fonts, bool bold, float size, ImVec2 at,
                    float width, ImU32 color, std::string_view words) {
    ImFont* font = bold ? fonts.bold(size) : fonts.regular(size);
    for (const std::string& line : wrapped(font, size, words, width - 32, 3)) {
        const float x = (width - text_width(font, size, line)) / 2;
        draw_text(list, font, size, at + ImVec2(x, 0), color, line);
        at.y += size + 4;
    }
    return at.y;
}

void draw_drop_area(Interface& interface, float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos(), end = at + ImVec2(width, drop_tall);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, end, theme::panel, 8);
    dash(list, at, {end.x, at.y});
    dash(list, {end.x, at.y}, end);
    dash(list, {at.x, end.y}, end);
    dash(list, at, {at.x, end.y});
    const bool narrow = width < 400;
    const float below = draw_centered(list, interface.fonts, true, narrow ? 18.0F : 24.0F,
                                      at + ImVec2(0, narrow ? 24 : 54), width, theme::text,
                                      "Drop two images here to layer them");
    draw_centered(
        list, interface.fonts, false, 16, {at.x, below + 8}, width, theme::text_dim,
        "Normal maps, heights and slopes are told apart by their pixels. Press I for a list.");
    name_area(interface, "start:drop", at, end);
    ImGui::Dummy({width, drop_tall});
}

void draw_buttons(State& state) {
    if (button(state, "New graph", "start:new", true, {132, 28})) state.start.left = true;
    const size_t left = state.keeping.recoverable.size();
    const std::string recover = "Recover " + counted(left, "unsaved graph");
    const std::pair<const char*, const char*> others[] = {{"open", "Open..."},
                                                          {"recover", recover.c_str()}};
    for (const auto& [id, title] : others) {
        const Command& command = *find_command(id);
        if (!command.enabled(state)) continue;
        ImGui::SameLine(0, 8);
        if (button(state, title, std::string("start:") + id, false, {0, 28})) command.run(state);
    }
}

// Draws the recent files; returns true if one was chosen, which changes the list.
bool draw_recent(State& state, float width) {
    const std::vector<std::filesystem::path>& recent = state.keeping.settings.recent;
    if (recent.empty()) return false;
    write_wrapped(state.fonts, "Recent", theme::text, true, 18);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, 0));
    std::filesystem::path taken;
    for (size_t i = 0; i < std::min(recent.size(), recent_shown); ++i) {
        const std::string target = "start:recent" + std::to_string(i + 1);
        const auto [at, end, pressed, hovered] = area_button(state, target, {width, recent_tall});
        if (pressed) taken = recent[i];
        ImDrawList& list = *ImGui::GetWindowDrawList();
        if (hovered) list.AddRectFilled(at, end, theme::accent_soft, 4);
        ImFont *font = state.fonts.regular(16), *small = state.fonts.regular(14);
        const std::string name = fitting(font, 16, recent[i].filename().string(), width / 2);
        draw_text(list, font, 16, at + ImVec2(8, 4), theme::text, name);
        const float x = 8 + text_width(font, 16, name) + 12;
        draw_text(list, small, 14, at + ImVec2(x, 5), theme::text_dim,
                  fitting(small, 14, recent[i].parent_path().string(), width - x - 8));
    }
    ImGui::PopStyleVar();
    ImGui::Dummy({1, 0});
    if (!taken.empty()) open_chosen(state, taken);
    return !taken.empty();
}

// Draws the uncropped image of a sample on the background color of the preview.
void draw_thumbnail(Interface& interface, ImDrawList& list, ImVec2 at, const Sample& sample) {
    const ImVec2 low = at + ImVec2(1, 1), high = at + ImVec2(card_width - 1, thumbnail_tall);
    list.AddRectFilled(low, high, thumbnail_ground, 6, ImDrawFlags_RoundCornersTop);
    if (!ImGui::IsItemVisible()) return;
    const uint32_t thumbnail = sample.image.empty()
                                   ? interface.graph_images.of({sample.file, {}, sample.registry})
                                   : interface.thumbnails.of(sample.image);
    if (!thumbnail) return;
    const float side = thumbnail_tall - 1, left = std::floor((card_width - side) / 2);
    list.AddImage(texture_id(thumbnail), at + ImVec2(left, 1),
                  at + ImVec2(left + side, thumbnail_tall), {0, 1}, {1, 0});
}

// Returns true if the card was clicked.
bool draw_card(Interface& interface, const Sample& sample) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string target =
        (sample.image.empty() ? "library:" : "sample:") + sample.file.stem().string();
    const auto [at, end, clicked, hovered] =
        area_button(interface, target, {card_width, card_tall});
    list.AddRectFilled(at, end, theme::node, 6);
    draw_thumbnail(interface, list, at, sample);
    list.AddRect(at, end, hovered ? theme::accent : theme::border, 6, 0, hovered ? 2 : 1);
    ImFont* bold = interface.fonts.bold(14);
    float y = thumbnail_tall + 3;
    for (const std::string& line : wrapped(bold, 14, sample.name, card_width - 20, name_lines)) {
        draw_text(list, bold, 14, at + ImVec2(10, y), theme::text, line);
        y += 15;
    }
    if (hovered) show_tooltip({at, end}, sample.name + ": " + counted(sample.nodes, "node"));
    return clicked;
}

// Draws the cards of the samples below a title; returns the file of the card that was clicked.
std::filesystem::path draw_cards(Interface& interface, const char* title,
                                 const std::vector<Sample>& samples, int columns) {
    std::filesystem::path taken;
    if (samples.empty()) return taken;
    write_wrapped(interface.fonts, title, theme::text, true, 18);
    for (size_t i = 0; i < samples.size(); ++i) {
        if (static_cast<int>(i) % columns != 0) ImGui::SameLine(0, gap);
        if (draw_card(interface, samples[i])) taken = samples[i].file;
    }
    return taken;
}

std::vector<Sample> library_samples(const State& state) {
    std::vector<Sample> samples;
    for (const LibraryEntry& entry : library_entries(state.keeping.folders)) {
        const auto found = list_samples(entry.file.parent_path());
        for (Sample sample : found) {
            if (sample.file != entry.file) continue;
            sample.image.clear();
            sample.registry = state.registry;
            samples.push_back(std::move(sample));
        }
    }
    return samples;
}

void draw_samples(State& state, int columns) {
    Start& start = state.start;
    if (!std::exchange(start.read, true)) {
        start.library = library_samples(state);
        start.materials = list_samples(samples_folder() / "materials");
        start.techniques = list_samples(samples_folder());
    }
    std::filesystem::path taken;
    for (const auto& [title, samples] :
         {std::pair{"Library", &start.library}, std::pair{"Materials", &start.materials},
          std::pair{"Techniques", &start.techniques}})
        if (auto other = draw_cards(state, title, *samples, columns); taken.empty())
            taken = std::move(other);
    if (!taken.empty()) open_chosen(state, taken);
}

}  // namespace

bool is_at_start(const State& state) {
    return !state.start.left && state.path.empty() && state.document().nodes.empty() &&
           !state.history.can_undo() && !state.history.can_redo();
}

void draw_start_page(State& state) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    state.view.corner = ImGui::GetCursorScreenPos();
    state.view.extent = room;
    name_area(state, "canvas", state.view.corner, state.view.corner + room);
    // The width is a multiple of the cards' width, so that all parts of the page are aligned.
    const float scrollbar = ImGui::GetStyle().ScrollbarSize;
    const int columns = std::clamp(
        static_cast<int>((room.x - scrollbar - gap) / (card_width + gap)), 1, most_columns);
    const float width = static_cast<float>(columns) * (card_width + gap) - gap;
    ImGui::BeginChild("##start", room, false, ImGuiWindowFlags_NoNavInputs);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, gap));
    ImGui::Indent(std::max(std::floor((room.x - scrollbar - width) / 2), 1.0F));
    ImGui::Dummy({1, std::max(std::floor((room.y - 720) / 2), 16.0F)});
    draw_drop_area(state, width);
    draw_buttons(state);
    if (!draw_recent(state, width)) draw_samples(state, columns);
    ImGui::Dummy({1, 16});
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

std::filesystem::path samples_folder() {
    std::error_code error;
    const std::filesystem::path program = program_folder();
    if (program.empty()) return {};
    for (const char* place : {"../share/wrinkle/graphs", "../../../graphs"}) {
        const std::filesystem::path folder = (program / place).lexically_normal();
        if (std::filesystem::exists(folder / "base_and_detail.json", error)) return folder;
    }
    return {};
}

std::vector<Sample> list_samples(const std::filesystem::path& folder) {
    std::vector<Sample> samples;
    const std::string extension = ".json";
    for (const Entry& entry : list_folder(folder, {&extension, 1}).entries) {
        const std::filesystem::path file = folder / entry.name, stem = file.stem();
        if (entry.folder || stem.extension() == ".test") continue;
        std::string why;
        const auto bytes = read_file(file, why);
        if (!bytes) continue;
        Diagnostics problems;
        const Document document = read_document(*bytes, file.string(), problems);
        if (problems.has_errors()) continue;
        samples.push_back({file, folder / "golden" / (stem.string() + ".png"),
                           document.name.empty() ? stem.string() : document.name,
                           document.nodes.size()});
    }
    std::ranges::sort(samples, name_before, &Sample::name);
    return samples;
}

}  // namespace wrinkle::editor
