// List of problems, one row each: node, message, location in the file, and a button for a fix that
// is certain to help. A click frames the node.
#include <algorithm>

#include "editor/model/images/remarks.h"
#include "editor/view/canvas/canvas.h"
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

struct Row {
    const Diagnostic* problem;
    const ImageWarning* remark = nullptr;  // set for a remark on an image
    bool of_task = false;                  // a warning of a background task

    bool can_go() const { return remark || of_task; }  // without a fix
};

// Returns the problems of the graph, or of the preview if the graph has none, then those of the
// plugins, the remarks on images, and the warnings of background tasks on this graph.
std::vector<Row> rows_of(const State& state) {
    const Diagnostics& own =
        state.built.problems.list().empty() ? state.preview_problems : state.built.problems;
    std::vector<Row> rows;
    for (const Diagnostics* each : {&own, &state.plugins.problems})
        for (const Diagnostic& problem : each->list())
            rows.push_back({&problem});
    for (const ImageWarning& remark : state.images.remarks)
        rows.push_back({&remark.problem, &remark});
    if (state.tasks.warnings_of == state.path)
        for (const Diagnostic& problem : state.tasks.warnings.list())
            rows.push_back({&problem, nullptr, true});
    return rows;
}

bool is_open(const State& state) {
    return !rows_of(state).empty() &&
           (state.panes.problems > 0 || ImGui::GetIO().DisplaySize.y >= low_window);
}

std::string counts(const std::vector<Row>& rows) {
    if (rows.empty()) return "No problems.";
    const auto errors = static_cast<size_t>(std::ranges::count(
        rows, Severity::error, [](const Row& row) { return row.problem->severity; }));
    return counted(rows.size() - errors, "warning") + ", " + counted(errors, "error");
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
};
enum class Pressed : uint8_t { nothing, fix, dismissal };

void dismiss(Session& session, const Row& row) {
    if (row.remark) return dismiss_remark(session, *row.remark);
    Diagnostics rest;
    for (const Diagnostic& each : session.tasks.warnings.list())
        if (&each != row.problem) rest.add(each);
    session.tasks.warnings = std::move(rest);
}

bool is_wrong_wire(const Session& session, const Node& node, const Port& port) {
    const Input* input = node.find(port.name);
    if (!input || input->kind != Input::Kind::link || !port.is_value()) return false;
    const auto given = session.model.type_of(input->link);
    return !given || conversion(*given, port.type) == Conversion::illegal;
}

Fix fix_of(const Session& session, const Row& row) {
    if (row.remark) return {row.remark->remedy.label};
    const Diagnostic& problem = *row.problem;
    const Node* node = session.document().find(problem.node);
    const NodeType* type = node ? session.type_of(node->id) : nullptr;
    const std::string name = port_of(problem);
    const uint32_t index = type ? type->find_input(name) : NodeType::none;
    if (index == NodeType::none || problem.severity != Severity::error || row.of_task) return {};
    const Port& port = type->ports[index];
    if (is_wrong_wire(session, *node, port)) return {"Disconnect", false, node->id, name};
    const Input* input = node->find(name);
    const bool linked = input && input->kind == Input::Kind::link;
    if (port.type == PortType::image_ && port.is_value() && !linked)
        return {"Choose image...", true, node->id, name};
    return {};
}

void apply(State& state, const Row& row, const Fix& fix) {
    if (row.remark) return apply_remedy(state, *row.remark);
    if (!fix.chooses_image) {
        state.commit("Disconnect " + fix.node + "." + fix.port,
                     without_wire(state.document(), fix.node, fix.port));
        return;
    }
    const Card* found = state.layout.find(fix.node);
    if (!found) return;
    const Card card = *found;
    state.view.selected = {fix.node};
    show_nodes(state, true);
    for (const Field& field : card.fields)
        if (field.port == fix.port) return open_field(state, card, field);
}

void show_problem(State& state, size_t index) {
    const Diagnostic& problem = *rows_of(state)[index].problem;
    state.problems.current = index;
    const std::string id = top_of(problem.node);
    state.status = sentence(problem.message);
    if (!state.document().find(id)) return;
    state.view.selected = {id};
    show_nodes(state, true);
}

// Draws an octagon with an exclamation mark for an error, a triangle for a warning.
void draw_severity(ImDrawList& list, ImVec2 center, bool error) {
    if (!error) return draw_warning(list, center, 20, theme::warn);
    list.AddNgonFilled(center, 11, theme::error, 8);
    list.AddRectFilled(center + ImVec2(-1, -6), center + ImVec2(1, 2), theme::panel);
    list.AddRectFilled(center + ImVec2(-1, 4), center + ImVec2(1, 6), theme::panel);
}

// Returns the x offset of the message.
float draw_chip(const Fonts& fonts, ImDrawList& list, ImVec2 at, const std::string& node) {
    if (node.empty()) return 44;
    ImFont* font = fonts.bold(16);
    const std::string shown_name = fitting(font, 16, node, 200);
    const float width = text_width(font, 16, shown_name) + 16;
    list.AddRectFilled(at + ImVec2(44, 8), at + ImVec2(44 + width, 30), theme::node, 4);
    list.AddRect(at + ImVec2(44, 8), at + ImVec2(44 + width, 30), theme::border, 4);
    draw_text(list, font, 16, at + ImVec2(52, 11), theme::text, shown_name);
    return 44 + width + 10;
}

