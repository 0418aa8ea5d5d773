
#include "editor/model/images/facts.h"
#include "editor/model/images/remarks.h"
#include "editor/view/edit/layer.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/help.h"
#include "editor/view/panels/panels.h"
#include "lower/literal.h"

namespace wrinkle::editor {
namespace {

constexpr float fact_names = 120;

void draw_facts(const Fonts& fonts, const Examined& examined) {
    for (const Fact& fact : facts_of(examined)) {
        write_wrapped(fonts, fact.name, theme::text_dim);
        ImGui::SameLine(fact_names + ImGui::GetStyle().WindowPadding.x);
        write_wrapped(fonts, fact.value, theme::text);
    }
}

// Returns true if a button was pressed, which changes the list of remarks.
bool draw_remark(State& state, const ImageWarning& remark, const std::string& number) {
    ImGui::Dummy({1, 4});
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_warning(*ImGui::GetWindowDrawList(), at + ImVec2(9, 10), 18, theme::warn);
    ImGui::Indent(28);
    write_wrapped(state.fonts, sentence(remark.problem.message), theme::text);
    if (!remark.problem.expected.empty())
        write_wrapped(state.fonts, sentence(remark.problem.expected), theme::text_dim, false, 14);
    const std::string& label = remark.remedy.label;
    const bool mends =
        !label.empty() && button(state, label.c_str(), "image:fix:" + number, false, {132, 28});
    if (!label.empty()) ImGui::SameLine(0, 8);
    const bool goes = button(state, "Dismiss", "image:dismiss:" + number, false, {132, 28});
    ImGui::Unindent(28);
    if (mends)
        apply_remedy(state, remark);
    else if (goes)
        dismiss_remark(state, remark);
    return mends || goes;
}

void draw_remarks(State& state, const std::string& node, const std::string& port) {
    size_t count = 0;
    for (const ImageWarning& remark : state.images.remarks) {
        if (remark.problem.node != node || remark.port != port) continue;
        ImGui::PushID(static_cast<int>(++count));
        const bool done = draw_remark(state, remark, std::to_string(count));
        ImGui::PopID();
        if (done) return;
    }
}

void draw_section(State& state, const std::string& node, const std::string& port,
                  const std::string& file) {
    ImGui::Dummy({1, 6});
    write_wrapped(state.fonts, "Image", theme::text, true, 18);
    write_wrapped(state.fonts, file, theme::text_dim, false, 14);
    const Node* found = state.document().find(node);
    const Examined* examined = found ? examined_at(state, *found, port) : nullptr;
    if (!examined) {
        const auto path = state.images.paths.find(file);
        const bool waits = path != state.images.paths.end() && state.images.busy();
        return write_wrapped(state.fonts,
                             waits ? "It is being looked at." : "It was not looked at.",
                             theme::text_dim);
    }
    if (!examined->problem.empty())
        return write_wrapped(state.fonts, sentence(examined->problem), theme::warn);
    draw_facts(state.fonts, *examined);
    draw_remarks(state, node, port);
}

}  // namespace

void draw_image_sections(State& state, const Node& node) {
    const NodeType* type = state.type_of(node.id);
    if (!type) return;
    const std::string id = node.id;  // a copy, as a remedy replaces the node
    std::vector<std::pair<std::string, std::string>> read;
    for (const Input& input : node.inputs)
        if (input.kind == Input::Kind::literal && image_port(*type, input.port))
            if (const auto file = literal_image(input.value).file; !file.empty())
                read.emplace_back(input.port, file);
    for (const auto& [port, file] : read)
        draw_section(state, id, port, file);
}

std::string image_words(const Session& session, const std::string& node, const std::string& port) {
    const Node* found = session.document().find(node);
    const Examined* examined = found ? examined_at(session, *found, port) : nullptr;
    if (!examined) return {};
    return sentence(examined->problem.empty() ? summary_of(*examined) : examined->problem);
}

}  // namespace wrinkle::editor
