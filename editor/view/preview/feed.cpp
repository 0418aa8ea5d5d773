#include "editor/view/preview/feed.h"

#include <algorithm>

#include "editor/model/document/field.h"
#include "emit/log.h"

namespace wrinkle::editor {
namespace {

// Returns the uniforms of the running program for a port of the document, which may have been
// renamed since: one, or several if nodes were copied for a comparison.
std::vector<const UniformInfo*> uniforms_at(const CompileState& follow,
                                            const Change::Place& place) {
    std::vector<const UniformInfo*> found;
    const Build& drawn = follow.drawn;
    if (!drawn.running() || place.index >= drawn.document.nodes.size()) return found;
    const std::string& node = drawn.document.nodes[place.index]->id;
    for (const UniformInfo& uniform : drawn.running()->reflection.uniforms) {
        if (uniform.graph_input || uniform.port != place.port) continue;
        const auto copy = drawn.copied.find(uniform.node);
        if (uniform.node == node || (copy != drawn.copied.end() && copy->second == node))
            found.push_back(&uniform);
    }
    return found;
}

// The running program may have no uniform for a port because it does not read it; compilation
// determines whether that is so.
bool all_are_uniforms(const CompileState& follow, const Change& difference) {
    if (difference.kind == Change::Kind::structure) return false;
    return std::ranges::all_of(difference.values, [&](const Change::Place& place) {
        return !uniforms_at(follow, place).empty();
    });
}

void send(State& state, const Change::Place& place) {
    const Node* node = state.document().find(place.node);
    const NodeType* type = state.type_of(place.node);
    const Port* port = input_port(type, place.port);
    if (!node || !port) return;
    const auto numbers = numbers_at(*node, *port);
    const auto lanes = static_cast<size_t>(lanes_of(port->type));
    float values[4];
    for (size_t i = 0; i < lanes; ++i)
        values[i] = static_cast<float>(numbers[i]);
    ++state.counters.uniforms;
    if (!state.preview) return;
    for (const UniformInfo* uniform : uniforms_at(state.follow, place))
        state.preview->set_uniform(uniform->name, {values, lanes});
    if (state.timings) state.timings->values(state.preview->asked() + 1);
}

}  // namespace

PreviewRequest wanted_request(const State& state) {
    PreviewRequest request = state.view.preview_request;
    request.displaced = state.view.preview_view.displaced;
    if (state.preview) request.double_sided = state.preview->newest().double_sided;
    if (state.view.compare.mode == CompareView::Mode::off) {
        request.against = Against::nothing;
        request.name.clear();
    }
    if (!request.node.empty() && !state.document().find(request.node)) request.node.clear();
    return request;
}

void forget_files(PreviewState& state, Use use) {
    if (state.preview && (use == Use::image || use == Use::mesh || use == Use::light))
        state.preview->forget(use);
    if (use == Use::image) ++state.node_feed.images;
}

bool send_values(State& state) {
    CompileState& follow = state.follow;
    const Change difference = change(follow.sent_snapshot, state.document());
    if (!all_are_uniforms(follow, difference)) return false;
    for (const Change::Place& place : difference.values)
        send(state, place);
    follow.sent_snapshot = state.document();
    return true;
}

void apply_latest_build(State& state) {
    CompileState& follow = state.follow;
    const Build& built = state.built;
    state.preview_stale = !built.running();
    if (!built.running()) return;
    const bool same_kind = follow.drawn.running() && follow.drawn.request == built.request &&
                           !follow.drawn.displacement && !built.displacement;
    if (same_kind && all_are_uniforms(follow, change(follow.drawn.document, built.document))) {
        send_values(state);
        return;
    }
    follow.drawn = built;
    follow.sent_snapshot = built.document;
    if (!state.preview) return;
    state.preview->set_material(std::make_shared<const Shader>(*built.running()),
                                built.displacement);
    if (state.timings) state.timings->compiled(built.version, state.preview->asked() + 1);
    send_values(state);
}

void rename_in_request(State& state, const Document& before) {
    PreviewRequest& request = state.view.preview_request;
    for (std::string* id : {&request.node, &request.name}) {
        if (id == &request.name && request.against != Against::node) continue;
        const size_t index = before.nodes.index_of(*id);
        if (index < state.document().nodes.size()) *id = state.document().nodes[index]->id;
    }
}

Diagnostic at_node(const Diagnostic& refusal, const Reflection& reflection,
                   const std::map<std::string, std::string>& copied) {
    const size_t line = line_in(refusal.message);
    if (line == 0 || line > reflection.lines.size()) return refusal;
    const uint32_t index = node_of_line(reflection, line);
    Diagnostic result = {.rule = refusal.rule};
    if (index < reflection.node_paths.size()) {
        const std::string& path = reflection.node_paths[index];
        result.node = path.substr(0, path.find('/'));
        const auto copy = copied.find(result.node);
        if (copy != copied.end()) result.node = copy->second;
    }
    result.message = "The graphics driver refused the shader at line " + std::to_string(line) +
                     (result.node.empty() ? "" : " (" + result.node + ")") +
                     ". The last good picture is shown.";
    result.expected = refusal.message;
    return result;
}

void poll_preview_diagnostics(State& state) {
    if (!state.preview) return;
    const PreviewImage& image = state.preview->newest();
    if (image.version == state.follow.diagnosed_version) return;
    state.follow.diagnosed_version = image.version;
    state.counters.programs = image.programs;
    state.preview_problems = Diagnostics();
    const Build& drawn = state.follow.drawn;
    for (const Diagnostic& problem : image.problems.list())
        state.preview_problems.add(drawn.running()
                                       ? at_node(problem, drawn.running()->reflection, drawn.copied)
                                       : problem);
    state.preview_stale = !state.built.running() || image.refused;
}

std::string other_normal(const State& state) {
    const auto& running = state.follow.drawn.running();
    if (state.view.compare.mode == CompareView::Mode::off || !running) return {};
    for (const OutputInfo& each : running->reflection.outputs)
        if (each.output == against_output) return against_output;
    return {};
}

}  // namespace wrinkle::editor
