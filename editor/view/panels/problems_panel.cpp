// List of problems, one row each: node, message, location in the file, and a button for a fix that
// is certain to help. A click frames the node.
#include <algorithm>
#include <optional>

#include "editor/model/images/remarks.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"
#include "lower/conversion.h"

namespace wrinkle::editor {
namespace {

constexpr float closed_height = 28, open_head = 36, problem_tall = 62, foot = 6;
constexpr float fix_wide = 132;
constexpr float opened = 0.25F;    // panel height opened by a click, fraction of the work area
constexpr float low_window = 800;  // lower windows show only the header until it is clicked

// Returns the warnings of background tasks for the open graph.
const std::vector<Diagnostic>& told(const State& state) {
    static const std::vector<Diagnostic> none;
    return state.tasks.warnings_of == state.path ? state.tasks.warnings.list() : none;
}

// Returns the problems of the graph, or of the preview if the graph has none, then those of the
// plugins, the remarks on images, and the warnings of background tasks.
std::vector<const Diagnostic*> shown(const State& state) {
    const Diagnostics& own =
        state.built.problems.list().empty() ? state.preview_problems : state.built.problems;
    std::vector<const Diagnostic*> all;
    for (const Diagnostic& problem : own.list())
        all.push_back(&problem);
    for (const Diagnostic& problem : state.plugins.problems.list())
        all.push_back(&problem);
    for (const ImageWarning& remark : state.images.remarks)
        all.push_back(&remark.problem);
    for (const Diagnostic& problem : told(state))
        all.push_back(&problem);
    return all;
}

bool is_open(const State& state) {
    return !shown(state).empty() &&
           (state.panes.problems > 0 || ImGui::GetIO().DisplaySize.y >= low_window);
}

std::string counts(const std::vector<const Diagnostic*>& problems) {
    const size_t all = problems.size();
    const auto errors =
        static_cast<size_t>(std::count_if(problems.begin(), problems.end(), [](const auto* each) {
            return each->severity == Severity::error;
        }));
    if (all == 0) return "No problems.";
    return counted(all - errors, "warning") + ", " + counted(errors, "error");
}

std::string evidence(const Diagnostic& problem) {
    std::string text = sentence(problem.expected);
    const bool whole_file = problem.where.line == 0;
    if (whole_file && (problem.where.file.empty() || !problem.node.empty())) return text;
    if (!text.empty()) text += "   ";
    if (whole_file) return text + problem.where.file;
    return text + problem.where.file + ", line " + std::to_string(problem.where.line) +
           ", column " + std::to_string(problem.where.column);
}

std::string top_of(const std::string& path) {
    return path.substr(0, path.find('/'));
}

// Returns the port of the problem from its JSON pointer: "image" for "/nodes/weave/in/image"; "" if
// there is none.
std::string port_of(const Diagnostic& problem) {
    const std::string mark = "/in/";
    const size_t at = problem.pointer.rfind(mark);
    if (at == problem.pointer.npos || top_of(problem.node) != problem.node) return {};
    const std::string rest = problem.pointer.substr(at + mark.size());
    return rest.substr(0, rest.find('/'));
}

struct Fix {
    std::string label = {};      // "": there is no certain fix
    bool chooses_image = false;  // true: choose an image; false: disconnect the wire
    std::string node = {}, port = {};
    const ImageWarning* remark = nullptr;  // if set, the fix is its remedy
    bool can_go = false;                   // the row can be dismissed without a fix

