#include "editor/document/refresh.h"

#include "base/text.h"
#include "editor/canvas/field.h"
#include "editor/canvas/layout.h"
#include "editor/document/change.h"
#include "gpu/from_glsl.h"

namespace wrinkle::editor {
namespace {

void use_material(State& state) {
    state.preview_problems = Diagnostics();
    state.preview_stale = !state.built.uniform;
    if (!state.preview || !state.built.uniform) return;
    const gpu::Material material = gpu::material_from(*state.built.uniform);
    state.preview_stale = !state.preview->set_material(material, state.preview_problems);
}

void rebuild(State& state) {
    ++state.counters.builds;
    const std::string name = identifier(state.path.stem().string());
    state.built = build(state.model, state.document(), *state.registry, name);
    state.built_of = state.sent = state.document();
    use_material(state);
}

const UniformInfo* uniform_at(const State& state, const Change::Place& place) {
    if (!state.built.uniform) return nullptr;
    for (const UniformInfo& uniform : state.built.uniform->reflection.uniforms)
        if (!uniform.graph_input && uniform.node == place.node && uniform.port == place.port)
            return &uniform;
    return nullptr;
}

// Sends the values that differ from what the preview shows; false when one of them is no uniform.
bool send_values(State& state) {
    const Document& now = state.document();
    const Change difference = change(state.sent, now);
    for (const Change::Place& place : difference.values)
        if (!uniform_at(state, place)) return false;
    for (const Change::Place& place : difference.values) {
        const UniformInfo& uniform = *uniform_at(state, place);
        const Node* node = now.find(place.node);
        const NodeType* type = state.type_of(place.node);
        if (!node || !type) return false;
        const auto numbers = numbers_at(*node, type->ports[type->find_input(place.port)]);
        float values[4];
        const auto lanes =
            static_cast<size_t>(lanes_of(type->ports[type->find_input(place.port)].type));
        for (size_t i = 0; i < lanes; ++i)
            values[i] = static_cast<float>(numbers[i]);
        ++state.counters.uniforms;
        if (state.preview) state.preview->set_uniform(uniform.name, {values, lanes});
    }
    state.sent = now;
    return true;
}

void remake(State& state) {
    state.model = make_model(state.document(), state.folder(), *state.registry);
    state.fresh = true;
    rebuild(state);
}

}  // namespace

void refresh(State& state) {
    const Document& now = state.document();
    if (!state.fresh) {
        remake(state);
        state.layout_stale = true;
    } else if (!same_document(state.built_of, now)) {
        switch (change(state.built_of, now).kind) {
            case Change::Kind::none:
            case Change::Kind::cosmetic:
                state.built_of = state.sent = now;
                break;
            case Change::Kind::values: {
                const bool sent = send_values(state);
                // While the hand is on a value only the uniform moves; the texts follow after it.
                if (!sent || state.gesture.kind != Gesture::Kind::value) rebuild(state);
                break;
            }
            case Change::Kind::structure:
                remake(state);
                break;
        }
    }
    if (state.layout_stale || !same_document(state.layout_of, now)) {
        state.layout = lay_out(state);
        if (const Card* card = state.layout.find(Link::surface, Card::Kind::surface))
            if (!state.view.surface_at) state.view.surface_at = card->at;
        if (const Card* card = state.layout.find(Card::outputs_id, Card::Kind::outputs))
            if (!state.view.outputs_at) state.view.outputs_at = card->at;
        state.layout_of = now;
        state.layout_stale = false;
    }
}

}  // namespace wrinkle::editor
