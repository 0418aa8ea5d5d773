// Tests of graph inputs as ports, the clamping of their values, and presets.
#include <gtest/gtest.h>

#include "graph/edit.h"
#include "graph/write.h"
#include "json/write.h"
#include "lower/check.h"
#include "lower/fixture.h"
#include "lower/literal.h"
#include "lower/override.h"
#include "lower/preset.h"

namespace wrinkle {
namespace {

using test::graph;

// Returns "doc|unit|slider|limits" of an input of the top graph.
std::string port_text(const std::string& inputs, const std::string& nodes) {
    Diagnostics problems;
    const Project project =
        test::project(graph(nodes, "", "\"inputs\": {" + inputs + "}, "), problems);
    EXPECT_EQ(to_text(problems), "");
    const Types types(project, test::registry());
    const Port& port = types.graph_input(0, 0);
    const auto range = [](bool has, double least, double most) {
        return has ? std::to_string(int(least)) + ".." + std::to_string(int(most)) : "";
    };
    return port.doc + "|" + port.unit + "|" +
           range(port.has_soft_range(), port.soft_min, port.soft_max) + "|" +
           range(port.has_hard_range(), port.hard_min, port.hard_max);
}

const std::string one_reader = R"("v": {"type": "vector", "in": {"scale": {"from": "input.k"}}})";

TEST(GraphInputPorts, InheritFromTheOnePortThatTheyFeed) {
    EXPECT_EQ(port_text(R"("k": {"type": "vec2"})", one_reader), "One|||0..8");
    EXPECT_EQ(port_text(R"("k": {"type": "vec2", "doc": "Mine", "unit": "m", "slider": [2, 3],
                           "limits": [1, 5]})",
                        one_reader),
              "Mine|m|2..3|1..5");
    EXPECT_EQ(port_text(R"("k": {"type": "vec2"})",
                        one_reader +
                            R"(, "w": {"type": "vector", "in": {"scale": {"from": "input.k"}}})"),
              "|||")
        << "two ports are fed";
    EXPECT_EQ(port_text(R"("k": {"type": "vec2"})", R"("n": {"type": "number"})"), "|||");
}

TEST(GraphInputPorts, OfSubgraphsInheritThroughEveryLevel) {
    const test::Files files({
        {"main.json",
         graph(R"("s": {"type": "graph:s.json", "in": {"outer": {"from": "input.k"}}})",
               R"("a": {"from": "s.scale"})", R"("inputs": {"k": {"type": "vec2"}}, )")},
        {"s.json",
         graph(R"("t": {"type": "graph:t.json", "in": {"inner": {"from": "input.outer"}}})",
               R"("scale": {"from": "t.scale"})",
               R"("inputs": {"outer": {"type": "vec2", "unit": "m"}}, )")},
        {"t.json", graph(R"("v": {"type": "vector", "in": {"scale": {"from": "input.inner"}}})",
                         R"("scale": {"from": "v.scale"})",
                         R"("inputs": {"inner": {"type": "vec2", "slider": [3, 4]}}, )")},
    });
    Diagnostics problems;
    const Project project = load_project(files.folder / "main.json", {}, problems);
    EXPECT_EQ(to_text(problems), "");
    const Types types(project, test::registry());
    const Port& port = types.graph_input(0, 0);
    EXPECT_EQ(port.doc, "One");
    EXPECT_EQ(port.unit, "m");
    EXPECT_EQ(port.soft_min, 3);
    EXPECT_EQ(port.hard_max, 8);
}

Module lowered(const std::string& inputs, const std::string& nodes, const std::string& outputs) {
    Diagnostics problems;
    const Project project =
        test::project(graph(nodes, outputs, "\"inputs\": {" + inputs + "}, "), problems);
    Lowered result = lower(project, Types(project, test::registry()), {}, problems);
    EXPECT_EQ(to_text(problems), "");
    return std::move(result.module);
}

