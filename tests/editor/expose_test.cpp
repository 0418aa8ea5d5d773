// Tests of inputs of the graph that are made of values, by hand and as a function of documents.
#include "editor/model/document/expose.h"

#include <set>

#include "editor/model/document/wiring.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/commands/commands.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "headless.h"
#include "json/write.h"
#include "lower/check.h"
#include "registry/reference.h"

namespace wrinkle::editor {
namespace {

const char* const patchy = R"({"wrinkle": 1, "nodes": {
    "noise": {"type": "fbm", "in": {"scale": 3, "octaves": 4, "basis": "simplex"}},
    "other": {"type": "fbm"},
    "bump": {"type": "gradient_from_height", "in": {"height": {"from": "noise.height"}}},
    "red": {"type": "ramp", "in": {"color_1": "#ff0000"}}},
    "outputs": {"normal": {"from": "bump.gradient"}, "color": {"from": "red.color"}},
    "layout": {"noise": [0, 0], "other": [0, 400], "bump": [400, 0], "red": [400, 400]}})";

class ExposedPorts : public Headless {
protected:
    void SetUp() override { open(patchy); }

    const Port& port(const std::string& node, const std::string& name) const {
        return *input_port(state.type_of(node), name);
    }
    void expose_at(const std::string& node, const std::string& name) {
        const Node& from = *state.document().find(node);
        state.commit("expose", expose(state.document(), from, port(node, name)).document);
        frame();
    }
    const GraphInput& input(const std::string& name) const {
        return *state.document().inputs.find(name);
    }
    Diagnostics problems() const {
        Diagnostics found;
        check(*state.model.project, *state.registry, *state.model.types, found);
        return found;
    }
};

std::string told(const json::Value& value) {
    return json::one_line(value);
}

TEST_F(ExposedPorts, TheKeyAtAValueMakesAnInputInOneStep) {
    const std::string before = write_document(state.document());
    play(R"(click field:noise.gain
        key Escape
        key E
        assert wire input.gain noise.gain
        assert errors 0
        assert no-target field:noise.gain)");
    EXPECT_EQ(input("gain").type, "float");
    EXPECT_EQ(told(input("gain").default_value), default_json(port("noise", "gain")));
    EXPECT_TRUE(range_of(input("gain").slider));
    EXPECT_EQ(state.status, "Expose noise.gain as gain");
    play("key Ctrl+Z\nassert clean\nassert target field:noise.gain");
    EXPECT_EQ(write_document(state.document()), before);
}

TEST_F(ExposedPorts, WithoutAPointedValueAListOffersThoseOfTheSelectedNode) {
    play(R"(click node:noise
        key E
        click choice:octaves
        assert wire input.octaves noise.octaves
        assert errors 0)");
    EXPECT_EQ(input("octaves").type, "count");
    EXPECT_EQ(told(input("octaves").default_value), "4");
    EXPECT_EQ(input("octaves").limits.size(), 2U);
    play("click canvas+0,-200\nkey E");
    EXPECT_FALSE(find_command("expose")->enabled(state));
    EXPECT_EQ(state.document().inputs.size(), 1U);
}

TEST_F(ExposedPorts, AllValuesOfSeveralNodesInOneStep) {
    const std::string before = write_document(state.document());
    size_t values = 0;
    for (const char* id : {"noise", "other"})
        values += exposable_ports(*state.document().find(id), *state.type_of(id)).size();
    state.view.selected = {"noise", "other"};
    play("key E\nawait target choice:noise.gain\nkey Enter\nassert errors 0");
    EXPECT_EQ(state.document().inputs.size(), values);
    EXPECT_EQ(link_at(state.document(), "other", "gain"), (Link{"input", "other_gain"}));
    play("key Ctrl+Z\nassert clean");
    EXPECT_EQ(write_document(state.document()), before);
    play("key E\ntype other.gain\nkey Enter\nassert wire input.gain other.gain");
    EXPECT_EQ(state.document().inputs.size(), 1U);
}

TEST_F(ExposedPorts, AnOptionKeepsAPinForItsWire) {
    expose_at("noise", "basis");
    const Card& card = *state.layout.find("noise");
    ASSERT_NE(find_pin(card, "basis", false), nullptr);
    EXPECT_TRUE(find_pin(card, "basis", false)->connected);
    EXPECT_EQ(input("basis").type, "choice");
    EXPECT_EQ(input("basis").choices.size(), port("noise", "basis").choices.size());
    EXPECT_FALSE(problems().has_errors());
    EXPECT_NE(state.layout.wire_to({"noise", "basis"}), nullptr);
}

