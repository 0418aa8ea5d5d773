// Tests of the panel of inputs and presets, by hand, and of the values that it shows.
#include "editor/model/document/inputs.h"
#include "editor/view/canvas/layout.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "headless.h"
#include "json/write.h"

namespace wrinkle::editor {
namespace {

const char* const worn = R"({"wrinkle": 1, "inputs": {
        "wear": {"type": "float", "default": 0.25, "slider": [0, 1], "step": 0.01},
        "edge": {"type": "float", "default": 0.5, "slider": [0, 1], "when": "input.wear > 0"},
        "tint": {"type": "color", "default": [1, 0, 0], "group": "Paint"},
        "mode": {"type": "choice", "default": "simplex", "group": "Paint"},
        "octaves": {"type": "count", "default": 4},
        "flat": {"type": "flag", "default": false}},
    "presets": {"Old": {"wear": 0.75, "mode": "gradient"}, "New": {"wear": 0}},
    "nodes": {
        "noise": {"type": "fbm", "in": {"scale": {"from": "input.wear"},
            "gain": {"from": "input.edge"}, "octaves": {"from": "input.octaves"},
            "basis": {"from": "input.mode"}}},
        "cut": {"type": "height_remap", "in": {"height": {"from": "noise.height"},
            "clamped": {"from": "input.flat"}}},
        "mix": {"type": "vec3_mix", "in": {"a": {"from": "input.tint"}}},
        "bump": {"type": "gradient_from_height", "in": {"height": {"from": "cut.height"}}}},
    "outputs": {"normal": {"from": "bump.gradient"}, "color": {"from": "mix.vector"}}})";

class InputsPanelTest : public Headless {
protected:
    void SetUp() override {
        open(worn);
        play("assert errors 0\nkey Shift+E");
    }
    std::string default_of(const std::string& name) const {
        return json::one_line(state.document().inputs.find(name)->default_value);
    }
    std::string value_of(const std::string& preset, const std::string& name) const {
        return json::one_line(
            value_of_input(state.document(), preset, *state.document().inputs.find(name)));
    }
    const std::string& chosen() const { return state.view.preview_request.preset; }
    // First numbers of the inputs that the preview draws, by name: those of the running program,
    // which has a uniform for each, as later values replaced them.
    std::map<std::string, double> uniforms() const {
        std::map<std::string, double> values;
        const Document drawn = with_preset_as_defaults(state.model, state.follow.sent_snapshot,
                                                       state.follow.sent_preset);
        for (const UniformInfo& each : state.follow.drawn.running()->reflection.uniforms)
            if (each.graph_input)
                values[each.port] = numbers_of_input(drawn, "", *drawn.inputs.find(each.port),
                                                     *port_of_input(state.model, each.port))[0];
        return values;
    }
    std::string names() const {  // in their order
        std::string all;
        for (const GraphInput& input : state.document().inputs)
            all += input.name + " ";
        return all;
    }
    std::string step_name() const { return state.history.undo_name(); }
};

TEST_F(InputsPanelTest, TheKeyAndTheTitlesShowIt) {
    play("assert target input:wear\nassert no-target line:1");
    play("key Shift+E\nassert no-target input:wear\nassert target line:1");
    play("click side:inputs\nassert target input:wear\nclick side:code\nassert target line:1");
}

TEST_F(InputsPanelTest, ADragAlongTheRangeIsOneStep) {
    const std::string before = write_document(state.document());
    const auto slider = *state.targets.find("input:wear");
    const std::string quarter = std::to_string(static_cast<int>((slider.x1 - slider.x0) / 4));
    play("stroke - left input:wear input:wear+8,0 input:wear+" + quarter + ",0");
    EXPECT_NEAR(std::stod(default_of("wear")), 0.75, 0.03);
    const double hundredths = std::stod(default_of("wear")) * 100;
    EXPECT_NEAR(hundredths, std::round(hundredths), 1e-4) << "the step";
    EXPECT_EQ(step_name(), "Set wear");
    EXPECT_NEAR(uniforms()["wear"], std::stod(default_of("wear")), 1e-6);
    play("key Ctrl+Z\nassert clean");
    EXPECT_EQ(write_document(state.document()), before);
}

// Number of compilations, and of values sent to the running program.
struct Work {
    uint64_t builds, sent;
};