TEST(GraphInputLimits, ClampTheDefaultAndTheUniform) {
    const Module m = lowered(R"("k": {"type": "float", "default": 9, "limits": [-1, 2]})",
                             R"("s": {"type": "scale", "in": {"amount": {"from": "input.k"}}})",
                             R"("a": {"from": "input.k"})");
    ASSERT_EQ(m.parameters.size(), 1u);
    EXPECT_EQ(m.parameters[0].value[0], 2);
    const Inst& top = m[m.outputs[0].value];
    ASSERT_EQ(top.op, Op::min_);
    EXPECT_TRUE(m.is_literal(top.arg[1], 2));
    ASSERT_EQ(m[top.arg[0]].op, Op::max_);
    EXPECT_TRUE(m.is_literal(m[top.arg[0]].arg[1], -1));
}

// Inherited limits are those of a port, which clamps its wire: there is one min and one max.
TEST(GraphInputLimits, OfAPortClampOnce) {
    const Module m = lowered(R"("k": {"type": "float"})",
                             R"("n": {"type": "number", "in": {"value": {"from": "input.k"}}})",
                             R"("a": {"from": "n.value"}, "b": {"from": "input.k"})");
    EXPECT_EQ(m[m.outputs[0].value].op, Op::min_);
    EXPECT_EQ(m[m.outputs[1].value].op, Op::parameter_);
    EXPECT_EQ(m[m[m[m.outputs[0].value].arg[0]].arg[0]].op, Op::parameter_);
}

const std::string all_options =
    R"("o": {"type": "options", "in": {"mode": {"from": "input.mode"}, "octaves": {"from": "input.n"},
       "tile": {"from": "input.tile"}}})";

// The value of the node "options" is 100 mode + 10 octaves + tile.
TEST(GraphInputOptions, AreConstantsOfTheModule) {
    const auto is = [](const std::string& mode, const std::string& n, const std::string& tile,
                       double value) {
        const Module m = lowered(R"("mode": {"type": "choice", "default": )" + mode +
                                     R"(}, "n": {"type": "count", "default": )" + n +
                                     R"(}, "tile": {"type": "flag", "default": )" + tile + "}",
                                 all_options, R"("a": {"from": "o.value"})");
        EXPECT_TRUE(m.parameters.empty());
        EXPECT_TRUE(m.is_literal(m.outputs[0].value, value)) << value;
    };
    is("\"first\"", "1", "false", 10);
    is("\"third\"", "7", "true", 271);
    is("\"second\"", "8", "false", 180);
}

// By name: the choices of an input may be fewer and in another order.
TEST(GraphInputOptions, ChoicesAreNames) {
    const Module m =
        lowered(R"("mode": {"type": "choice", "default": "third", "choices": ["third", "first"]})",
                R"("o": {"type": "options", "in": {"mode": {"from": "input.mode"}}})",
                R"("a": {"from": "o.value"})");
    EXPECT_TRUE(m.is_literal(m.outputs[0].value, 240));
}

// Two uses of a file: one with a literal, one with the input of the top graph, which the file
// passes on to another; with and without functions.
TEST(GraphInputOptions, PassThroughSubgraphs) {
    const std::string input =
        R"("inputs": {"m": {"type": "choice", "default": "first", "choices": ["first", "third"]}}, )";
    const test::Files files({
        {"main.json",
         graph(R"("a": {"type": "graph:s.json", "in": {"m": {"from": "input.m"}}},
                  "b": {"type": "graph:s.json", "in": {"m": "first"}}, "c": {"type": "graph:s.json"})",
               R"("a": {"from": "a.value"}, "b": {"from": "b.value"}, "c": {"from": "c.value"})",
               R"("inputs": {"m": {"type": "choice", "default": "third"}}, )")},
        {"s.json", graph(R"("t": {"type": "graph:t.json", "in": {"m": {"from": "input.m"}}})",
                         R"("value": {"from": "t.value"})", input)},
        {"t.json", graph(R"("o": {"type": "options", "in": {"mode": {"from": "input.m"}}})",
                         R"("value": {"from": "o.value"})", input)},
    });
    Diagnostics problems;
    const Project project = load_project(files.folder / "main.json", {}, problems);
    const Types types(project, test::registry());
    check(project, test::registry(), types, problems);
    EXPECT_EQ(to_text(problems), "");
    EXPECT_EQ(types.graph_input(0, 0).choices, (std::vector<std::string>{"first", "third"}));
    for (const uint64_t inlined : {uint64_t{1000}, uint64_t{0}}) {
        LowerOptions options;
        options.inline_up_to = inlined;
        const Module m = lower(project, types, options, problems).module;
        EXPECT_EQ(to_text(problems), "");
        EXPECT_TRUE(m.is_literal(m.outputs[0].value, 240));
        EXPECT_TRUE(m.is_literal(m.outputs[1].value, 40));
        EXPECT_TRUE(m.is_literal(m.outputs[2].value, 40));
    }
}