// Draws the buttons from right to left, from the right border of the row.
Pressed draw_fixes(Interface& interface, const Row& row, const Fix& fix, ImVec2 right,
                   const std::string& number) {
    const ImVec2 next = ImGui::GetCursorPos();
    Pressed pressed = Pressed::nothing;
    const auto draw = [&](const std::string& label, const char* target, Pressed means) {
        right.x -= fix_wide;
        ImGui::SetCursorScreenPos(right);
        if (button(interface, label.c_str(), target + number, false, {fix_wide, 28}))
            pressed = means;
        right.x -= 8;
    };
    if (row.can_go()) draw("Dismiss", "dismiss:", Pressed::dismissal);
    if (!fix.label.empty()) draw(fix.label, "fix:", Pressed::fix);
    ImGui::SetCursorPos(next);
    return pressed;
}

// Draws the message and the evidence; `right`: the x offset of the buttons.
void draw_words(const Fonts& fonts, const Area& area, const Diagnostic& problem, float right) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = area.low;
    const std::string message = sentence(problem.message), more = evidence(problem);
    ImFont *font = fonts.regular(16), *small = fonts.regular(14);
    const float x = draw_chip(fonts, list, at, problem.node);
    const std::string first = fitting(font, 16, message, right - x);
    const std::string second = fitting(small, 14, more, right - 44);
    draw_text(list, font, 16, at + ImVec2(x, 11), theme::text, first);
    draw_text(list, small, 14, at + ImVec2(44, 35), theme::text_dim, second);
    const ImVec2 corner = ImGui::GetWindowPos();
    if (area.hovered && (first != message || second != more))
        show_tooltip({corner, corner + ImGui::GetWindowSize()}, message + "\n" + more);
}

// Returns true if the problem is to be dismissed.
bool draw_problem(State& state, const Row& row, size_t index) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0F);
    const std::string number = std::to_string(index + 1);
    const Area area = area_button(state, "problem:" + number, {width, problem_tall - 6});
    ImGui::SetItemAllowOverlap();
    list.AddRect(area.low, area.high,
                 area.hovered                      ? theme::accent
                 : index == state.problems.current ? theme::text_dim
                                                   : theme::border,
                 6);
    draw_severity(list, area.low + ImVec2(22, 28), row.problem->severity == Severity::error);
    const Fix fix = fix_of(state, row);
    const int buttons = !fix.label.empty() + row.can_go();
    draw_words(state.fonts, area, *row.problem,
               width - 12 - (fix_wide + 8) * static_cast<float>(buttons));
    const Pressed pressed = draw_fixes(state, row, fix, area.low + ImVec2(width - 8, 14), number);
    if (pressed == Pressed::fix)
        apply(state, row, fix);
    else if (area.pressed && pressed == Pressed::nothing)
        show_problem(state, index);
    return pressed == Pressed::dismissal;
}

void draw_problems_head(State& state) {
    const std::vector<Row> rows = rows_of(state);
    const ImVec2 at = ImGui::GetWindowPos();
    const float width = ImGui::GetWindowWidth();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = is_open(state) ? 9 : 5;
    const float name = text_width(state.fonts.bold(18), 18, "Problems");
    draw_text(list, state.fonts.bold(18), 18, at + ImVec2(12, y), theme::text, "Problems");
    draw_text(list, state.fonts.regular(14), 14, at + ImVec2(name + 26, y + 3), theme::text_dim,
              counts(rows));
    if (rows.empty()) return;
    ImGui::SetCursorPos({0, 0});
    const float tall = is_open(state) ? open_head : closed_height;
    if (area_button(state, "problems", {width - 150, tall}).pressed)
        state.panes.problems = state.panes.problems > 0 ? 0 : opened;
    draw_text(list, state.fonts.regular(14), 14, at + ImVec2(width - 14, y + 3), theme::text_dim,
              "Next problem  F8", true);
    ImGui::SetCursorPos({width - 150, 0});
    if (area_button(state, "problems:next", {150, closed_height}).pressed) next_problem(state);
}

}  // namespace

std::string_view no_problems(const State& state) {
    return rows_of(state).empty() ? "There are no problems." : "";
}

void next_problem(State& state) {
    const size_t count = rows_of(state).size();
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
    return open_head + problem_tall * static_cast<float>(rows_of(state).size()) + foot;
}

void draw_problems(State& state) {
    const std::vector<Row> rows = rows_of(state);
    draw_problems_head(state);
    if (rows.empty()) state.problems = {};
    if (!is_open(state)) return;
    ImGui::SetCursorPosY(open_head);
    ImGui::BeginChild("##problems", {0, 0}, false, ImGuiWindowFlags_NoNavInputs);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 6));
    if (state.problems.scroll)
        ImGui::SetScrollY(static_cast<float>(state.problems.current) * problem_tall);
    state.problems.scroll = false;
    const Row* dismissed = nullptr;
    draw_rows(rows.size(), problem_tall, [&](size_t index) {
        if (draw_problem(state, rows[index], index)) dismissed = &rows[index];
    });
    if (dismissed) dismiss(state, *dismissed);
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

}  // namespace wrinkle::editor