TEST_F(ExposedPorts, ATakenNameGetsTheNodesName) {
    expose_at("noise", "scale");
    expose_at("other", "scale");
    EXPECT_EQ(told(input("scale").default_value), "3");
    EXPECT_EQ(link_at(state.document(), "other", "scale"), (Link{"input", "other_scale"}));
    expose_at("red", "color_1");
    EXPECT_EQ(told(input("color_1").default_value), "\"#ff0000\"");
    EXPECT_FALSE(problems().has_errors());
}

TEST_F(ExposedPorts, ItIsSaidWhyAPortCannot) {
    const auto why = [&](const char* node, const char* name) {
        return why_not_exposed(*state.document().find(node), port(node, name));
    };
    EXPECT_EQ(why("bump", "height"), "height has a wire.");
    EXPECT_EQ(why("noise", "point"), "point has no value.");
    EXPECT_EQ(why("noise", "gain"), "");
    play("click node:bump\nkey E");
    EXPECT_EQ(state.status, "Every value of the selected nodes has a wire.");
    EXPECT_TRUE(state.document().inputs.empty());
}

std::set<std::string> messages_of(const Document& document) {
    const Model model = make_model(document, {}, built_in_registry());
    Diagnostics found;
    check(*model.project, built_in_registry(), *model.types, found);
    std::set<std::string> messages;
    for (const Diagnostic& problem : found.list())
        messages.insert(problem.message);
    return messages;
}

// Every port of every built-in node that can be exposed becomes an input without a new problem;
// removing the input writes its default at the port.
TEST(Exposing, FitsEveryBuiltInNode) {
    size_t count = 0;
    for (const NodeType& type : built_in_registry().list()) {
        Node node;
        node.id = "n";
        node.type = type.id;
        node.version = static_cast<int>(type.version);
        const Document alone = add_node(Document(), node);
        const std::set<std::string> before = messages_of(alone);
        for (const Port* port : exposable_ports(node, type)) {
            const std::string name = type.id + "." + port->name;
            const Exposed exposed = expose(alone, *alone.find("n"), *port);
            for (const std::string& message : messages_of(exposed.document))
                EXPECT_TRUE(before.contains(message)) << name << ": " << message;
            const Model model = make_model(exposed.document, {}, built_in_registry());
            const Document back = without_input(model, exposed.document, exposed.input);
            EXPECT_TRUE(back.inputs.empty());
            const Input* value = back.find("n")->find(port->name);
            ASSERT_NE(value, nullptr) << name;
            EXPECT_EQ(told(value->value), told(exposed.document.inputs[0].default_value)) << name;
            ++count;
        }
    }
    EXPECT_GT(count, 500U);
}

TEST(WithoutInput, GivesReadersItsValueAndForgetsIt) {
    const Document document = parsed(R"({"wrinkle": 1, "inputs": {
        "wear": {"type": "float", "default": 0.25},
        "edge": {"type": "float", "default": 1, "when": "input.wear > 0"},
        "rust": {"type": "color", "default": [1, 0, 0]}},
        "presets": {"Old": {"wear": 1, "edge": 2}},
        "nodes": {
            "sum": {"type": "add", "in": {"a": {"from": "input.wear"}, "b": {"from": "input.edge"}}},
            "mix": {"type": "vec3_mix", "in": {"a": {"from": "input.wear"},
                "b": {"from": "input.rust"}}}},
        "outputs": {"roughness": {"from": "input.wear"}, "color": {"from": "mix.vector"}}})");
    const Model model = make_model(document, {}, built_in_registry());
    const Document after = without_input(model, document, "wear");
    EXPECT_EQ(after.inputs.find("wear"), nullptr);
    EXPECT_EQ(after.inputs.find("edge")->when, "");
    EXPECT_EQ(told(after.find("sum")->find("a")->value), "0.25");
    EXPECT_EQ(told(after.find("mix")->find("a")->value), "[0.25, 0.25, 0.25]");
    EXPECT_EQ(after.find_output("roughness"), nullptr);
    ASSERT_EQ(after.presets[0].values.size(), 1U);
    EXPECT_EQ(after.presets[0].values[0].key, "edge");
    EXPECT_EQ(link_at(after, "sum", "b"), (Link{"input", "edge"}));
    const Model without = make_model(after, {}, built_in_registry());
    Diagnostics found;
    check(*without.project, built_in_registry(), *without.types, found);
    EXPECT_FALSE(found.has_errors());
    EXPECT_EQ(write_document(without_input(model, document, "none")), write_document(document));
}

}  // namespace
}  // namespace wrinkle::editor
