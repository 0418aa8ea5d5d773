#include "editor/document/refresh.h"

#include "editor/canvas/field.h"
#include "editor/canvas/layout.h"
#include "editor/document/change.h"
#include "gpu/from_glsl.h"

namespace wrinkle::editor {
namespace {

// The running program's uniform for a place of the document, which may have other names by now.
const UniformInfo* uniform_at(const Follow& follow, const Change::Place& place) {
    if (!follow.running || place.index >= follow.running_of.nodes.size()) return nullptr;
    const std::string& node = follow.running_of.nodes[place.index]->id;
    for (const UniformInfo& uniform : follow.running->reflection.uniforms)
        if (!uniform.graph_input && uniform.node == node && uniform.port == place.port)
            return &uniform;
    return nullptr;
}

bool all_are_uniforms(const Follow& follow, const Change& difference) {
    if (difference.kind == Change::Kind::structure) return false;
    for (const Change::Place& place : difference.values)
        if (!uniform_at(follow, place)) return false;
    return true;
}

void send(State& state, const Change::Place& place) {
    const Node* node = state.document().find(place.node);
    const NodeType* type = state.type_of(place.node);
    const uint32_t port = node && type ? type->find_input(place.port) : NodeType::none;
    if (port == NodeType::none) return;
    const auto numbers = numbers_at(*node, type->ports[port]);
    const auto lanes = static_cast<size_t>(lanes_of(type->ports[port].type));
    float values[4];
    for (size_t i = 0; i < lanes; ++i)
        values[i] = static_cast<float>(numbers[i]);
    ++state.counters.uniforms;
    const std::string& name = uniform_at(state.follow, place)->name;
    if (state.preview) state.preview->set_uniform(name, {values, lanes});
}

// Sends the values that differ from what the preview shows; false when one of them is no uniform.
bool send_values(State& state) {
    Follow& follow = state.follow;
    const Change difference = change(follow.sent, state.document());
    if (!all_are_uniforms(follow, difference)) return false;
    for (const Change::Place& place : difference.values)
        send(state, place);
    follow.sent = state.document();
    return true;
}

void use_material(State& state) {
    Follow& follow = state.follow;
    state.preview_stale = !state.built.uniform;
    if (!state.built.uniform) return;
    if (follow.running && all_are_uniforms(follow, change(follow.running_of, follow.built_of))) {
        send_values(state);
        return;
    }
    follow.running = state.built.uniform;
    follow.running_of = follow.sent = follow.built_of;
    state.preview_problems = Diagnostics();
    if (!state.preview) return;
    const gpu::Material material = gpu::material_from(*follow.running);
    state.preview_stale = !state.preview->set_material(material, state.preview_problems);
    send_values(state);
}

void take(State& state, Compilation compilation) {
    Follow& follow = state.follow;
    if (compilation.version < follow.first || compilation.version <= follow.came) return;
    follow.came = compilation.version;
    ++state.counters.builds;
    state.built = std::move(compilation.build);
    follow.built_of = std::move(compilation.document);
    use_material(state);
}

void ask(State& state) {
    Follow& follow = state.follow;
    follow.asked_of = state.document();
    follow.names_stale = false;
    CompileJob job{++follow.asked, state.model, state.document(), material_name(state.path)};
    if (follow.compiler)
        follow.compiler->ask(std::move(job));
    else
        take(state, compile(std::move(job), *state.registry));
}

void remodel(State& state) {
    state.model = make_model(state.document(), state.folder(), *state.registry);
}

void begin(State& state) {
    state.fresh = true;
    state.layout_stale = true;
    state.follow.first = state.follow.asked + 1;
    state.follow.running.reset();
    remodel(state);
    ask(state);
}

void follow_document(State& state) {
    Follow& follow = state.follow;
    const Change difference = change(follow.asked_of, state.document());
    if (difference.renamed || difference.kind == Change::Kind::structure) remodel(state);
    switch (difference.kind) {
        case Change::Kind::none:
        case Change::Kind::cosmetic:
            follow.asked_of = state.document();
            break;
        case Change::Kind::names:
            follow.asked_of = state.document();
            follow.names_stale = true;
            break;
        case Change::Kind::values: {
            const bool sent = send_values(state);
            // While the hand is on a value only the uniform moves; the texts follow after it.
            if (!sent || state.gesture.kind != Gesture::Kind::value) ask(state);
            break;
        }
        case Change::Kind::structure:
            ask(state);
            break;
    }
}

}  // namespace

void refresh(State& state) {
    Follow& follow = state.follow;
    if (!state.fresh)
        begin(state);
    else if (!same_document(follow.asked_of, state.document()))
        follow_document(state);
    if (follow.compiler)
        if (auto result = follow.compiler->take()) take(state, std::move(*result));
    if (follow.names_stale && follow.code_shown) ask(state);
    follow.code_shown = false;
    update_layout(state);
}

bool is_settled(const State& state) {
    const bool held = state.gesture.kind == Gesture::Kind::value;
    return state.fresh && !state.follow.building() &&
           (held || same_document(state.follow.asked_of, state.document()));
}

}  // namespace wrinkle::editor
