// Tests of undo and redo: any number of edits made by the panels is restored byte for byte.
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "editor/model/document/field.h"
#include "editor/model/document/files.h"
#include "editor/view/canvas/arrange.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/edit/edits.h"
#include "editor/view/refresh.h"
#include "graph/edit.h"
#include "graph/read.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

// Applies random edits through the functions of the panels.
class RandomHand {
public:
    RandomHand(State& state, unsigned seed) : state_(state), random_(seed) {}

    void act() {
        const size_t count = state_.document().nodes.size();
        if (count < 4) return add();
        if (count > 60) return select_some(), delete_selected(state_);
        switch (pick(16)) {
            case 0:
            case 1:
                return add();
            case 2:
                return select_some(), delete_selected(state_);
            case 3:
                return select_some(), duplicate_selected(state_);
            case 4:
                return select_some(), mute_selected(state_);
            case 5:
            case 6:
                return connect_some();
            case 7:
                return disconnect_some();
            case 8:
            case 9:
            case 10:
                return set_value_somewhere();
            case 11:
                return drag();
            case 12:
                return rename();
            case 13:
                return box(true);
            case 14:
                return box(false);
            default:
                return rarely();
        }
    }

private:
    size_t pick(size_t count) { return random_() % count; }
    const Node& node() { return *state_.document().nodes[pick(state_.document().nodes.size())]; }
    const Port* port_of(const Node& node, bool output) {
        const NodeType* type = built_in_registry().find(node.type);
        std::vector<const Port*> ports;
        if (type)
            for (const Port& port : type->ports)
                if ((port.kind == Port::Kind::output) == output) ports.push_back(&port);
        return ports.empty() ? nullptr : ports[pick(ports.size())];
    }

    void add() {
        const auto& types = built_in_registry().list();
        Gesture wire;
        if (pick(2) == 0 && !state_.document().nodes.empty()) {
            const Node& from = node();
            if (const Port* port = port_of(from, true)) {
                wire.kind = Gesture::Kind::wire;
                wire.from_output = true;
                wire.from = {from.id, port->name};
                wire.type = port->type;
            }
        }
        add_node_of_type(state_, types[pick(types.size())],
                         {static_cast<float>(pick(900)), static_cast<float>(pick(900))}, wire);
    }
    void select_some() {
        state_.view.selected.clear();
        for (size_t i = 0, count = 1 + pick(5); i < count; ++i)
            state_.view.selected.insert(node().id);
    }
    void connect_some() {
        const Node &from = node(), &to = node();
        const Port *output = port_of(from, true), *input = port_of(to, false);
        if (output && input)
            state_.commit("Connect", with_wire(state_.document(), {from.id, output->name}, to.id,
                                               input->name));
    }
    void disconnect_some() {
        const Node& reader = node();
        if (!reader.inputs.empty())
            state_.commit("Disconnect",
                          without_wire(state_.document(), reader.id,
                                       reader.inputs[pick(reader.inputs.size())].port));
    }
    void set_value_somewhere() {
        const Node& changed = node();
        const Port* port = port_of(changed, false);
        if (!port) return;
        const auto number = static_cast<double>(pick(2000)) / 128 - 4;
        if (!port->choices.empty())
            state_.commit("Choose", with_choice(state_.document(), changed.id, *port,
                                                static_cast<uint32_t>(pick(port->choices.size()))));
        else if (lanes_of_field(*port) > 0)
            state_.commit("Value", with_number(state_.document(), changed.id, *port, 0, number));
    }
    void drag() {
        const std::string id = node().id, key = "drag " + std::to_string(random_());
        for (int i = 0; i < 5; ++i)
            state_.commit("Move",
                          move_node(state_.document(), id, static_cast<double>(pick(800)), 8.0 * i),
                          key);
        if (pick(4) == 0) state_.history.cancel(key);
    }
    void rename() {
        state_.commit("Rename", rename_node(state_.document(), node().id,
                                            "n\u00e9 " + std::to_string(pick(1000))));
    }
    void box(bool frame) {
        const std::string id = "box" + std::to_string(pick(5));
        const Rectangle rect{static_cast<double>(pick(500)), 0, 200, 100};
        Box made{id, "Some \"text\" " + std::to_string(pick(9)), rect, {}, {}};
        const Document& now = state_.document();
        const bool remove = pick(3) == 0;
        const auto boxes = frame ? &Document::frames : &Document::notes;
        state_.commit(frame ? "Frame" : "Note",
                      remove ? remove_box(now, boxes, id) : set_box(now, boxes, made));
    }
    void rarely() {
        const Document& now = state_.document();
        const Node& some = node();
        const Port* port = port_of(some, true);
        GraphInput input;
        switch (pick(6)) {
            case 0:
                refresh(state_);
                return state_.commit("Tidy", tidied(state_).document);
            case 1:
                return state_.commit("Output",
                                     set_output(now, "out" + std::to_string(pick(50)), {"a", "y"}));
            case 2:
                return state_.commit(
                    "Faces", set_back_faces(now, pick(2) ? BackFaces::mirror : BackFaces::flip));
            case 3:
                input.name = "size";
                input.type = "float";
                input.default_value = json::Value::number(0.5);
                return state_.commit("Input", set_graph_input(now, input));
            case 4:
                return state_.commit("No output", remove_output(now, "height"));
            default:
                if (port)
                    state_.commit("Output", with_wire(now, {some.id, port->name}, "", "height"));
        }
    }