TEST_F(InputsPanelTest, ADragSendsItsValuesAndCompilesAtItsEnd) {
    const Work before{state.counters.builds, state.counters.uniforms};
    const auto slider = *state.targets.find("input:wear");
    queue.motion((slider.x0 + slider.x1) / 2, slider.middle_y());
    queue.button(0, true);
    for (int i = 1; i <= 10; ++i) {
        queue.motion(slider.x0 + 10.0F * static_cast<float>(i), slider.middle_y());
        frame();
        frame();
    }
    EXPECT_GE(state.counters.uniforms, before.sent + 10);
    EXPECT_EQ(state.counters.builds, before.builds) << "while the button is down";
    EXPECT_NEAR(uniforms()["wear"], std::stod(default_of("wear")), 1e-6);
    queue.button(0, false);
    for (int i = 0; i < 4; ++i)
        frame();
    EXPECT_EQ(state.counters.builds, before.builds + 1);
}

TEST_F(InputsPanelTest, APresetOfNumbersCompilesNothingButAnOptionDoes) {
    const Work before{state.counters.builds, state.counters.uniforms};
    play("click preset\nclick preset:New");
    EXPECT_EQ(state.counters.builds, before.builds);
    EXPECT_EQ(state.counters.uniforms, before.sent + 1) << "wear only";
    EXPECT_EQ(uniforms()["wear"], 0);
    play("click preset\nclick preset:Old");
    EXPECT_EQ(state.counters.builds, before.builds + 1) << "mode";
    play("click preset\nclick preset:defaults");
    EXPECT_NEAR(uniforms()["wear"], 0.25, 1e-6);
}

TEST_F(InputsPanelTest, OptionsAreTickedAndChosen) {
    play("click input:flat");
    EXPECT_EQ(default_of("flat"), "true");
    play("click input:mode\nclick input:mode:gradient");
    EXPECT_EQ(default_of("mode"), "\"gradient\"");
    play("key Ctrl+Z\nkey Ctrl+Z\nassert clean");
    play("click input:octaves+60,0");
    EXPECT_GT(std::stod(default_of("octaves")), 4);
    EXPECT_EQ(default_of("octaves").find('.'), std::string::npos);
    EXPECT_EQ(step_name(), "Set octaves");
}

TEST_F(InputsPanelTest, AColorIsPickedInDisplayValuesAndStoredLinear) {
    play("click input:tint\nclick input:tint:picker+-80,30");
    const json::Value color = state.document().inputs.find("tint")->default_value;
    ASSERT_EQ(color.size(), 3U);
    EXPECT_EQ(step_name(), "Set tint");
    play("key Escape\nassert no-target input:tint:picker\nassert clean");
}

TEST_F(InputsPanelTest, AnImageIsChosenFromThoseOfTheFolder) {
    const std::string old = "textures/weave_normal.png", other = "textures/rivets_normal.png";
    texture("weave_normal.png");
    texture("rivets_normal.png");
    open(R"({"wrinkle": 1, "inputs": {"map": {"type": "image",
            "default": {"file": ")" +
         old + R"(", "wrap": "clamp"}}},
        "nodes": {"read": {"type": "tangent_normal_map",
            "in": {"image": {"from": "input.map"}}}},
        "outputs": {"normal": {"from": "read.gradient"}}})");
    play("assert errors 0\nclick input:map\nclick input:map:" + other + "\nassert errors 0");
    EXPECT_EQ(default_of("map"), R"({ "file": ")" + other + R"(", "wrap": "clamp" })");
    play("key Ctrl+Z\nassert clean");
}

TEST_F(InputsPanelTest, NumbersKeepToTheirLimitsAndShowAnyUnit) {
    open(R"({"wrinkle": 1, "inputs": {"share": {"type": "float", "default": 50, "unit": "%",
            "slider": [0, 100], "limits": [10, 90]},
            "point": {"type": "vec3", "default": [1, 2, 3]}},
        "nodes": {"scaled": {"type": "multiply", "in": {"a": {"from": "input.share"}}},
            "moved": {"type": "vec3_mix", "in": {"a": {"from": "input.point"}}}},
        "outputs": {"height": {"from": "scaled.result"}, "color": {"from": "moved.vector"}}})");
    play("drag input:share input:share+-100,0");
    EXPECT_EQ(default_of("share"), "10");
    play("stroke - left input:point input:point+30,0 input:point+60,0");
    EXPECT_EQ(step_name(), "Set point");
    EXPECT_EQ(state.document().inputs.find("point")->default_value.size(), 3U);
    play("key Ctrl+Z\nkey Ctrl+Z\nassert clean");
}

TEST_F(InputsPanelTest, EscapeClosesAListAndChangesNothing) {
    play("click preset\nassert target preset:Old\nkey Escape\nassert no-target preset:Old");
    EXPECT_EQ(chosen(), "");
}

