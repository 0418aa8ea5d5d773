// Tests of the document model without ImGui: changes, values, wires, input queue.
#include <imgui.h>

#include "editor/model/document/change.h"
#include "editor/model/document/field.h"
#include "editor/view/edit/edits.h"
#include "editor/view/input/input_queue.h"
#include "graph/edit.h"
#include "graph/read.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

TEST(Change, TellsLayoutValuesAndStructureApart) {
    const Document a = parsed(small_graph);
    EXPECT_EQ(change(a, a).kind, Change::Kind::none);
    EXPECT_EQ(change(a, move_node(a, "noise", 5, 5)).kind, Change::Kind::cosmetic);
    const Change value = change(a, set_value(a, "softer", "amount", json::Value::number(0.5)));
    EXPECT_EQ(value.kind, Change::Kind::values);
    ASSERT_EQ(value.values.size(), 1U);
    EXPECT_EQ(value.values[0].node, "softer");
    EXPECT_EQ(value.values[0].port, "amount");
    EXPECT_EQ(change(a, reset_value(a, "softer", "amount")).kind, Change::Kind::values);
    EXPECT_EQ(change(a, disconnect(a, "softer", "gradient")).kind, Change::Kind::structure);
    EXPECT_EQ(change(a, mute_nodes(a, {"softer"}, true)).kind, Change::Kind::structure);
    const Document renamed = rename_node(a, "softer", "weaker");
    EXPECT_EQ(change(a, renamed).kind, Change::Kind::names);
    EXPECT_EQ(change(renamed, a).kind, Change::Kind::names);
    const Document swapped =
        rename_node(rename_node(renamed, "noise", "softer"), "weaker", "noise");
    EXPECT_EQ(change(a, swapped).kind, Change::Kind::names) << "each node is where it was";
    const Document rewired = connect(renamed, {"number", "result"}, "weaker", "gradient");
    EXPECT_EQ(change(a, rewired).kind, Change::Kind::structure);
    const Document both = set_value(renamed, "weaker", "amount", json::Value::number(0.5));
    EXPECT_EQ(change(a, both).kind, Change::Kind::values);
    EXPECT_TRUE(change(a, both).renamed);
    EXPECT_EQ(change(a, remove_node(a, "number")).kind, Change::Kind::structure);
    EXPECT_EQ(change(a, remove_output(a, "normal")).kind, Change::Kind::structure);
}

TEST(Change, ValuesOfInputsAndPresetsAreValues) {
    const Document a = parsed(R"({"wrinkle": 1,
        "inputs": {"wear": {"type": "float", "default": 0.5, "slider": [0, 1]}},
        "presets": {"Old": {"wear": 1}},
        "nodes": {"n": {"type": "add", "in": {"a": {"from": "input.wear"}}}},
        "outputs": {"height": {"from": "n.result"}}})");
    const auto with = [&](auto edit) {
        GraphInput input = *a.inputs.find("wear");
        edit(input);
        return set_graph_input(a, input);
    };
    const Document other = with([](GraphInput& i) { i.default_value = json::Value::number(0.25); });
    EXPECT_EQ(change(a, other).kind, Change::Kind::values);
    EXPECT_TRUE(change(a, other).inputs);
    EXPECT_TRUE(change(a, remove_preset(a, "Old")).inputs);
    EXPECT_EQ(change(a, remove_preset(a, "Old")).kind, Change::Kind::values);
    for (const Document& same_kind : {with([](GraphInput& i) { i.default_value = {}; }),
                                      with([](GraphInput& i) { i.slider = {}; }),
                                      with([](GraphInput& i) { i.type = "height"; }),
                                      with([](GraphInput& i) { i.label = "Wear"; }),
                                      remove_graph_input(a, "wear")})
        EXPECT_EQ(change(a, same_kind).kind, Change::Kind::structure);
}

const Port& port_of(const char* type, const char* port) {
    const NodeType& found = *built_in_registry().find(type);
    return found.ports[found.find_input(port)];
}

TEST(Field, WritesNoDefaultAndReadsItBack) {
    Document document = parsed(small_graph);
    const Port& amount = port_of("gradient_scale", "amount");
    EXPECT_DOUBLE_EQ(numbers_at(*document.find("softer"), amount)[0], 0.6);
    document = with_number(document, "softer", amount, 0, amount.default_value[0]);
    EXPECT_EQ(document.find("softer")->find("amount"), nullptr);
    EXPECT_DOUBLE_EQ(numbers_at(*document.find("softer"), amount)[0], amount.default_value[0]);
}

