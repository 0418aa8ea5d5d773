// Tests of the keys of graph inputs and of presets: reading, messages, canonical text, edits.
#include <gtest/gtest.h>

#include "graph/condition.h"
#include "graph/edit.h"
#include "graph/sample.h"

namespace wrinkle {
namespace {

const std::string exposed = R"({
  "wrinkle": 1,
  "inputs": {
    "wear": {
      "type": "float",
      "default": 0.50,
      "slider": [0, 1.0],
      "limits": [0, 2],
      "step": 0.010,
      "unit": "m",
      "label": "Wear",
      "group": "Wear/Edges",
      "widget": "slider",
      "when": "input.kind == old",
      "doc": "How worn",
      "renamed": ["age", "old wear"]
    },
    "kind": { "type": "choice", "default": "old", "choices": ["old", "new"], "label": "Kind" }
  },
  "presets": {
    "Old": { "wear": 0.80 },
    "All": {
      "a": 1,
      "b": [1, 2.0],
      "c": "x.png",
      "d": { "file": "x.png" },
      "e": true
    },
    "None": {}
  },
  "nodes": {},
  "outputs": {}
}
)";

std::string input_with(const std::string& keys) {
    return "{\"wrinkle\": 1, \"inputs\": {\n\"i\": {\"type\": \"float\", " + keys + "}}}";
}

TEST(GraphInputs, EveryKeyIsReadAndWritten) {
    Diagnostics problems;
    const Document document = read_document(exposed, "g.json", problems);
    EXPECT_EQ(to_text(problems), "");
    EXPECT_EQ(canonical_text(document), exposed);
    report_unknown(document, problems);
    EXPECT_EQ(to_text(problems), "");
    const GraphInput& wear = document.inputs[0];
    EXPECT_EQ(wear.label, "Wear");
    EXPECT_EQ(wear.group, "Wear/Edges");
    EXPECT_EQ(wear.widget, "slider");
    EXPECT_EQ(wear.unit, "m");
    EXPECT_EQ(wear.when, "input.kind == old");
    EXPECT_EQ(wear.step.as_number(), 0.01);
    EXPECT_EQ(range_of(wear.slider)->most, 1);
    EXPECT_EQ(range_of(wear.limits)->most, 2);
    EXPECT_FALSE(range_of(document.inputs[1].slider));
    EXPECT_EQ(document.inputs[1].choices.at(1).as_string(), "new");
    ASSERT_EQ(document.presets.size(), 3u);
    EXPECT_EQ(document.presets[1].values.size(), 5u);
}

TEST(GraphInputs, AValueOfAnotherFormIsNamedAndKept) {
    const struct {
        const char *keys, *problem;
    } rows[] = {
        {R"("label": 3)", "2:33: error: \"label\" is a number (expected a string)"},
        {R"("slider": 1)", "2:34: error: \"slider\" is a number (expected an array)"},
        {R"("slider": null)", "2:34: error: \"slider\" is null (expected an array)"},
        {R"("slider": [1])",
         "2:34: error: \"slider\" holds 1 values (expected two numbers, the lesser first: [0, 1])"},
        {R"("limits": [1, 0])",
         "2:34: error: \"limits\" is reversed (expected two numbers, the lesser first: [0, 1])"},
        {R"("limits": [1, 1])",
         "2:34: error: \"limits\" is empty (expected two numbers, the lesser first: [0, 1])"},
        {R"("limits": [0, "1"])",
         "2:38: error: an end of \"limits\" is a string (expected a number)"},
        {R"("limits": [0, 1e39])",
         "2:38: error: \"limits\" is too large for single precision (at most 3.4e38)"},
        {R"("step": 0)", "2:32: error: \"step\" is 0 (expected a number greater than 0)"},
        {R"("step": -1e-3)", "2:32: error: \"step\" is -1e-3 (expected a number greater than 0)"},
        {R"("choices": [])", "2:35: error: \"choices\" has 0 names (expected 1 to 256)"},
        {R"("choices": ["a", 1])",
         "2:41: error: a name in \"choices\" is a number (expected a string)"},
        {R"("choices": ["a", "a"])",
         "2:41: error: \"choices\" repeats a name (expected different names)"},
        {R"("renamed": "age")", "2:35: error: \"renamed\" is a string (expected an array)"},
        {R"("renamed": { "age": 1 })", "2:35: error: \"renamed\" is an object (expected an array)"},
        {R"("renamed": [])", "2:35: error: \"renamed\" has 0 names (expected 1 to 32)"},
        {R"("renamed": ["age", null])",
         "2:43: error: a name in \"renamed\" is null (expected a string)"},
        {R"("renamed": [["age"]])",
         "2:36: error: a name in \"renamed\" is an array (expected a string)"},
        {R"("renamed": ["age", "age"])",
         "2:43: error: \"renamed\" repeats a name (expected different names)"},
        {R"("renamed": [""])",
         "2:36: error: \"renamed\" has an empty name (expected different names)"},
        {R"("renamed": ["age", "a.b"])",
         "2:43: error: a name in \"renamed\" contains a '.' (expected former names of the input)"},
        {R"("choices": [""])",
         "2:36: error: \"choices\" has an empty name (expected different names)"},
    };
    for (const auto& [keys, problem] : rows) {
        EXPECT_EQ(problems_of(input_with(keys)), "g.json:" + std::string(problem) + "\n") << keys;
        const Document document = read_quietly(input_with(keys));
        EXPECT_NE(canonical_text(document).find(keys), std::string::npos) << keys;
    }
}

