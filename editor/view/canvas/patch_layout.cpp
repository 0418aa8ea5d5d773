// Incremental update of a layout if few nodes changed: in graphs of thousands of nodes most edits,
// and their undo, change only one.
#include <algorithm>
#include <map>

#include "editor/view/canvas/layout_parts.h"
#include "editor/view/canvas/make_card.h"

namespace wrinkle::editor {
namespace {

constexpr size_t max_pieces = 16;
constexpr auto nowhere = Table<NodePtr>::npos;

// Differences between the nodes of the layout and those of the document.
struct Difference {
    struct Pair {
        size_t before, after;
        bool relinked;  // its links changed
    };
    std::vector<Pair> changed;
    std::vector<size_t> removed, added;   // ascending indices in the old and the new table
    std::vector<const Position*> placed;  // new positions of moved nodes

    size_t size() const { return changed.size() + removed.size() + added.size(); }
};

bool same_links(const Node& a, const Node& b) {
    const auto next = [](const Node& node, size_t i) {
        while (i < node.inputs.size() && node.inputs[i].kind != Input::Kind::link)
            ++i;
        return i;
    };
    size_t i = next(a, 0), k = next(b, 0);
    while (i < a.inputs.size() && k < b.inputs.size()) {
        if (a.inputs[i].port != b.inputs[k].port || a.inputs[i].link != b.inputs[k].link)
            return false;
        i = next(a, i + 1), k = next(b, k + 1);
    }
    return i >= a.inputs.size() && k >= b.inputs.size();
}

bool same_outputs(const Table<Output>& a, const Table<Output>& b) {
    return a.same(b) ||
           std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Output& x, const Output& y) {
               return x.name == y.name && x.from.kind == y.from.kind && x.from.link == y.from.link;
           });
}

template <class Each>
void each_link(const Node& node, Each each) {
    for (const Input& input : node.inputs)
        if (input.kind == Input::Kind::link) each(input);
}

// Finds the differences, and determines if they are few enough and can be patched.
class Plan {
public:
    explicit Plan(const State& state)
        : state_(state),
          layout_(state.layout),
          before_(layout_.nodes),
          after_(state.document().nodes),
          types_(*state.model.types) {}

    std::optional<Difference> make() {
        const Document &was = state_.layout_of, &now = state_.document();
        const bool is_unmoved = layout_.types && layout_.dragged.x == 0 && layout_.dragged.y == 0;
        if (!is_unmoved || layout_.wires.size() != layout_.links || !was.inputs.same(now.inputs) ||
            !same_outputs(was.outputs, now.outputs) || !find_nodes() ||
            !find_places(was.positions, now.positions) || !has_fitting_types() ||
            !has_fitting_links() || !leaves_no_loose_end())
            return std::nullopt;
        return std::move(difference_);
    }

private:
    bool find_nodes() {
        const bool typed = layout_.types == state_.model.types;
        size_t i = 0, k = 0;
        while ((i < before_.size() || k < after_.size()) && difference_.size() <= max_pieces) {
            const bool more = i < before_.size(), more_after = k < after_.size();
            const bool same = more && more_after && before_[i] == after_[k];
            if (same || (more && more_after && before_[i]->id == after_[k]->id)) {
                if (!same || (!typed && layout_.types->of(0, i) != types_.of(0, k)))
                    difference_.changed.push_back(
                        {i, k, !same && !same_links(*before_[i], *after_[k])});
                ++i, ++k;
            } else if (more && after_.index_of(before_[i]->id) == nowhere) {
                difference_.removed.push_back(i++);
            } else if (more_after && before_.index_of(after_[k]->id) == nowhere) {
                difference_.added.push_back(k++);
            } else {
                return false;
            }
        }
        return difference_.size() <= max_pieces;
    }

