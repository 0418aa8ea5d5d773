#include "editor/state.h"

#include "base/file.h"
#include "base/text.h"
#include "editor/change.h"
#include "editor/field.h"
#include "editor/layout.h"
#include "gpu/from_glsl.h"
#include "graph/read.h"
#include "graph/write.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;

const Card* Layout::find(std::string_view id, Card::Kind kind) const {
    for (const Card& card : cards)
        if (card.kind == kind && card.id == id) return &card;
    return nullptr;
}

fs::path State::folder() const {
    const fs::path parent = path.parent_path();
    return parent.empty() ? fs::path(".") : parent;
}

std::string State::title() const {
    const std::string file = path.filename().string();
    return (file.empty() ? "untitled.json" : file) + (dirty() ? " *" : "") + " - Wrinkle";
}

void State::commit(std::string name, Document document, const std::string& merge) {
    if (history.commit(name, std::move(document), merge)) status = std::move(name);
}

void open_file(State& state, const fs::path& path) {
    state.path = path;
    state.save_refused.clear();
    Diagnostics problems;
    std::string why;
    const auto bytes = read_file(path, why);
    if (bytes) {
        state.history = History(read_document(*bytes, path.string(), problems));
        state.save_refused = state.document().lost;
    } else {
        Document empty;
        empty.file = path.string();
        state.history = History(std::move(empty));
        std::error_code ignored;
        if (fs::exists(path, ignored)) state.save_refused = path.string() + " " + why;
    }
    state.saved_serial = state.history.serial();
    state.view = {};
    state.fresh = false;
    state.status = bytes ? "Opened " + path.string() : "New graph " + path.string();
}

bool save_file(State& state) {
    if (!state.save_refused.empty()) {
        state.status = "Not saved, because the file could not be read whole: " + state.save_refused;
        return false;
    }
    std::string why;
    if (!write_file(state.path, write_document(state.document()), why)) {
        state.status = state.path.string() + " was not saved: it " + why;
        return false;
    }
    state.saved_serial = state.history.serial();
    state.status = "Saved " + state.path.filename().string();
    return true;
}

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