TEST(GraphInputs, FormerNamesAreFewAndShort) {
    const auto problems = [](const std::string& names) {
        return problems_of(input_with("\"renamed\": [" + names + "]"));
    };
    std::string names = "\"a0\"";
    for (int i = 1; i < 32; ++i)
        names += ", \"a" + std::to_string(i) + "\"";
    EXPECT_EQ(problems(names), "");
    EXPECT_EQ(problems(names + ", \"b\""),
              "g.json:2:35: error: \"renamed\" has 33 names (expected 1 to 32)\n");
    EXPECT_EQ(problems("\"" + std::string(128, 'x') + "\""), "");
    EXPECT_EQ(problems("\"" + std::string(129, 'x') + "\""),
              "g.json:2:36: error: a name in \"renamed\" is longer than 128 characters (expected "
              "former names of the input)\n");
}

TEST(GraphInputs, NumbersThatAreNoneEndTheText) {
    for (const char* value : {"[0, NaN]", "[0, Infinity]", "[0, 1e999]"})
        EXPECT_NE(problems_of(input_with("\"limits\": " + std::string(value))), "") << value;
}

TEST(GraphInputs, AnUnknownKeyHasTheNearestName) {
    Diagnostics problems;
    report_unknown(read_quietly(input_with(R"("sliders": [0, 1])")), problems);
    EXPECT_EQ(to_text(problems),
              "g.json:2:24: error: unknown key \"sliders\" (did you mean \"slider\"?)\n");
}

TEST(GraphInputs, AnEditOfOneKeepsTheOthers) {
    const Document document = read_quietly(exposed);
    GraphInput input = document.inputs[0];
    EXPECT_TRUE(set_graph_input(document, input).inputs.same(document.inputs));
    input.label = "Age";
    std::string expected = exposed;
    expected.replace(expected.find("\"Wear\""), 6, "\"Age\"");
    EXPECT_EQ(canonical_text(set_graph_input(document, input)), expected);
}

TEST(Presets, AreEditedByName) {
    const Document document = read_quietly(exposed);
    Preset old = document.presets[0];
    EXPECT_TRUE(set_preset(document, old).presets.same(document.presets));
    old.values[0].value = json::Value::number(0.5);
    std::string expected = exposed;
    expected.replace(expected.find("0.80"), 4, "0.5");
    EXPECT_EQ(canonical_text(set_preset(document, old)), expected);
    EXPECT_EQ(remove_preset(document, "Old").presets.size(), 2u);
    EXPECT_FALSE(remove_preset(document, "Ol").edited);
}

TEST(Presets, OfOtherFormsAreNamedAndKept) {
    const std::string text = R"({"wrinkle": 1, "presets": {"A": 1, "b.c": {}}, "nodes": {}})";
    EXPECT_EQ(problems_of(text),
              "g.json:1:33: error: the preset is a number (expected an object)\n"
              "g.json:1:36: error: the preset name \"b.c\" contains a '.' (expected 1 to 128 "
              "characters without '.', not beginning with '$')\n");
    EXPECT_NE(canonical_text(read_quietly(text)).find("\"A\": 1,"), std::string::npos);
    EXPECT_EQ(problems_of(R"({"wrinkle": 1, "presets": []})"),
              "g.json:1:27: error: \"presets\" is an array (expected an object)\n");
    EXPECT_EQ(problems_of(R"({"wrinkle": 1, "presets": {"a": {}, "b": {}}})", {.presets = 1}),
              "g.json:1:37: error: the graph has more presets than are allowed (the limit is 1)\n");
}

TEST(Conditions, HaveThreeForms) {
    const auto parts = [](const char* text) {
        const auto found = parse_condition(text);
        return found ? found->input + "|" + found->op + "|" + found->value : "none";
    };
    EXPECT_EQ(parts("input.coat"), "coat|!=|");
    EXPECT_EQ(parts("!input.coat"), "coat|==|");
    EXPECT_EQ(parts("input.coat > 0"), "coat|>|0");
    EXPECT_EQ(parts("input.coat >= 0.5"), "coat|>=|0.5");
    EXPECT_EQ(parts("input.two words != a b"), "two words|!=|a b");
    for (const char* text : {"", "coat", "input.", "input", "!input.a > 0", "input. > 0"})
        EXPECT_EQ(parts(text), "none") << text;
}

}  // namespace
}  // namespace wrinkle