    State& state_;
    std::mt19937 random_;
};

TEST_F(Headless, TenThousandRandomEditsUndoToTheStartAndRedoToTheEnd) {
    open(small_graph);
    RandomHand hand(state, 11);
    std::map<size_t, std::string> sampled;
    for (int i = 0; i < 10'000; ++i) {
        if (i % 100 == 0) refresh(state);  // updates the cards that a copied selection needs
        hand.act();
        if (i % 61 == 0) sampled[state.history.at()] = write_document(state.document());
    }
    const std::string end = write_document(state.document());
    const size_t steps = state.history.size();
    ASSERT_GT(steps, 8000U);
    sampled[steps - 1] = end;
    size_t compared = 0;
    const auto compare = [&] {
        const auto found = sampled.find(state.history.at());
        if (found == sampled.end()) return;
        ++compared;
        ASSERT_EQ(write_document(state.document()), found->second) << state.history.at();
    };
    while (state.history.can_undo()) {
        compare();
        state.history.undo();
    }
    EXPECT_EQ(write_document(state.document()), small_graph);
    while (state.history.redo())
        compare();
    EXPECT_EQ(write_document(state.document()), end);
    EXPECT_EQ(state.history.at(), steps - 1);
    EXPECT_GT(compared, 250U);
}

// `count` nodes in a chain, with positions.
std::string long_chain(int count) {
    std::string nodes, places, previous = "0.5";
    for (int i = 0; i < count; ++i) {
        const std::string id = "n" + std::to_string(i);
        nodes += (i ? ",\n" : "") + ("\"" + id) +
                 "\": { \"type\": \"add\", \"in\": { \"a\": " + previous + ", \"b\": 0.25 } }";
        places += (i ? "," : "") + ("\"" + id) + "\": [" + std::to_string(i % 50 * 200) + ", " +
                  std::to_string(i / 50 * 120) + "]";
        previous = "{ \"from\": \"" + id + ".result\" }";
    }
    return "{\"wrinkle\": 1, \"nodes\": {" + nodes + "}, \"outputs\": {\"height\": " + previous +
           "}, \"layout\": {" + places + "}}";
}

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

// Prints its figures; does not check times.
TEST(HistoryFigures, TenThousandStepsOfTwoThousandNodes) {
    Document document = parsed(long_chain(2000));
    History history(document);
    std::mt19937 random(3);
    const auto before = mallinfo2().uordblks;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 10'000; ++i) {
        const std::string id = "n" + std::to_string(random() % 2000);
        const double number = static_cast<double>(random() % 999);
        Document next = history.now();
        switch (i % 4) {
            case 0:
                next = set_value(next, id, "b", json::Value::number(number));
                break;
            case 1:
                next = move_node(next, id, number, number);
                break;
            case 2:
                next = disconnect(next, id, "a");
                break;
            default:
                next = mute_nodes(next, {id}, !next.find(id)->muted);
        }
        history.commit("edit", std::move(next));
    }
    const double time = milliseconds_since(start);
    const auto bytes = mallinfo2().uordblks - before;
    std::printf("%zu steps at 2,000 nodes: %.1f MB, %.3f ms a commit\n", history.size(),
                static_cast<double>(bytes) / 1e6, time / 10'000);
    EXPECT_LT(bytes, 64'000'000U);
}