    int buttons() const { return (label.empty() ? 0 : 1) + (can_go ? 1 : 0); }
};
enum class Pressed : uint8_t { nothing, fix, dismissal };

// Removes the warning at this index of the background tasks' warnings.
void dismiss(State& state, size_t index) {
    Diagnostics rest;
    const std::vector<Diagnostic>& all = state.tasks.warnings.list();
    for (size_t i = 0; i < all.size(); ++i)
        if (i != index) rest.add(all[i]);
    state.tasks.warnings = std::move(rest);
}

bool is_wrong_wire(const State& state, const Node& node, const Port& port) {
    const Input* input = node.find(port.name);
    if (!input || input->kind != Input::Kind::link || !port.is_value()) return false;
    const auto given = state.model.type_of(input->link);
    return !given || conversion(*given, port.type) == Conversion::illegal;
}

Fix fix_of(const State& state, const Diagnostic& problem) {
    const Node* node = state.document().find(problem.node);
    const NodeType* type = node ? state.type_of(node->id) : nullptr;
    const std::string name = port_of(problem);
    const uint32_t index = type ? type->find_input(name) : NodeType::none;
    if (index == NodeType::none || problem.severity != Severity::error) return {};
    const Port& port = type->ports[index];
    if (is_wrong_wire(state, *node, port)) return {"Disconnect", false, node->id, name};
    const Input* input = node->find(name);
    const bool linked = input && input->kind == Input::Kind::link;
    if (port.type == PortType::image_ && port.is_value() && !linked)
        return {"Choose image...", true, node->id, name};
    return {};
}

// Returns the fix of the problem at this index; `own`: number of rows before the remarks.
Fix fix_at(const State& state, const Diagnostic& problem, size_t index, size_t own) {
    if (index < own) return fix_of(state, problem);
    Fix fix;
    fix.can_go = true;
    if (index - own >= state.images.remarks.size()) return fix;
    fix.remark = &state.images.remarks[index - own];
    fix.label = fix.remark->remedy.label;
    return fix;
}

void apply(State& state, const Fix& fix) {
    if (fix.remark) return apply_remedy(state, *fix.remark);
    if (!fix.chooses_image) {
        state.commit("Disconnect " + fix.node + "." + fix.port,
                     without_wire(state.document(), fix.node, fix.port));
        return;
    }
    const Card* found = state.layout.find(fix.node);
    if (!found) return;
    const Card card = *found;
    state.view.selected = {fix.node};
    fit(state.view, state.layout, true);
    for (const Field& field : card.fields)
        if (field.port == fix.port) return open_field(state, card, field);
}

void show_problem(State& state, size_t index) {
    const Diagnostic& problem = *shown(state)[index];
    state.problems.current = index;
    const std::string id = top_of(problem.node);
    state.status = sentence(problem.message);
    if (!state.document().find(id)) return;
    state.view.selected = {id};
    fit(state.view, state.layout, true);
}

// Draws an octagon with an exclamation mark for an error, a triangle for a warning.
void draw_severity(ImDrawList& list, ImVec2 center, bool error) {
    if (!error) return draw_warning(list, center, 20, theme::warn);
    list.AddNgonFilled(center, 11, theme::error, 8);
    list.AddRectFilled(center + ImVec2(-1, -6), center + ImVec2(1, 2), theme::panel);
    list.AddRectFilled(center + ImVec2(-1, 4), center + ImVec2(1, 6), theme::panel);
}

// Returns the x offset of the message.
float draw_chip(const State& state, ImDrawList& list, ImVec2 at, const std::string& node) {
    if (node.empty()) return 44;
    ImFont* font = state.fonts.bold(16);
    const std::string shown_name = fitting(font, 16, node, 200);
    const float width = text_width(font, 16, shown_name) + 16;
    list.AddRectFilled(at + ImVec2(44, 8), at + ImVec2(44 + width, 30), theme::node, 4);
    list.AddRect(at + ImVec2(44, 8), at + ImVec2(44 + width, 30), theme::border, 4);
    draw_text(list, font, 16, at + ImVec2(52, 11), theme::text, shown_name);
    return 44 + width + 10;
}

// Draws the buttons from right to left, from the right border of the row.
Pressed draw_fixes(State& state, const Fix& fix, ImVec2 right, size_t index) {
    const ImVec2 next = ImGui::GetCursorPos();
    const std::string number = std::to_string(index + 1);
    Pressed pressed = Pressed::nothing;
    const auto draw = [&](const std::string& label, const char* target, Pressed means) {
        right.x -= fix_wide;
        ImGui::SetCursorScreenPos(right);
        if (button(state, label.c_str(), target + number, false, {fix_wide, 28})) pressed = means;
        right.x -= 8;
    };
    if (fix.can_go) draw("Dismiss", "dismiss:", Pressed::dismissal);
    if (!fix.label.empty()) draw(fix.label, "fix:", Pressed::fix);
    ImGui::SetCursorPos(next);
    return pressed;
}

Pressed draw_problem(State& state, const Diagnostic& problem, size_t index, const Fix& fix) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0F);
    const ImVec2 size(width, problem_tall - 6);
    const std::string message = sentence(problem.message);
    ImGui::PushID(static_cast<int>(index));
    const bool clicked = ImGui::InvisibleButton("problem", size, ImGuiButtonFlags_None);
    ImGui::SetItemAllowOverlap();
    const std::string target = "problem:" + std::to_string(index + 1);
    name_area(state, target, at, at + size);
    const bool current = index == state.problems.current;
    list.AddRect(at, at + size,
                 ImGui::IsItemHovered() ? theme::accent
                 : current              ? theme::text_dim
                                        : theme::border,
                 6);
    draw_severity(list, at + ImVec2(22, 28), problem.severity == Severity::error);
    const Fonts& fonts = state.fonts;
    const float right = width - 12 - (fix_wide + 8) * static_cast<float>(fix.buttons());
    const float x = draw_chip(state, list, at, problem.node);
    draw_text(list, fonts.regular(16), 16, at + ImVec2(x, 11), theme::text,
              fitting(fonts.regular(16), 16, message, right - x));
    draw_text(list, fonts.regular(14), 14, at + ImVec2(44, 35), theme::text_dim,
              fitting(fonts.regular(14), 14, evidence(problem), right - 44));
    const ImVec2 corner = ImGui::GetWindowPos();
    const About panel{corner, corner + ImGui::GetWindowSize()};
    const bool cut = text_width(fonts.regular(16), 16, message) > right - x ||
                     text_width(fonts.regular(14), 14, evidence(problem)) > right - 44;
    if (ImGui::IsItemHovered() && cut) show_tooltip(panel, message + "\n" + evidence(problem));
    const Pressed pressed = draw_fixes(state, fix, at + ImVec2(width - 8, 14), index);
    ImGui::PopID();
    if (pressed == Pressed::fix)
        apply(state, fix);
    else if (clicked && pressed == Pressed::nothing)
        show_problem(state, index);
    return pressed;
}

