// Tests of each gesture on 1,000 random graphs: one undo step, no invalid wires, and undo restores
// the same bytes.
#include <functional>

#include "editor/view/canvas/arrange.h"
#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/gestures/gestures.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/edit/clipboard.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "headless.h"
#include "random_graph.h"

namespace wrinkle::editor {
namespace {

using Random = std::mt19937;

struct Trial {
    const char* name;
    std::function<void(State&, Random&)> run;
};

void select_some(State& state, Random& random) {
    state.view.selected.clear();
    for (const NodePtr& node : state.document().nodes)
        if (random() % 3 == 0) state.view.selected.insert(node->id);
}

void cross_some(State& state, Random& random) {
    state.gesture = {};
    for (size_t i = 0; i < state.layout.wires.size(); ++i)
        if (random() % 4 == 0)
            state.gesture.crossed.push_back({i, state.layout.wires[i].start + ImVec2(20, 5)});
}

void connect_any(State& state, Random& random) {
    const Card from = state.layout.cards[random() % state.layout.cards.size()];
    const Card to = state.layout.cards[random() % state.layout.cards.size()];
    if (from.pins.empty() || to.pins.empty()) return;
    begin_wire(state, from, from.pins[random() % from.pins.size()]);
    lift_wire(state);
    state.gesture.moved = true;
    connect_wire(state, state.gesture, to, to.pins[random() % to.pins.size()]);
    state.gesture = {};
    if (state.offer.open) accept_offer(state, 0);
    state.offer = {};
}

void connect_lazily(State& state, Random& random) {
    state.gesture.moved = true;
    state.gesture.card = random() % state.layout.cards.size();
    state.hovered = {Hit::Kind::card, random() % state.layout.cards.size(), 0, 0};
    drop_lazy(state);
    state.hovered = {};
    state.gesture = {};
}

// Precondition: the last node of the graph has no wires.
void drop_on_wire(State& state, Random& random) {
    if (state.layout.wires.empty()) return;
    const Wire& wire = state.layout.wires[random() % state.layout.wires.size()];
    const std::string id = state.document().nodes[state.document().nodes.size() - 1]->id;
    const Card& card = *state.layout.find(id);
    state.view.selected = {id};
    state.gesture.kind = Gesture::Kind::move;
    state.gesture.moved = true;
    state.gesture.carried = {id};
    state.gesture.offset = (wire.start + wire.end) * 0.5F - card.at - card.size * 0.5F;
    drop_cards(state);
    state.gesture = {};
    state.layout_stale = true;
}

void add_any(State& state, Random& random) {
    const auto& types = built_in_registry().list();
    const NodeType& type = types[random() % types.size()];
    if (random() % 2 == 0 && !state.layout.wires.empty()) {
        const Wire& wire = state.layout.wires[random() % state.layout.wires.size()];
        state.view.selected_wire = Link{wire.node, wire.port};
    }
    add_node_to_selection(state, type, {0, 0});
    state.view.selected_wire.reset();
}

const Trial trials[] = {
    {"delete", [](State& s, Random&) { delete_selected(s); }},
    {"delete with wires", [](State& s, Random&) { delete_selected_with_wires(s); }},
    {"duplicate", [](State& s, Random&) { duplicate_selected(s); }},
    {"duplicate alone", [](State& s, Random&) { duplicate_selected(s, false); }},
    {"copy and paste", [](State& s, Random&) { copy_selected(s), paste(s); }},
    {"paste elsewhere",
     [](State& s, Random&) {
         copy_selected(s);
         s.clip = {};
         paste(s);
     }},
    {"cut", [](State& s, Random&) { cut_selected(s); }},
    {"swap inputs", [](State& s, Random&) { swap_selected(s); }},
    {"cut stroke", [](State& s, Random& r) { cross_some(s, r), drop_cut(s), s.gesture = {}; }},
    {"reroute", [](State& s, Random& r) { cross_some(s, r), drop_reroutes(s), s.gesture = {}; }},
    {"connect", connect_any},
    {"lazy connect", connect_lazily},
    {"drop on a wire", drop_on_wire},
    {"add", add_any},
    {"frame", [](State& s, Random&) { frame_selected(s), s.box_text = {}; }},
    {"note", [](State& s, Random&) { add_note(s), s.box_text = {}; }},
    {"align", [](State& s, Random&) { s.commit("Align", aligned(s, Side::middle_x)); }},
    {"distribute", [](State& s, Random&) { s.commit("Distribute", distributed(s, true)); }},
    {"tidy selection", [](State& s, Random&) { s.commit("Tidy", tidied_selection(s)); }},
};

class RandomGestures : public Headless {
protected:
    void settle() {
        state.model = make_model(state.document(), state.folder(), built_in_registry());
        state.layout_stale = true;
        update_layout(state);
    }

    void use(const Document& document) {
        state.history = History(document);
        state.view.selected.clear();
        state.view.boxes.clear();
        settle();
    }

    // Returns true if the gesture changed the document.
    bool try_one(const Trial& trial, const Document& start, Random& random) {
        use(start);
        select_some(state, random);
        const std::string before = write_document(state.document());
        trial.run(state, random);
        const std::string after = write_document(state.document());
        EXPECT_EQ(state.history.at(), before == after ? 0U : 1U) << trial.name;
        EXPECT_EQ(bad_wires(state.document()), 0U) << trial.name << "\n" << before << after;
        EXPECT_EQ(bad_links(state.document()), 0U) << trial.name << "\n" << before << after;
        state.history.undo();
        EXPECT_EQ(write_document(state.document()), before) << trial.name;
        state.history.redo();
        EXPECT_EQ(write_document(state.document()), after) << trial.name;
        return before != after;
    }
};

TEST_F(RandomGestures, AreOneStepEachAndLeaveNoWrongWire) {
    open(small_graph);
    Random random(2026);
    std::map<std::string, int> changed;
    for (int i = 0; i < 100 && !HasFailure(); ++i) {
        Document start = random_graph(random);
        Node loose;
        const auto& types = built_in_registry().list();
        loose.type = types[random() % types.size()].id;
        loose.id = free_id(start, "loose");
        start = add_node(start, std::move(loose), 0, -2000);
        ASSERT_EQ(bad_wires(start), 0U) << write_document(start);
        for (const Trial& trial : trials)
            changed[trial.name] += try_one(trial, start, random);
    }
    for (const auto& [name, times] : changed) {
        std::printf("%s: %d of 100 graphs changed\n", name.c_str(), times);
        EXPECT_GT(times, 10) << name;
    }
}

}  // namespace
}  // namespace wrinkle::editor