TEST(HistoryFigures, OneUndoAtFiveThousandNodes) {
    const Document document = parsed(long_chain(5000));
    const auto measure = [&](const char* what, const Document& edited) {
        History history(document);
        history.commit(what, edited);
        std::vector<double> undo, redo;
        for (int i = 0; i < 21; ++i) {
            auto start = std::chrono::steady_clock::now();
            history.undo();
            undo.push_back(milliseconds_since(start));
            start = std::chrono::steady_clock::now();
            history.redo();
            redo.push_back(milliseconds_since(start));
        }
        std::sort(undo.begin(), undo.end());
        std::sort(redo.begin(), redo.end());
        std::printf("5,000 nodes, %s: undo %.3f ms, redo %.3f ms\n", what, undo[10], redo[10]);
        EXPECT_TRUE(history.now().edited);
    };
    measure("value", set_value(document, "n99", "b", json::Value::number(3)));
    measure("move", move_node(document, "n99", 1, 2));
    measure("delete", remove_node(document, "n99"));
    std::set<std::string> all;
    for (const NodePtr& node : document.nodes)
        all.insert(node->id);
    measure("delete all", remove_nodes(document, all));
}

TEST_F(Headless, FiguresOfARefreshAfterUndo) {
    open_file(state, folder.write("long.json", long_chain(5000)));
    refresh(state);
    const auto measure = [&](const char* what, const Document& edited) {
        state.commit(what, edited);
        refresh(state);
        auto start = std::chrono::steady_clock::now();
        state.history.undo();
        const double step = milliseconds_since(start);
        start = std::chrono::steady_clock::now();
        refresh(state);
        std::printf("5,000 nodes, %s: undo %.3f ms, refresh %.1f ms\n", what, step,
                    milliseconds_since(start));
        EXPECT_TRUE(same_document(state.follow.requested_snapshot, state.document()));
    };
    measure("value", set_value(state.document(), "n99", "b", json::Value::number(3)));
    measure("move", move_node(state.document(), "n99", 1, 2));
    measure("delete", remove_node(state.document(), "n99"));
}

TEST(History, ACommitDropsWhatWasUndone) {
    History history(parsed(small_graph));
    history.commit("a", move_node(history.now(), "noise", 1, 1));
    history.undo();
    history.commit("b", move_node(history.now(), "noise", 2, 2));
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.undo_name(), "b");
}

TEST(History, EqualKeysAreOneStepAndCanBeTakenBack) {
    const Document start = parsed(small_graph);
    History history(start);
    for (int i = 1; i < 50; ++i)
        history.commit("move", move_node(history.now(), "noise", i, 0), "drag");
    EXPECT_DOUBLE_EQ(history.now().positions.find("noise")->x, 49);
    history.undo();
    EXPECT_FALSE(history.can_undo());
    EXPECT_EQ(write_document(history.now()), small_graph);
    history.redo();
    history.cancel("another");
    EXPECT_TRUE(history.can_undo());
    history.cancel("drag");
    EXPECT_EQ(write_document(history.now()), small_graph);
    EXPECT_FALSE(history.can_redo());
}

TEST(History, NothingChangedIsNoStep) {
    History history(parsed(small_graph));
    EXPECT_FALSE(history.commit("same", set_value(history.now(), "nobody", "x", {})));
    EXPECT_FALSE(history.can_undo());
}

TEST(History, EveryStateHasItsOwnSerial) {
    History history(parsed(small_graph));
    const uint64_t first = history.serial();
    history.commit("a", move_node(history.now(), "noise", 1, 1));
    const uint64_t second = history.serial();
    history.undo();
    EXPECT_EQ(history.serial(), first);
    history.commit("b", move_node(history.now(), "noise", 2, 2));
    EXPECT_NE(history.serial(), second);
    EXPECT_NE(history.serial(), first);
}

TEST(History, ATextReadAnewIsAStepToo) {
    const Document start = parsed(small_graph);
    Document other = parsed(long_chain(3));
    other.lost = "something";
    History history(start);
    history.commit("Load", other);
    history.undo();
    EXPECT_EQ(write_document(history.now()), small_graph);
    EXPECT_EQ(history.now().lost, "");
    history.redo();
    EXPECT_EQ(write_document(history.now()), long_chain(3));
    EXPECT_EQ(history.now().lost, "something");
}

TEST(History, NodesInAnotherOrderComeBack) {
    const Document start = parsed(long_chain(6));
    Document turned = start;
    std::vector<NodePtr> nodes(start.nodes.begin(), start.nodes.end());
    std::swap(nodes[1], nodes[4]);
    nodes.erase(nodes.begin());
    turned.nodes = Table<NodePtr>(nodes);
    turned.edited = true;
    History history(start);
    history.commit("turn", turned);
    history.undo();
    EXPECT_EQ(canonical_text(history.now()), canonical_text(start));
    history.redo();
    EXPECT_EQ(canonical_text(history.now()), canonical_text(turned));
}

}  // namespace
}  // namespace wrinkle::editor