TEST(GraphInputOptions, AreSetByPresetsAndOverrides) {
    Diagnostics problems;
    const Project project =
        test::project(graph(all_options, R"("a": {"from": "o.value"})",
                            R"("inputs": {"mode": {"type": "choice", "default": "first"},
                 "n": {"type": "count", "default": 1}, "tile": {"type": "flag", "default": false}},
                 "presets": {"P": {"mode": "third", "tile": true}}, )"),
                      problems);
    const auto set = [&](const Project& from, const char* text) {
        const auto change = parse_override(text, problems);
        return with_overrides(from, test::registry(), std::span(&*change, 1), 0, problems);
    };
    const Project changed = set(with_preset(project, "P", problems), "input.n=2");
    EXPECT_EQ(to_text(problems), "");
    const Module m = lower(changed, Types(changed, test::registry()), {}, problems).module;
    EXPECT_TRUE(m.is_literal(m.outputs[0].value, 221));
    set(project, "input.mode=forth");
    set(project, "input.n=9");
    set(project, "input.tile=1");
    EXPECT_EQ(to_text(problems),
              "error: --set input.mode=forth: the value has no choice \"forth\" (expected first, "
              "second or third)\n"
              "error: --set input.n=9: the value holds 9 (expected an integer from 1 to 8)\n"
              "error: --set input.tile=1: the value holds a number (expected true or false)\n");
}

TEST(Colors, AreAlsoWrittenDisplayEncoded) {
    std::array<double, 4> numbers{};
    const auto hex = [&](const char* text) {
        return literal_numbers(json::Value::string(text), PortType::color_, numbers);
    };
    ASSERT_TRUE(hex("#ff8000"));
    EXPECT_EQ(numbers[0], 1);
    EXPECT_NEAR(numbers[1], 0.21586050, 1e-7);  // ((128/255 + 0.055) / 1.055)^2.4 by bc
    EXPECT_EQ(numbers[2], 0);
    ASSERT_TRUE(hex("#0A0a0A"));
    EXPECT_NEAR(numbers[0], 10 / 255.0 / 12.92, 1e-15);
    for (const char* text : {"", "#", "#fff", "#ff800", "#ff80000", "ff8000", "#gg0000", "#-10000",
                             "#+10000", "#f f000"})
        EXPECT_FALSE(hex(text)) << text;
    EXPECT_FALSE(literal_numbers(json::Value::string("#ff8000"), PortType::vec3_, numbers));
}

const std::string painted = graph(
    R"("n": {"type": "number", "in": {"value": {"from": "input.wear"}}},
       "v": {"type": "vector", "in": {"tint": {"from": "input.tint"}}},
       "t": {"type": "texture", "in": {"image": {"from": "input.map"}}})",
    R"("a": {"from": "n.value"}, "c": {"from": "v.tint"}, "m": {"from": "t.color"})",
    R"("inputs": {"wear": {"type": "float", "default": 0.25}, "tint": {"type": "color"},
                  "map": {"type": "image", "default": "a.png"}},
       "presets": {"Old": {"wear": 0.75, "tint": "#ffffff"}, "Odd": {"wears": 1, "tint": [1, 2]}}, )");