    // Returns false if a node lost its position.
    bool find_places(const Table<Position>& was, const Table<Position>& now) {
        if (was.same(now)) return true;
        size_t i = 0, k = 0;
        for (; k < now.size(); ++k) {
            while (i < was.size() && was[i].id != now[k].id && !now.find(was[i].id))
                if (after_.index_of(was[i++].id) != nowhere) return false;
            const bool same_id = i < was.size() && was[i].id == now[k].id;
            const Position* old = same_id ? &was[i] : was.find(now[k].id);
            if (!old || old->x != now[k].x || old->y != now[k].y)
                difference_.placed.push_back(&now[k]);
            if (same_id) ++i;
        }
        for (; i < was.size(); ++i)
            if (!now.find(was[i].id) && after_.index_of(was[i].id) != nowhere) return false;
        return true;
    }

    // Changed types are accepted only for reroutes, and only if all outputs are standard ones.
    bool has_fitting_types() const {
        for (const Difference::Pair& pair : difference_.changed) {
            const NodeType* was = layout_.types->of(0, pair.before);
            const NodeType* now = types_.of(0, pair.after);
            if (!was || !now) return false;
            if (was == now) continue;
            if (was->id != reroute_type || now->id != reroute_type) return false;
            for (const Output& output : state_.document().outputs)
                if (!standard_output(output.name)) return false;
        }
        return true;
    }

    bool fits(const Input& input, size_t reader) const {
        const size_t source = input.link.is_node() ? after_.index_of(input.link.node) : nowhere;
        if (source == nowhere) return false;
        const NodeType *from = types_.of(0, source), *to = types_.of(0, reader);
        if (!from || !to || from->find_output(input.link.port) == NodeType::none) return false;
        const uint32_t port = to->find_input(input.port);
        return port != NodeType::none && to->ports[port].is_value();
    }

    // Automatic positions depend on the links of all nodes.
    bool has_fitting_links() const {
        bool fit = true;
        const auto leads_to_a_node = [&](const Input& input) { fit &= input.link.is_node(); };
        for (const size_t i : difference_.removed)
            each_link(*before_[i], leads_to_a_node);
        for (const size_t k : difference_.added) {
            fit &= types_.of(0, k) && state_.document().positions.find(after_[k]->id);
            each_link(*after_[k], [&](const Input& input) { fit &= fits(input, k); });
        }
        for (const auto& [i, k, relinked] : difference_.changed) {
            fit &= layout_.placed || before_[i]->inputs.size() == after_[k]->inputs.size();
            if (!relinked) continue;
            each_link(*before_[i], leads_to_a_node);
            for (const Input& input : after_[k]->inputs)
                fit &= input.kind != Input::Kind::link || fits(input, k);
        }
        const bool in_columns = difference_.added.empty() && difference_.removed.empty() &&
                                difference_.placed.empty() && !any_relinked();
        return fit && (layout_.placed || in_columns);
    }
    bool any_relinked() const {
        return std::any_of(difference_.changed.begin(), difference_.changed.end(),
                           [](const Difference::Pair& pair) { return pair.relinked; });
    }

    // Returns true if each reader of a removed node is removed or relinked as well.
    bool leaves_no_loose_end() const {
        if (difference_.removed.empty()) return true;
        std::vector<bool> gone(layout_.cards.size(), false), cut(layout_.cards.size(), false);
        for (const size_t i : difference_.removed)
            gone[layout_.card_of_node[i]] = cut[layout_.card_of_node[i]] = true;
        for (const Difference::Pair& pair : difference_.changed)
            if (pair.relinked) cut[layout_.card_of_node[pair.before]] = true;
        return std::all_of(layout_.wires.begin(), layout_.wires.end(), [&](const Wire& wire) {
            return !gone[wire.from_card] || cut[wire.to_card];
        });
    }

    const State& state_;
    const Layout& layout_;
    const Table<NodePtr>& before_;
    const Table<NodePtr>& after_;
    const Types& types_;
    Difference difference_;
};

class Patch {
public:
    Patch(State& state, Difference difference)
        : state_(state),
          layout_(state.layout),
          before_(layout_.nodes),
          after_(state.document().nodes),
          difference_(std::move(difference)) {}

