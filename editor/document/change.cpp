#include "editor/document/change.h"

namespace wrinkle::editor {
namespace {

bool is_literal(const Input* input) {
    return !input || input->kind == Input::Kind::literal;
}

// False when the two differ in more than literals.
bool compare_inputs(const Node& a, const Node& b, std::vector<Change::Place>& values) {
    for (const Input& input : a.inputs) {
        const Input* other = b.find(input.port);
        if (is_literal(&input) != is_literal(other)) return false;
        if (!is_literal(&input)) {
            if (input.kind != other->kind || input.link != other->link) return false;
            continue;
        }
        if (!other || !other->value.same(input.value)) values.push_back({a.id, input.port});
    }
    for (const Input& input : b.inputs) {
        if (a.find(input.port)) continue;
        if (!is_literal(&input)) return false;
        values.push_back({b.id, input.port});
    }
    return true;
}

bool compare_nodes(const Document& a, const Document& b, std::vector<Change::Place>& values) {
    if (a.nodes.same(b.nodes)) return true;
    if (a.nodes.size() != b.nodes.size()) return false;
    for (size_t i = 0; i < a.nodes.size(); ++i) {
        const NodePtr& x = a.nodes[i];
        const NodePtr& y = b.nodes[i];
        if (x == y) continue;
        if (x->id != y->id || x->type != y->type || x->version != y->version ||
            x->muted != y->muted || !compare_inputs(*x, *y, values))
            return false;
    }
    return true;
}

}  // namespace

Change change(const Document& before, const Document& after) {
    Change result;
    if (!before.inputs.same(after.inputs) || !before.outputs.same(after.outputs) ||
        before.name != after.name || before.back_faces != after.back_faces ||
        !compare_nodes(before, after, result.values)) {
        result.kind = Change::Kind::structure;
        result.values.clear();
    } else if (!result.values.empty()) {
        result.kind = Change::Kind::values;
    } else if (!before.positions.same(after.positions) || !before.frames.same(after.frames) ||
               !before.notes.same(after.notes)) {
        result.kind = Change::Kind::cosmetic;
    }
    return result;
}

}  // namespace wrinkle::editor
