// Tests of former names of graph inputs where values are given: problems and results.
#include <gtest/gtest.h>

#include "json/write.h"
#include "lower/check.h"
#include "lower/exposed.h"
#include "lower/fixture.h"
#include "lower/override.h"
#include "lower/preset.h"

namespace wrinkle {
namespace {

using test::graph;

const std::string number = R"("n": {"type": "number", "in": {"value": {"from": "input.wear"}}})";
const std::string number_out = R"("value": {"from": "n.value"})";
const std::string worn =
    R"("inputs": {"wear": {"type": "float", "default": 0.25, "renamed": ["age", "years"]}}, )";

class Renamed : public testing::Test {
protected:
    Project load(const std::string& top) {
        files.temporary.put("top.json", top);
        problems = Diagnostics();
        return load_project(files.folder / "top.json", {}, problems);
    }
    // Returns the problems of the project without the folder of its files.
    std::string checked(const Project& project) {
        check(project, test::registry(), Types(project, test::registry()), problems);
        std::string text = to_text(problems);
        const std::string here = files.folder.string() + "/";
        for (size_t at = text.find(here); at != text.npos; at = text.find(here))
            text.erase(at, here.size());
        return text;
    }
    std::string checked(const std::string& top) { return checked(load(top)); }
    // Returns the value of the first output.
    double value(const Project& project) {
        EXPECT_EQ(checked(project), "");
        const Lowered lowered = lower(project, Types(project, test::registry()), {}, problems);
        const Module& m = lowered.module;
        const Inst& top = m[m.outputs[0].value];
        EXPECT_EQ(top.op, Op::parameter_);
        return m.parameters.empty() ? -1 : m.parameters[0].value[0];
    }
    Project set(const Project& project, const char* text) {
        const auto change = parse_override(text, problems);
        return with_overrides(project, test::registry(), std::span(&*change, 1), 0, problems);
    }
    Project with_file(const Project& project, const std::string& inputs) {
        files.temporary.put(
            "p.preset.json",
            R"({"wrinkle_preset": 1, "graph": "top.json", "inputs": )" + inputs + "}");
        return with_preset(project, (files.folder / "p.preset.json").string(), problems);
    }

    test::Files files{{{"worn.json", graph(number, number_out, worn)}}};
    Diagnostics problems;
};

TEST_F(Renamed, ValuesArriveFromEverySource) {
    const std::string out = R"("a": {"from": "input.wear"})";
    const Project plain = load(
        graph("", out, worn + R"("presets": {"Old": {"age": 0.5}, "New": {"wear": 0.125}}, )"));
    EXPECT_EQ(value(plain), 0.25);
    EXPECT_EQ(value(set(plain, "input.age=0.75")), 0.75);
    EXPECT_EQ(value(set(plain, "input.years=0.75")), 0.75);
    EXPECT_EQ(value(with_preset(plain, "Old", problems)), 0.5);
    EXPECT_EQ(value(with_file(plain, R"({"age": 0.875})")), 0.875);
    EXPECT_EQ(value(set(with_preset(plain, "Old", problems), "input.age=2")), 2);
}

TEST_F(Renamed, NodesOfSubgraphsTakeValuesAndWires) {
    const std::string out = R"("a": {"from": "s.value"})";
    const Project literal =
        load(graph(R"("s": {"type": "graph:worn.json", "in": {"age": 0.5}})", out));
    const auto is = [&](const Project& project, double value) {
        EXPECT_EQ(checked(project), "");
        const Module m = lower(project, Types(project, test::registry()), {}, problems).module;
        return m.parameters.empty() ? m.is_literal(m.outputs[0].value, value)
                                    : m.parameters[0].value[0] == value;
    };
    EXPECT_TRUE(is(literal, 0.5));
    EXPECT_FALSE(is(literal, 0.25)) << "the default";
    EXPECT_TRUE(is(set(literal, "s.age=0.75"), 0.75));
    EXPECT_TRUE(is(set(literal, "s.wear=0.125"), 0.125));
    const Project wire =
        load(graph(R"("s": {"type": "graph:worn.json", "in": {"years": {"from": "input.k"}}})", out,
                   R"("inputs": {"k": {"type": "float", "default": 0.625}}, )"));
    EXPECT_TRUE(is(wire, 0.625));
}

TEST_F(Renamed, ANameOfTwoInputsIsAnError) {
    const auto with = [&](const std::string& inputs) {
        return checked(
            graph("", R"("a": {"from": "input.wear"})", "\"inputs\": {" + inputs + "}, "));
    };
    EXPECT_EQ(with(R"("wear": {"type": "float", "renamed": ["age"]}, "age": {"type": "float"})"),
              "top.json:1:65: error: input 'wear': \"renamed\" has 'age', which is the name of "
              "another input (remove it from \"renamed\", or give that input another name)\n");
    EXPECT_EQ(with(R"("wear": {"type": "float", "renamed": ["wear"]})"),
              "top.json:1:65: error: input 'wear': \"renamed\" has 'wear', which is its present "
              "name (remove it from \"renamed\")\n");
    EXPECT_EQ(with(R"("wear": {"type": "float", "renamed": ["age"]},
"rust": {"type": "float", "renamed": ["dirt", "age"]})"),
              "top.json:2:47: error: input 'rust': \"renamed\" has 'age', which is also a former "
              "name of 'wear' (remove one of them)\n");
}

TEST_F(Renamed, ConditionsHaveTheCurrentName) {
    EXPECT_EQ(
        checked(graph("", R"("a": {"from": "input.wear"})",
                      R"("inputs": {"wear": {"type": "float", "renamed": ["age"]},
"k": {"type": "float", "when": "input.age > 0"}}, )")),
        "top.json:2:32: error: input 'k': \"when\" names the input 'age', which does not exist "
        "(it is called 'wear' now)\n");
}

TEST_F(Renamed, AValueUnderBothNamesIsAnError) {
    const std::string out = R"("a": {"from": "input.wear"})";
    EXPECT_EQ(checked(graph("", out, worn + R"("presets": {"Old": {"age": 0.5, "wear": 1}}, )")),
              "top.json:1:128: error: preset 'Old', input 'age' is a former name of 'wear', which "
              "is set too (remove one of them)\n");
    EXPECT_EQ(checked(with_file(load(graph("", out, worn)), R"({"wear": 1, "years": 2})")),
              "p.preset.json:1:75: error: input 'years' is a former name of 'wear', which is set "
              "too (remove one of them)\n");
    EXPECT_EQ(checked(graph(R"("s": {"type": "graph:worn.json", "in": {"age": 1, "years": 2}})",
                            R"("a": {"from": "s.value"})")),
              "top.json:1:85: error: node 's': port 'years' is a former name of 'wear', which is "
              "set too (remove one of them)\n");
}

TEST_F(Renamed, NamesAreDescribed) {
    const Project project = load(graph("", R"("a": {"from": "input.wear"})", worn));
    const Types types(project, test::registry());
    EXPECT_EQ(exposed_input(project.top().inputs[0], types.graph_input(0, 0)),
              R"({"name": "wear", "type": "float", "default": 0.25, )"
              R"("renamed": ["age", "years"], "built_in": false})");
}

}  // namespace
}  // namespace wrinkle