TEST(Field, KeepsToTheHardRangeAndToWholeCounts) {
    const Document document = parsed(small_graph);
    const Port& octaves = port_of("gradient_noise", "octaves");
    ASSERT_TRUE(octaves.has_hard_range());
    const Document many = with_number(document, "noise", octaves, 0, 1e9);
    EXPECT_DOUBLE_EQ(numbers_at(*many.find("noise"), octaves)[0], octaves.hard_max);
    const Document some = with_number(document, "noise", octaves, 0, 2.4);
    EXPECT_EQ(some.find("noise")->find("octaves")->value.spelling(), "2");
    EXPECT_TRUE(same_document(with_number(document, "noise", octaves, 0, NAN), document));
}

TEST(Field, ADragEndsOnDecimalsThatPeopleWrite) {
    const Port& amount = port_of("gradient_scale", "amount");
    for (double pixels = -300; pixels <= 300; pixels += 7) {
        const double value = dragged(0.6, pixels, 120, amount, false, false);
        const Document document = with_number(parsed(small_graph), "softer", amount, 0, value);
        const Input* input = document.find("softer")->find("amount");
        EXPECT_LE(input ? input->value.spelling().size() : 0, 6U) << pixels;
    }
    EXPECT_LT(std::fabs(dragged(0, 10, 120, amount, true, false)),
              std::fabs(dragged(0, 10, 120, amount, false, false)));
}

TEST(Model, WiresGoWhereTheTypesSay) {
    const Document document = parsed(small_graph);
    const Registry& registry = built_in_registry();
    const Model model = make_model(document, ".", registry);
    const auto why = [&](const Link& from, const char* node, const char* port) {
        return wire_problem(model, document, from, node, port);
    };
    EXPECT_EQ(why({"noise", "height"}, "normal", "gradient"), "");
    EXPECT_EQ(why({"noise", "value"}, "number", "a"), "");
    EXPECT_NE(why({"normal", "normal"}, "number", "a"), "");
    EXPECT_NE(why({"noise", "value"}, "noise", "octaves"), "") << "a count takes no wire";
    EXPECT_NE(why({"nobody", "x"}, "number", "a"), "");
    EXPECT_EQ(why({"softer", "gradient"}, "", "normal"), "");
    EXPECT_NE(why({"normal", "normal"}, "", "roughness"), "");
}

TEST(InputQueue, EveryTapIsSeenInOrder) {
    ImGuiIO io;
    InputQueue queue;
    for (int i = 0; i < 100; ++i)
        ASSERT_TRUE(queue.chord("F5"));
    int taps = 0;
    bool down = false;
    for (int frame = 0; frame < 1000 && !queue.empty(); ++frame) {
        queue.apply(io);
        const bool now = io.KeysDown[key_named("F5")];
        taps += now && !down;
        down = now;
    }
    EXPECT_EQ(taps, 100);
    EXPECT_FALSE(queue.chord("Ctrl+Nonsense"));
    EXPECT_TRUE(queue.empty());
}

TEST(InputQueue, AModifierThatIsLetGoFirstStillCounts) {
    ImGuiIO io;
    InputQueue queue;
    queue.key(key_named("Ctrl"), true);
    queue.key(key_named("S"), true);
    queue.key(key_named("Ctrl"), false);
    queue.key(key_named("S"), false);
    queue.apply(io);
    EXPECT_TRUE(io.KeyCtrl);
    EXPECT_TRUE(io.KeysDown[key_named("S")]);
}

TEST(InputQueue, APressIsNeverAtAnotherPlaceThanItsMotion) {
    ImGuiIO io;
    InputQueue queue;
    queue.motion(10, 10);
    queue.button(0, true);
    queue.motion(50, 50);
    queue.button(0, false);
    queue.apply(io);
    EXPECT_TRUE(io.MouseDown[0]);
    EXPECT_FLOAT_EQ(io.MousePos.x, 10);
    queue.apply(io);
    EXPECT_FLOAT_EQ(io.MousePos.x, 50);
    EXPECT_TRUE(io.MouseDown[0]) << "a slider sees where the drag ends";
    queue.apply(io);
    EXPECT_FLOAT_EQ(io.MousePos.x, 50);
    EXPECT_FALSE(io.MouseDown[0]);
}

}  // namespace
}  // namespace wrinkle::editor