    void run() {
        count_readers();
        drop_wires();
        for (size_t n = difference_.removed.size(); n-- > 0;)
            drop_card(difference_.removed[n]);
        for (const size_t k : difference_.added)
            insert_card(k);
        layout_.nodes = after_;
        count_new_readers();
        marked_.assign(layout_.cards.size(), false);
        make_cards();
        for (const Position* position : difference_.placed)
            place(*position);
        for (const size_t k : with_new_wires())
            insert_wires(k);
        finish();
    }

private:
    std::vector<size_t> with_new_wires() const {
        std::vector<size_t> all = difference_.added;
        for (const Difference::Pair& pair : difference_.changed)
            if (pair.relinked) all.push_back(pair.after);
        std::sort(all.begin(), all.end());
        return all;
    }

    uint64_t& readers_of(const Table<NodePtr>& nodes, const Link& link) {
        uint64_t& key = layout_.readers[nodes.index_of(link.node)];
        touched_.emplace(link.node, key);
        return key;
    }
    void count_readers() {
        const auto take_off = [&](const Input& input) {
            readers_of(before_, input.link) -= reader_key(input.link.port);
        };
        for (const size_t i : difference_.removed)
            each_link(*before_[i], take_off);
        for (const Difference::Pair& pair : difference_.changed)
            if (pair.relinked) each_link(*before_[pair.before], take_off);
    }
    void count_new_readers() {
        for (const size_t k : with_new_wires())
            each_link(*after_[k], [&](const Input& input) {
                readers_of(after_, input.link) += reader_key(input.link.port);
            });
    }

    void drop_wires() {
        std::vector<bool> cut(layout_.cards.size(), false);
        for (const size_t i : difference_.removed)
            cut[layout_.card_of_node[i]] = true;
        for (const Difference::Pair& pair : difference_.changed)
            if (pair.relinked) cut[layout_.card_of_node[pair.before]] = true;
        size_t kept = 0;
        for (size_t i = 0; i < layout_.wires.size(); ++i) {
            if (cut[layout_.wires[i].to_card]) continue;
            if (kept != i) {
                layout_.wires[kept] = std::move(layout_.wires[i]);
                layout_.wire_boxes[kept] = layout_.wire_boxes[i];
            }
            ++kept;
        }
        layout_.wires.resize(kept);
        layout_.wire_boxes.resize(kept);
    }

    // Applies `step` to each card index >= `from`.
    template <class Step>
    void renumber(uint32_t from, Step step) {
        for (uint32_t& card : layout_.card_of_node)
            if (card >= from) step(card);
        for (Wire& wire : layout_.wires) {
            if (wire.from_card >= from) step(wire.from_card);
            if (wire.to_card >= from) step(wire.to_card);
        }
    }
    void drop_card(size_t node) {
        const uint32_t card = layout_.card_of_node[node];
        layout_.cards.erase(layout_.cards.begin() + card);
        layout_.card_boxes.erase(layout_.card_boxes.begin() + card);
        layout_.card_of_node.erase(layout_.card_of_node.begin() +
                                   static_cast<std::ptrdiff_t>(node));
        layout_.readers.erase(layout_.readers.begin() + static_cast<std::ptrdiff_t>(node));
        renumber(card, [](uint32_t& index) { --index; });
    }
    // Raised cards are on top in their own order, the others in document order.
    uint32_t place_of_card(size_t node) const {
        const auto& raised = state_.view.order;
        const auto found = std::find(raised.begin(), raised.end(), after_[node]->id);
        if (found == raised.end())
            return static_cast<uint32_t>(node) -
                   static_cast<uint32_t>(std::count_if(
                       raised.begin(), raised.end(),
                       [&](const std::string& id) { return after_.index_of(id) < node; }));
        size_t card = layout_.cards.size();
        while (card > 0 &&
               std::find(found, raised.end(), layout_.cards[card - 1].id) != raised.end())
            --card;
        return static_cast<uint32_t>(card);
    }
    void insert_card(size_t node) {
        const uint32_t card = place_of_card(node);
        renumber(card, [](uint32_t& index) { ++index; });
        layout_.cards.emplace(layout_.cards.begin() + card)->id = after_[node]->id;
        layout_.card_boxes.emplace(layout_.card_boxes.begin() + card);
        layout_.card_of_node.insert(
            layout_.card_of_node.begin() + static_cast<std::ptrdiff_t>(node), card);
        layout_.readers.insert(layout_.readers.begin() + static_cast<std::ptrdiff_t>(node), 0);
    }