void draw_problems_head(State& state) {
    const std::vector<const Diagnostic*> problems = shown(state);
    const ImVec2 at = ImGui::GetWindowPos();
    const float width = ImGui::GetWindowWidth();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = is_open(state) ? 9 : 5;
    const float name = text_width(state.fonts.bold(18), 18, "Problems");
    draw_text(list, state.fonts.bold(18), 18, at + ImVec2(12, y), theme::text, "Problems");
    draw_text(list, state.fonts.regular(14), 14, at + ImVec2(name + 26, y + 3), theme::text_dim,
              counts(problems));
    if (problems.empty()) return;
    ImGui::SetCursorPos({0, 0});
    if (ImGui::InvisibleButton("head", {width - 150, is_open(state) ? open_head : closed_height}))
        state.panes.problems = state.panes.problems > 0 ? 0 : opened;
    name_item(state, "problems");
    draw_text(list, state.fonts.regular(14), 14, at + ImVec2(width - 14, y + 3), theme::text_dim,
              "Next problem  F8", true);
    ImGui::SetCursorPos({width - 150, 0});
    if (ImGui::InvisibleButton("next", {150, closed_height})) next_problem(state);
    name_item(state, "problems:next");
}

}  // namespace

std::string_view no_problems(const State& state) {
    return shown(state).empty() ? "There are no problems." : "";
}

void next_problem(State& state) {
    const size_t count = shown(state).size();
    if (count == 0) return;
    if (ImGui::GetIO().DisplaySize.y < low_window && state.panes.problems <= 0)
        state.panes.problems = opened;
    const bool before = state.problems.visited && state.problems.current < count;
    state.problems.visited = true;
    show_problem(state, before ? (state.problems.current + 1) % count : 0);
    state.problems.scroll = true;
}

float problems_height(const State& state) {
    if (!is_open(state)) return closed_height;
    return open_head + problem_tall * static_cast<float>(shown(state).size()) + foot;
}

void draw_problems(State& state) {
    const std::vector<const Diagnostic*> problems = shown(state);
    const size_t remarks = state.images.remarks.size();
    const size_t own = problems.size() - told(state).size() - remarks;
    draw_problems_head(state);
    if (problems.empty()) state.problems = {};
    if (!is_open(state)) return;
    ImGui::SetCursorPosY(open_head);
    ImGui::BeginChild("##problems", {0, 0}, false, ImGuiWindowFlags_NoNavInputs);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 6));
    if (state.problems.scroll)
        ImGui::SetScrollY(static_cast<float>(state.problems.current) * problem_tall);
    state.problems.scroll = false;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(problems.size()), problem_tall);
    std::optional<size_t> dismissed;
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto index = static_cast<size_t>(i);
            const Fix fix = fix_at(state, *problems[index], index, own);
            if (draw_problem(state, *problems[index], index, fix) == Pressed::dismissal)
                dismissed = index - own;
        }
    if (dismissed && *dismissed < remarks)
        dismiss_remark(state, state.images.remarks[*dismissed]);
    else if (dismissed)
        dismiss(state, *dismissed - remarks);
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

}  // namespace wrinkle::editor
