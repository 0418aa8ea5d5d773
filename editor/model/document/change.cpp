#include "editor/model/document/change.h"

#include <algorithm>

namespace wrinkle::editor {
namespace {

// Returns true if two inputs of a graph differ at most in their defaults.
bool same_declaration(const GraphInput& a, const GraphInput& b) {
    if (a.name != b.name || a.default_value.kind() != b.default_value.kind()) return false;
    const std::vector<Extra> x = present_keys(a), y = present_keys(b);
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](const Extra& p, const Extra& q) {
        return p.key == q.key && (p.key == "default" || p.value == q.value);
    });
}

class Comparison {
public:
    Comparison(const Document& before, const Document& after) : a_(before), b_(after) {}

    Change run() {
        if (a_.name != b_.name || a_.back_faces != b_.back_faces || !same_declarations() ||
            !same_nodes() || !same_outputs())
            return {Change::Kind::structure, false, {}};
        const bool inputs = !a_.inputs.same(b_.inputs) || !a_.presets.same(b_.presets);
        if (!values_.empty() || inputs)
            return {Change::Kind::values, renamed_, std::move(values_), inputs};
        if (renamed_) return {Change::Kind::names, true, {}};
        const bool layout =
            a_.positions.same(b_.positions) && a_.frames.same(b_.frames) && a_.notes.same(b_.notes);
        return {layout ? Change::Kind::none : Change::Kind::cosmetic, false, {}};
    }

private:
    static bool is_literal(const Input* input) {
        return !input || input->kind == Input::Kind::literal;
    }

    // Returns true if both links have the same source, possibly renamed.
    bool same_link(const Link& a, const Link& b) const {
        if (a == b && !a.is_node()) return true;
        if (a.port != b.port || !a.is_node() || !b.is_node()) return false;
        const size_t index = a_.nodes.index_of(a.node);
        return index == b_.nodes.index_of(b.node) &&
               (index != Table<NodePtr>::npos || a.node == b.node);
    }

    bool same_inputs(const Node& a, const Node& b, size_t index) {
        for (const Input& input : a.inputs) {
            const Input* other = b.find(input.port);
            if (is_literal(&input) != is_literal(other)) return false;
            if (is_literal(&input)) {
                if (!other || !other->value.same(input.value))
                    values_.push_back({b.id, input.port, index});
            } else if (input.kind != other->kind || !same_link(input.link, other->link)) {
                return false;
            }
        }
        for (const Input& input : b.inputs) {
            if (a.find(input.port)) continue;
            if (!is_literal(&input)) return false;
            values_.push_back({b.id, input.port, index});
        }
        return true;
    }

    bool same_declarations() const {
        return a_.inputs.same(b_.inputs) ||
               std::equal(a_.inputs.begin(), a_.inputs.end(), b_.inputs.begin(), b_.inputs.end(),
                          same_declaration);
    }

    bool same_nodes() {
        if (a_.nodes.same(b_.nodes)) return true;
        if (a_.nodes.size() != b_.nodes.size()) return false;
        for (size_t i = 0; i < a_.nodes.size(); ++i) {
            const NodePtr &x = a_.nodes[i], &y = b_.nodes[i];
            if (x == y) continue;
            if (x->type != y->type || x->version != y->version || x->muted != y->muted ||
                !same_inputs(*x, *y, i))
                return false;
            renamed_ |= x->id != y->id;
        }
        return true;
    }

    bool same_outputs() const {
        return std::equal(a_.outputs.begin(), a_.outputs.end(), b_.outputs.begin(),
                          b_.outputs.end(), [this](const Output& x, const Output& y) {
                              return x.name == y.name && x.from.kind == y.from.kind &&
                                     same_link(x.from.link, y.from.link);
                          });
    }

    const Document &a_, &b_;
    std::vector<Change::Place> values_;
    bool renamed_ = false;
};

}  // namespace

Change change(const Document& before, const Document& after) {
    return Comparison(before, after).run();
}

bool same_document(const Document& a, const Document& b) {
    return a.nodes.same(b.nodes) && a.inputs.same(b.inputs) && a.presets.same(b.presets) &&
           a.outputs.same(b.outputs) && a.positions.same(b.positions) && a.frames.same(b.frames) &&
           a.notes.same(b.notes) && a.name == b.name && a.back_faces == b.back_faces;
}

}  // namespace wrinkle::editor