TEST_F(InputsPanelTest, AValueIsTypedAndAWrongOneIsSaid) {
    play("click input:wear:more\ntype 0.125\nkey Enter");
    EXPECT_EQ(default_of("wear"), "0.125");
    play("click input:mode:more\ntype marble\nkey Enter");
    EXPECT_EQ(default_of("mode"), "\"simplex\"");
    EXPECT_NE(state.status.find("marble"), std::string::npos) << state.status;
    play("key Escape\nassert no-target input:mode:text");
}

TEST_F(InputsPanelTest, APresetIsShownWithoutAnEditAndEditedInPlace) {
    play("click preset\nclick preset:Old\nassert clean");
    EXPECT_EQ(chosen(), "Old");
    EXPECT_NEAR(uniforms()["wear"], 0.75, 1e-6);
    EXPECT_NEAR(uniforms()["edge"], 0.5, 1e-6);
    play("assert target input:wear:reset\nassert no-target input:edge:reset");
    play("click input:edge:more\ntype 0.1\nkey Enter");
    EXPECT_EQ(value_of("Old", "edge"), "0.1");
    EXPECT_EQ(default_of("edge"), "0.5");
    EXPECT_NEAR(uniforms()["edge"], 0.1, 1e-6);
    play("click input:edge:reset\nassert no-target input:edge:reset");
    EXPECT_FALSE(is_in_preset(state.document(), "Old", "edge"));
    play("click preset\nclick preset:defaults");
    EXPECT_NEAR(uniforms()["wear"], 0.25, 1e-6);
}

TEST_F(InputsPanelTest, PresetsAreSavedAndDeletedInOneStepEach) {
    play("click preset\nclick preset:Old\nclick preset:save\ntype Older\nkey Enter");
    EXPECT_EQ(chosen(), "Older");
    EXPECT_EQ(value_of("Older", "wear"), "0.75");
    EXPECT_EQ(step_name(), "Save preset Older");
    play("click preset:save\ntype Old\nkey Enter");
    EXPECT_EQ(state.status, "There is a preset Old already.");
    play("key Escape\nclick preset:delete");
    EXPECT_EQ(chosen(), "");
    EXPECT_EQ(state.document().presets.find("Older"), nullptr);
    play("key Ctrl+Z");
    EXPECT_NE(state.document().presets.find("Older"), nullptr);
    play("key Ctrl+Z\nassert clean");
}

TEST_F(InputsPanelTest, UndoOfAPresetThatIsShownShowsTheDefaults) {
    play("click preset:save\ntype Mine\nkey Enter");
    EXPECT_EQ(chosen(), "Mine");
    play("key Ctrl+Z\nassert clean");
    EXPECT_EQ(chosen(), "");
}

TEST_F(InputsPanelTest, ARowIsHiddenWhileItsConditionFails) {
    play("assert target input:edge\nclick preset\nclick preset:New\nassert no-target input:edge");
}

TEST_F(InputsPanelTest, ADragOfTheLabelMovesARowAndItsGroup) {
    play("drag input:flat:label input:tint:label");
    EXPECT_EQ(names(), "wear edge flat tint mode octaves ");
    EXPECT_EQ(state.document().inputs.find("flat")->group, "Paint");
    EXPECT_EQ(step_name(), "Move input flat");
    play("key Ctrl+Z\nassert clean\ndrag input:wear:label input:octaves:label");
    EXPECT_EQ(names(), "edge tint mode octaves wear flat ");
    play("assert errors 0\nkey Ctrl+Z\nassert clean");
}

TEST_F(InputsPanelTest, EscapeEndsTheDragOfALabel) {
    const auto from = *state.targets.find("input:flat:label");
    const auto to = *state.targets.find("input:wear:label");
    queue.motion(from.middle_x(), from.middle_y());
    queue.button(0, true);
    queue.motion(to.middle_x(), to.middle_y());
    for (int i = 0; i < 4; ++i)
        frame();
    EXPECT_EQ(state.inputs_panel.carried, "flat");
    queue.key(key_named("Escape"), true);
    queue.key(key_named("Escape"), false);
    queue.motion(to.middle_x(), to.middle_y() + 3);
    for (int i = 0; i < 4; ++i)
        frame();
    queue.button(0, false);
    for (int i = 0; i < 4; ++i)
        frame();
    play("assert clean");
    EXPECT_EQ(names(), "wear edge tint mode octaves flat ");
}

TEST_F(InputsPanelTest, ButtonsMoveARowByOne) {
    play("click input:wear:more\nclick input:wear:down");
    EXPECT_EQ(names(), "edge wear tint mode octaves flat ");
    play("click input:wear:up\nclick input:wear:up\nkey Escape");
    EXPECT_EQ(names(), "wear edge tint mode octaves flat ") << "the first stays";
}