    // Nodes with cards to rebuild, and the outputs read of each.
    std::map<size_t, std::vector<std::string_view>> to_be_made() const {
        std::map<size_t, std::vector<std::string_view>> all;
        for (const Difference::Pair& pair : difference_.changed)
            all[pair.after];
        for (const size_t k : difference_.added)
            all[k];
        for (const auto& [id, key] : touched_)
            if (const size_t k = after_.index_of(id); k != nowhere && layout_.readers[k] != key)
                all[k];
        std::vector<std::vector<std::string_view>*> of_card(layout_.cards.size(), nullptr);
        for (auto& entry : all)
            of_card[layout_.card_of_node[entry.first]] = &entry.second;
        for (const Wire& wire : layout_.wires)
            if (auto* read = of_card[wire.from_card]) read->push_back(wire.from.port);
        for (const size_t k : with_new_wires())
            each_link(*after_[k], [&](const Input& input) {
                const size_t source = after_.index_of(input.link.node);
                if (auto* read = of_card[layout_.card_of_node[source]])
                    read->push_back(input.link.port);
            });
        return all;
    }
    void make_cards() {
        layout_.made = 0;
        for (const auto& [node, read] : to_be_made()) {
            const uint32_t index = layout_.card_of_node[node];
            const NodeType* type = state_.model.types->of(0, node);
            Card card = make_card(state_.fonts, *after_[node], type, read,
                                  has_picture(state_.view, *after_[node], type));
            card.at = layout_.cards[index].at;
            layout_.cards[index] = std::move(card);
            marked_[index] = true;
            ++layout_.made;
        }
    }
    void place(const Position& position) {
        const size_t node = after_.index_of(position.id);
        if (node == nowhere) return;
        const uint32_t card = layout_.card_of_node[node];
        layout_.cards[card].at = {static_cast<float>(position.x), static_cast<float>(position.y)};
        marked_[card] = true;
    }

    // Wires are in the order of their readers, those of the graph outputs last.
    void insert_wires(size_t node) {
        const auto later =
            std::partition_point(layout_.wires.begin(), layout_.wires.end(), [&](const Wire& wire) {
                return !wire.node.empty() && after_.index_of(wire.node) < node;
            });
        std::vector<Wire> wires;
        each_link(*after_[node], [&](const Input& input) {
            const size_t source = after_.index_of(input.link.node);
            auto wire = make_wire(layout_, input.link, layout_.card_of_node[source],
                                  layout_.card_of_node[node], input.port);
            if (wire) wires.push_back(std::move(*wire));
        });
        layout_.wire_boxes.insert(layout_.wire_boxes.begin() + (later - layout_.wires.begin()),
                                  wires.size(), Extent());
        layout_.wires.insert(later, std::make_move_iterator(wires.begin()),
                             std::make_move_iterator(wires.end()));
    }

    void finish() {
        for (size_t i = 0; i < layout_.wires.size(); ++i)
            if (marked_[layout_.wires[i].from_card] || marked_[layout_.wires[i].to_card])
                fit_wire(layout_, layout_.wires[i], layout_.wire_boxes[i]);
        for (size_t i = 0; i < layout_.cards.size(); ++i)
            if (marked_[i]) layout_.card_boxes[i] = box_of(layout_.cards[i]);
        find_bounds(layout_);
        layout_.links = layout_.wires.size();
        layout_.types = state_.model.types;
        layout_.patched = true;
    }

    State& state_;
    Layout& layout_;
    const Table<NodePtr> before_;
    const Table<NodePtr>& after_;
    const Difference difference_;
    std::map<std::string, uint64_t> touched_;  // reader keys of nodes before the change
    std::vector<bool> marked_;                 // cards that changed or moved
};

}  // namespace

bool patch_layout(State& state) {
    auto difference = Plan(state).make();
    if (difference) Patch(state, std::move(*difference)).run();
    return difference.has_value();
}

}  // namespace wrinkle::editor
