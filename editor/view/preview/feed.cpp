#include "editor/view/preview/feed.h"

#include <algorithm>

#include "editor/model/document/field.h"
#include "editor/model/document/inputs.h"
#include "editor/model/document/request.h"
#include "editor/view/edit/edits.h"
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

// Returns the uniform of the running program for an input of the graph; nullptr if it has none.
const UniformInfo* uniform_of_input(const CompileState& follow, const std::string& input) {
    if (!follow.drawn.running()) return nullptr;
    for (const UniformInfo& uniform : follow.drawn.running()->reflection.uniforms)
        if (uniform.graph_input && uniform.port == input) return &uniform;
    return nullptr;
}

// Values that differ between two documents.
struct ChangedValues {
    bool only = false;  // the rest is equal
    std::vector<Change::Place> ports;
    std::vector<std::string> inputs;  // inputs of the graph
};

ChangedValues changed_values(const Model& model, const PresetOf& before, const PresetOf& after) {
    Change difference = change(before.document, after.document);
    if (difference.kind == Change::Kind::structure) return {};
    ChangedValues changed{true, std::move(difference.values), {}};
    if (difference.inputs || before.preset != after.preset)
        changed.inputs = changed_inputs(model, before, after);
    return changed;
}

// The running program may have no uniform for a value because it does not read it; compilation
// determines whether that is so.
bool all_are_uniforms(const CompileState& follow, const ChangedValues& changed) {
    return changed.only &&
           std::ranges::all_of(
               changed.ports,
               [&](const Change::Place& place) { return !uniforms_at(follow, place).empty(); }) &&
           std::ranges::all_of(changed.inputs, [&](const std::string& input) {
               return uniform_of_input(follow, input) != nullptr;
           });
}

// Sends the numbers to each of the uniforms, which have the same type.
void send(State& state, const std::vector<const UniformInfo*>& uniforms,
          const std::array<double, 4>& numbers, int lanes) {
    float values[4];
    for (size_t i = 0; i < 4; ++i)
        values[i] = static_cast<float>(numbers[i]);
    ++state.counters.uniforms;
    if (!state.preview) return;
    for (const UniformInfo* uniform : uniforms)
        state.preview->set_uniform(uniform->name, {values, static_cast<size_t>(lanes)});
    if (state.timings) state.timings->values(state.preview->asked() + 1);
}

void send(State& state, const Change::Place& place) {
    const Node* node = state.document().find(place.node);
    const NodeType* type = state.type_of(place.node);
    const Port* port = input_port(type, place.port);
    if (!node || !port) return;
    send(state, uniforms_at(state.follow, place), numbers_at(*node, *port), lanes_of(port->type));
}

// Precondition: the input has a uniform.
void send_input(State& state, const Document& with_values, const std::string& name) {
    const GraphInput* input = with_values.inputs.find(name);
    const Port* port = port_of_input(state.model, name);
    if (!input || !port) return;
    send(state, {uniform_of_input(state.follow, name)},
         numbers_of_input(with_values, "", *input, *port), lanes_of(port->type));
}

PresetOf preset_of(const Build& build) {
    return {build.document, build.request.preset};
}

}  // namespace

bool differ_in_preset_only(PreviewRequest a, const PreviewRequest& b) {
    a.preset = b.preset;
    return a == b;
}

PreviewRequest wanted_request(const State& state) {
    PreviewRequest request = state.view.preview_request;
    request.displaced = state.view.preview_view.displaced;
    if (state.preview) request.double_sided = state.preview->newest().double_sided;
    if (state.view.compare.mode == CompareView::Mode::off) {
        request.against = Against::nothing;
        request.name.clear();
    }
    if (!request.node.empty() && !state.document().find(request.node)) request.node.clear();
    if (const Node* node = selected_node(state); node && request.node.empty() &&
                                                 state.document().outputs.empty() &&
                                                 shown_port(state.type_of(node->id)))
        request.node = node->id;
    return request;
}

void forget_files(PreviewState& state, Use use) {
    if (state.preview && (use == Use::image || use == Use::mesh || use == Use::light))
        state.preview->forget(use);
    if (use != Use::image) return;
    ++state.node_feed.images;
    ++state.flat.images;
}

bool send_values(State& state) {
    CompileState& follow = state.follow;
    const std::string& preset = state.view.preview_request.preset;
    const ChangedValues changed = changed_values(
        state.model, {follow.sent_snapshot, follow.sent_preset}, {state.document(), preset});
    if (!all_are_uniforms(follow, changed)) return false;
    for (const Change::Place& place : changed.ports)
        send(state, place);
    if (!changed.inputs.empty()) {
        const Document with_values = with_preset_as_defaults(state.model, state.document(), preset);
        for (const std::string& input : changed.inputs)
            send_input(state, with_values, input);
        state.play.program = 0;  // the seconds were overwritten
    }
    follow.sent_snapshot = state.document();
    follow.sent_preset = preset;
    return true;
}

bool reads_input(const CompileState& follow, const std::string& input) {
    return uniform_of_input(follow, input) != nullptr;
}

void send_number(State& state, const std::string& input, std::optional<double> number) {
    const std::string& preset = state.view.preview_request.preset;
    if (!number)
        send_input(state, with_preset_as_defaults(state.model, state.document(), preset), input);
    else
        send(state, {uniform_of_input(state.follow, input)}, {*number}, 1);
}

void apply_latest_build(State& state) {
    CompileState& follow = state.follow;
    const Build& built = state.built;
    state.preview_stale = !built.running();
    if (!built.running()) return;
    const Build& drawn = follow.drawn;
    const bool same_kind = drawn.running() && differ_in_preset_only(drawn.request, built.request) &&
                           !drawn.displacement && !built.displacement;
    if (same_kind &&
        all_are_uniforms(follow, changed_values(state.model, preset_of(drawn), preset_of(built)))) {
        send_values(state);
        return;
    }
    follow.drawn = built;
    follow.sent_snapshot = built.document;
    follow.sent_preset = built.request.preset;
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
                     ". The last good image is shown.";
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