TEST_F(InputsPanelTest, LabelGroupRangeStepAndUnitAreTyped) {
    const auto set = [&](const std::string& input, const std::string& key,
                         const std::string& text) {
        play("click input:" + input + ":more\nclick input:" + input + ":" + key + "\ntype " + text +
             "\nkey Enter");
    };
    set("wear", "in-label", "How worn");
    set("wear", "range", "0, 2");
    set("wear", "step", "0.5");
    set("wear", "unit", "mm");
    set("wear", "group", "Paint");
    const GraphInput& wear = *state.document().inputs.find("wear");
    EXPECT_EQ(wear.label, "How worn");
    EXPECT_EQ(json::one_line(wear.slider), "[0, 2]");
    EXPECT_EQ(json::one_line(wear.step), "0.5");
    EXPECT_EQ(wear.unit, "mm");
    EXPECT_EQ(names(), "edge tint mode wear octaves flat ") << "at the end of its group";
    play("assert errors 0");
    set("wear", "range", "2, 0");
    EXPECT_EQ(state.status, "A range is two numbers, the lesser first: 0, 1");
    play("key Escape\nclick input:wear:more\nclick input:wear:step\ntype -1\nkey Enter");
    EXPECT_EQ(state.status, "A step is a number greater than 0.");
    play(
        "key Escape\nclick input:flat:more\nassert no-target input:flat:range\n"
        "assert target input:flat:group\nkey Escape");
    for (int i = 0; i < 5; ++i)
        play("key Ctrl+Z");
    play("assert clean");
}

TEST_F(InputsPanelTest, AnInputIsRemovedWithItsValueLeftAtTheNode) {
    play("click input:wear:more\nclick input:wear:remove\nassert value noise.scale 0.25");
    EXPECT_EQ(step_name(), "Remove input wear");
    EXPECT_TRUE(state.document().inputs.find("edge")->when.empty());
    play("assert errors 0\nkey Ctrl+Z\nassert clean");
}

TEST_F(InputsPanelTest, AGraphWithoutInputsSaysHowToGetOne) {
    open(small_graph);
    play("assert no-target preset\nassert target side:inputs");
}

TEST(ValuesOfInputs, APresetDoesNotNameAnInputThatHasItsDefault) {
    const Document document = parsed(worn);
    const Document same = with_input_value(document, "Old", "wear", json::Value::number(0.25));
    EXPECT_FALSE(is_in_preset(same, "Old", "wear"));
    EXPECT_TRUE(is_in_preset(same, "Old", "mode"));
    const Document none = with_input_value(document, "None", "wear", json::Value::number(1));
    EXPECT_EQ(write_document(none), write_document(document));
    EXPECT_EQ(preset_name_problem(document, "Old"), "There is a preset Old already.");
    EXPECT_EQ(preset_name_problem(document, ""), "Type a name for the preset.");
    EXPECT_NE(preset_name_problem(document, "a.b"), "");
    EXPECT_EQ(preset_name_problem(document, "Rust 2"), "");
}

TEST(ValuesOfInputs, ConditionsComparePresetValues) {
    const auto displayed = [](const std::string& when, const std::string& preset) {
        const Document document = parsed(
            R"({"wrinkle": 1, "inputs": {
            "n": {"type": "float", "default": 2},
            "f": {"type": "flag", "default": true},
            "c": {"type": "choice", "default": "b", "choices": ["a", "b"]},
            "x": {"type": "float", "when": ")" +
            when + R"("}}, "presets": {"P": {"n": 0, "f": false, "c": "a"}}, "nodes": {},
            "outputs": {}})");
        const Model model = make_model(document, {}, built_in_registry());
        return is_displayed(model, document, preset, *document.inputs.find("x"));
    };
    for (const char* when : {"input.n", "input.n > 1.5", "input.n >= 2", "input.n == 2", "input.f",
                             "input.f == true", "input.c == b", "input.c != a", "input.n != 0"}) {
        EXPECT_TRUE(displayed(when, "")) << when;
        EXPECT_FALSE(displayed(when, "P")) << when;
    }
    for (const char* when : {"!input.n", "input.n < 1", "input.n <= 0", "!input.f",
                             "input.f == false", "input.c == a"}) {
        EXPECT_FALSE(displayed(when, "")) << when;
        EXPECT_TRUE(displayed(when, "P")) << when;
    }
}

}  // namespace
}  // namespace wrinkle::editor