class PresetTest : public testing::Test {
protected:
    // Returns the values of the inputs after the preset, or the problems.
    std::string applied(const std::string& preset, int times = 1) {
        Diagnostics problems;
        Project project = load_project(files.folder / "painted.json", {}, problems);
        for (int i = 0; i < times; ++i)
            project = with_preset(project, preset, problems);
        check(project, test::registry(), Types(project, test::registry()), problems);
        preset_files = project.preset_files;
        if (problems.has_errors()) return without_folder(to_text(problems));
        std::string text;
        for (const GraphInput& input : project.top().inputs)
            text += input.name + "=" + json::one_line(input.default_value) + " ";
        return text;
    }
    std::string without_folder(std::string text) const {
        const std::string here = files.folder.string() + "/";
        for (size_t at = text.find(here); at != text.npos; at = text.find(here))
            text.erase(at, here.size());
        return text;
    }
    std::string file_with(const std::string& text) {
        files.temporary.put("x.preset.json", text);
        return applied((files.folder / "x.preset.json").string());
    }

    test::Files files{{{"painted.json", painted},
                       {"other.json", graph("", "")},
                       {"a.png", ""},
                       {"sub/b.png", ""}}};
    std::vector<std::string> preset_files;
};

std::string sound_graph() {
    return graph(
        R"("n": {"type": "number", "in": {"value": {"from": "input.wear"}}})",
        R"("a": {"from": "n.value"})",
        R"("inputs": {"wear": {"type": "float", "default": 0.25}, "tint": {"type": "color"},
                    "map": {"type": "image", "default": "a.png"}},
                    "presets": {"Old": {"wear": 0.75, "tint": "#ffffff"}}, )");
}

TEST_F(PresetTest, OfTheGraphSetsItsInputs) {
    files.temporary.put("painted.json", sound_graph());
    EXPECT_EQ(applied("Old"), "wear=0.75 tint=\"#ffffff\" map=\"a.png\" ");
    EXPECT_EQ(applied("Old", 2), applied("Old")) << "twice is once";
    EXPECT_TRUE(preset_files.empty());
    EXPECT_EQ(applied("Ol"),
              "painted.json: error: the graph has no preset 'Ol' (did you mean 'Old'?)\n");
    EXPECT_EQ(applied("zzzz"),
              "painted.json: error: the graph has no preset 'zzzz' (it has Old)\n");
}

TEST_F(PresetTest, OfTheGraphIsCheckedEvenIfItIsNotUsed) {
    files.temporary.put("painted.json", painted);
    Diagnostics problems;
    const Project project = load_project(files.folder / "painted.json", {}, problems);
    check(project, test::registry(), Types(project, test::registry()), problems);
    const std::string text = to_text(problems);
    EXPECT_NE(text.find("preset 'Odd', input 'wears' does not exist (did you mean 'wear'?)"),
              text.npos)
        << text;
    EXPECT_NE(text.find("preset 'Odd', input 'tint' holds an array of 2 (expected an array of 3 "
                        "numbers or \"#rrggbb\")"),
              text.npos)
        << text;
}

TEST_F(PresetTest, OfAFileSetsInputsAndIsAnInputFile) {
    files.temporary.put("painted.json", sound_graph());
    EXPECT_EQ(file_with(R"({"wrinkle_preset": 1, "graph": "painted.json", "inputs": {"wear": 1}})"),
              "wear=1 tint=null map=\"a.png\" ");
    EXPECT_EQ(preset_files.size(), 1u);
    EXPECT_EQ(file_with(R"({"wrinkle_preset": 1, "graph": "./painted.json"})"),
              "wear=0.25 tint=null map=\"a.png\" ");
}

