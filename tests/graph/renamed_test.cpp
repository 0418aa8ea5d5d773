// Tests of former names of graph inputs: in presets, in nodes of sub-graphs, and the edit.
#include "graph/renamed.h"

#include <gtest/gtest.h>

#include "graph/edit.h"
#include "graph/sample.h"
#include "graph/subgraph.h"
#include "support/files.h"

namespace wrinkle {
namespace {

const std::string worn = R"({
  "wrinkle": 1,
  "inputs": {
    "wear": { "type": "float", "renamed": ["age", "years"] },
    "tint": { "type": "color", "when": "input.wear > 0" }
  },
  "presets": {
    "Old": { "tint": [1, 0, 0], "age": 0.80 },
    "New": { "wear": 0, "tint": [0, 1, 0] }
  },
  "nodes": {
    "n": { "type": "add", "in": { "a": { "from": "input.wear" }, "b": { "from": "input.tint" } } }
  },
  "outputs": {
    "roughness": { "from": "input.wear" }
  }
}
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

std::vector<std::string> keys(const Preset& preset) {
    std::vector<std::string> names;
    for (const Extra& value : preset.values)
        names.push_back(value.key);
    return names;
}

TEST(FormerNames, LeadToTheInputUnlessAnotherHasTheName) {
    const FormerNames names(read_quietly(R"({"wrinkle": 1, "inputs": {
            "wear": {"type": "float", "renamed": ["age", "tint", "rust"]},
            "tint": {"type": "float"}, "dirt": {"type": "float", "renamed": ["rust"]}}})")
                                .inputs);
    EXPECT_EQ(names.current("age"), "wear");
    EXPECT_EQ(names.current("tint"), "") << "an input has this name";
    EXPECT_EQ(names.current("rust"), "wear") << "the first; check() reports it";
    EXPECT_EQ(names.current("wear"), "");
    EXPECT_EQ(names.current("Age"), "");
    EXPECT_TRUE(FormerNames({}).empty());
}

// An untouched file stays; an edited one has the current name, with the number as it was spelled.
TEST(FormerNames, InPresetsOfTheGraphBecomeCurrentOnes) {
    const Document document = read_quietly(worn);
    EXPECT_EQ(keys(document.presets[0]), (std::vector<std::string>{"tint", "wear"}));
    EXPECT_FALSE(document.edited);
    EXPECT_EQ(write_document(document), worn);
    EXPECT_EQ(write_document(remove_preset(document, "New")),
              replaced(replaced(worn, "\"age\": 0.80", "\"wear\": 0.80"),
                       ",\n    \"New\": { \"wear\": 0, \"tint\": [0, 1, 0] }", ""));
}

TEST(FormerNames, OfAnInputThatThePresetSetsStay) {
    const std::string twice = replaced(worn, "\"age\": 0.80", "\"years\": 2, \"age\": 3");
    EXPECT_EQ(keys(read_quietly(twice).presets[0]),
              (std::vector<std::string>{"tint", "wear", "age"}));
    const std::string both = replaced(worn, "\"age\": 0.80", "\"age\": 2, \"wear\": 3");
    EXPECT_EQ(keys(read_quietly(both).presets[0]),
              (std::vector<std::string>{"tint", "age", "wear"}));
}

TEST(FormerNames, InWiresOfTheGraphItselfAreErrorsWithTheRemedy) {
    EXPECT_EQ(problems_of(replaced(worn, "{ \"from\": \"input.wear\" },",
                                   "{ \"from\": \"input.years\" },")),
              "g.json:12:40: error: node 'n': the graph has no input 'years' (it is called 'wear' "
              "now)\n");
}

TEST(FormerNames, OfPortsOfSubgraphsBecomeCurrentOnes) {
    const test::TemporaryFolder folder;
    folder.put("worn.json", worn);
    const std::string text = R"({
  "wrinkle": 1,
  "nodes": {
    "m": { "type": "graph:worn.json", "in": { "age": 0.50, "other": 1 } },
    "same": { "type": "graph:worn.json", "in": { "wear": 1 } },
    "add": { "type": "add", "in": { "age": 1 } }
  },
  "outputs": {}
}
)";
    folder.put("top.json", text);
    Diagnostics problems;
    const Project project = load_project(folder.path() / "top.json", {}, problems);
    EXPECT_EQ(to_text(problems), "");
    const Document& top = project.top();
    EXPECT_EQ(top.nodes[0]->inputs[0].port, "wear");
    EXPECT_EQ(top.nodes[0]->inputs[1].port, "other");
    EXPECT_TRUE(top.nodes[2]->find("age")) << "no sub-graph";
    EXPECT_EQ(write_document(top), text) << "an untouched file";
    EXPECT_EQ(write_document(set_value(top, "add", "b", json::Value::number(1))),
              replaced(replaced(text, "\"age\": 0.50", "\"wear\": 0.50"), "\"age\": 1 }",
                       "\"age\": 1, \"b\": 1 }"));
    const Diagnostic at = diagnose_port(top, *top.nodes[0], "wear", RuleId::invalid_value, "here");
    EXPECT_EQ(at.pointer, "/nodes/m/in/age") << "as written in the file";
    EXPECT_EQ(at.where.line, 4u);
}

TEST(Renaming, AnInputChangesEverythingThatNamesItAndKeepsItsPlace) {
    const Document document = read_quietly(worn);
    const std::string current = replaced(worn, "\"age\": 0.80", "\"wear\": 0.80");
    std::string expected =
        replaced(replaced(current, "input.wear", "input.rust"), "\"wear\":", "\"rust\":");
    EXPECT_EQ(write_document(rename_graph_input(document, "wear", "rust", false)), expected);
    expected = replaced(expected, "\"years\"]", "\"years\", \"wear\"]");
    const Document renamed = rename_graph_input(document, "wear", "rust", true);
    EXPECT_EQ(write_document(renamed), expected);
    EXPECT_EQ(write_document(document), worn);
    const Document back = rename_graph_input(renamed, "rust", "wear", false);
    EXPECT_EQ(write_document(back), current);
}

TEST(Renaming, ToAFormerNameOfItsOwnTakesItOffTheList) {
    const Document renamed = rename_graph_input(read_quietly(worn), "wear", "age", true);
    const GraphInput* input = renamed.inputs.find("age");
    ASSERT_TRUE(input);
    ASSERT_EQ(input->renamed.size(), 2u);
    EXPECT_EQ(input->renamed.at(0).as_string(), "years");
    EXPECT_EQ(input->renamed.at(1).as_string(), "wear");
    const Document alone =
        rename_graph_input(read_quietly(replaced(worn, ", \"years\"", "")), "wear", "age", false);
    EXPECT_TRUE(alone.inputs.find("age")->renamed.is(json::Kind::null));
}

TEST(Renaming, ToANameThatIsTakenOrInvalidIsNoEdit) {
    const Document document = read_quietly(worn);
    for (const char* name : {"", "a.b", "$a", "wear", "tint"})
        EXPECT_FALSE(rename_graph_input(document, "wear", name, true).edited) << name;
    EXPECT_FALSE(rename_graph_input(document, "tint", "age", true).edited)
        << "a former name of another input";
    EXPECT_FALSE(rename_graph_input(document, "nobody", "x", true).edited);
}

}  // namespace
}  // namespace wrinkle