TEST_F(PresetTest, ImagesAreRelativeToItsFile) {
    files.temporary.put("painted.json", sound_graph());
    const std::string head =
        R"({"wrinkle_preset": 1, "graph": "../painted.json", "inputs": {"map": )";
    const std::string file = (files.folder / "sub/y.preset.json").string();
    files.temporary.put("sub/y.preset.json", head + "\"b.png\"}}");
    EXPECT_EQ(applied(file), "wear=0.25 tint=null map=\"sub/b.png\" ");
    files.temporary.put("sub/y.preset.json", head + R"({"file": "../a.png", "wrap": "clamp"}}})");
    EXPECT_EQ(applied(file),
              "wear=0.25 tint=null map={ \"file\": \"a.png\", \"wrap\": \"clamp\" } ");
    files.temporary.put("sub/y.preset.json", head + "\"a.png\"}}");
    EXPECT_NE(applied(file).find("names \"sub/a.png\", which does not exist"), std::string::npos);
    files.temporary.put("sub/y.preset.json", head + "\"../../a.png\"}}");
    EXPECT_NE(applied(file).find("outside the root"), std::string::npos);
}

TEST_F(PresetTest, AFaultIsNamedAtItsPlace) {
    files.temporary.put("painted.json", sound_graph());
    const struct {
        const char *text, *problem;
    } rows[] = {
        {"", "x.preset.json:1:1: error: "},
        {"[]", "x.preset.json:1:1: error: the preset is an array (expected an object)"},
        {"{}", "the preset has no \"wrinkle_preset\" (expected \"wrinkle_preset\": 1)"},
        {R"({"wrinkle_preset": 1})", "the preset has no \"graph\" (expected \"graph\": "},
        {R"({"wrinkle_preset": 2, "graph": "painted.json"})",
         "x.preset.json:1:20: error: the format version is 2 (this program reads version 1)"},
        {R"({"wrinkle_preset": "1", "graph": "painted.json"})",
         "\"wrinkle_preset\" is a string (expected a number)"},
        {R"({"wrinkle_preset": 1, "graph": "other.json"})",
         "x.preset.json:1:32: error: the preset is of \"other.json\", not of \"painted.json\""},
        {R"({"wrinkle_preset": 1, "graph": "gone.json"})", "the preset is of \"gone.json\""},
        {R"({"wrinkle_preset": 1, "graph": 1})", "\"graph\" is a number (expected a string)"},
        {R"({"wrinkle_preset": 1, "graph": "painted.json", "inputs": []})",
         "\"inputs\" is an array (expected an object)"},
        {R"({"wrinkle_preset": 1, "graph": "painted.json", "input": {}})",
         "unknown key \"input\" (did you mean 'inputs'?)"},
        {R"({"wrinkle_preset": 1, "graph": "painted.json", "inputs": {"wears": 1}})",
         "x.preset.json:1:68: error: the graph has no input 'wears' (did you mean 'wear'?)"},
        {R"({"wrinkle_preset": 1, "graph": "painted.json", "inputs": {"wear": "x"}})",
         "x.preset.json:1:67: error: input 'wear' holds a string (expected a number)"},
        {R"({"wrinkle_preset": 1, "graph": "painted.json", "inputs": {"wear": NaN}})",
         "x.preset.json:1:67: error: "},
        {R"({"wrinkle_preset": 1, "graph": "painted.json", "inputs": {"tint": "#12345"}})",
         "input 'tint' holds a string (expected an array of 3 numbers or \"#rrggbb\")"},
    };
    for (const auto& [text, problem] : rows)
        EXPECT_NE(file_with(text).find(problem), std::string::npos) << text << "\n"
                                                                    << file_with(text);
    EXPECT_NE(
        applied((files.folder / "gone.preset.json").string()).find("gone.preset.json: error: "),
        std::string::npos);
    EXPECT_NE(applied((files.folder / "sub/../.json").string()).find("error: "), std::string::npos);
}

}  // namespace
}  // namespace wrinkle
