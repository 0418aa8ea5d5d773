// Tests of renamed inputs: in the panel, in graphs that use them by a former name, and of preset
// files that are dropped.
#include "editor/model/document/expose.h"
#include "editor/model/document/files.h"
#include "editor/model/document/inputs.h"
#include "editor/model/document/renamed.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "headless.h"
#include "json/write.h"

namespace wrinkle::editor {
namespace {

const char* const aged = R"({
  "wrinkle": 1,
  "inputs": {
    "wear": { "type": "float", "default": 0.25, "slider": [0, 1] },
    "edge": { "type": "float", "default": 0.5, "when": "input.wear > 0", "renamed": ["rim"] }
  },
  "presets": {
    "Old": { "wear": 0.75, "edge": 1 }
  },
  "nodes": {
    "noise": { "type": "fbm", "in": { "scale": { "from": "input.wear" }, "gain": { "from": "input.edge" } } },
    "bump": { "type": "gradient_from_height", "in": { "height": { "from": "noise.height" } } }
  },
  "outputs": {
    "normal": { "from": "bump.gradient" }
  },
  "layout": {
    "noise": [0, 0],
    "bump": [272, 0]
  }
}
)";
const char* const user = R"({
  "wrinkle": 1,
  "nodes": {
    "rust": { "type": "graph:aged.json", "in": { "rim": 0.50 } },
    "number": { "type": "add" }
  },
  "outputs": {
    "normal": { "from": "rust.normal" }
  },
  "layout": {
    "rust": [0, 0],
    "number": [0, 240]
  }
}
)";

class RenamedInputs : public Headless {
protected:
    void rename(const std::string& from, const std::string& to) {
        play("click input:" + from + ":more\nclick input:" + from + ":name\ntype " + to +
             "\nkey Enter");
    }
    std::string names_of(const std::string& input) const {
        const GraphInput* found = state.document().inputs.find(input);
        if (!found) return "no input";
        return found->renamed.is(json::Kind::null) ? "none" : json::one_line(found->renamed);
    }
    std::string saved() const { return text_of(file); }
};

TEST_F(RenamedInputs, ThePanelRenamesWithEverythingInOneStep) {
    open(aged);
    play("assert errors 0\nkey Shift+E\nclick preset\nclick preset:Old");
    rename("wear", "rust");
    EXPECT_EQ(state.history.undo_name(), "Rename input wear to rust");
    EXPECT_EQ(names_of("rust"), R"(["wear"])");
    EXPECT_EQ(state.document().inputs[0].name, "rust") << "its place";
    EXPECT_EQ(state.document().inputs[1].when, "input.rust > 0");
    EXPECT_EQ(state.view.preview_request.preset, "Old");
    EXPECT_TRUE(is_in_preset(state.document(), "Old", "rust"));
    play("assert target input:rust\nassert no-target input:wear\nassert errors 0");
    play("assert wire input.rust noise.scale");
    for (const UniformInfo& each : state.built.running()->reflection.uniforms)
        EXPECT_TRUE(each.port != "rust" || each.value[0] == 0.75);
    play("key Ctrl+Z\nassert clean\nassert target input:wear");
    EXPECT_EQ(write_document(state.document()), aged);
    play("key Ctrl+Shift+Z\nassert target input:rust\nkey Ctrl+S\nassert clean");
    const std::string check =
        program_output("eval " + file.string() + " --preset Old --set input.wear=0.5 --at {}");
    EXPECT_NE(check.find("normal"), std::string::npos) << check;
}

// A name that no file has seen is not worth keeping.
TEST_F(RenamedInputs, OnlyNamesOfTheSavedGraphAreKept) {
    open(aged);
    play("key Shift+E");
    rename("wear", "rust");
    rename("rust", "dirt");
    EXPECT_EQ(names_of("dirt"), R"(["wear"])");
    play("key Ctrl+S\nassert clean");
    rename("dirt", "mud");
    EXPECT_EQ(names_of("mud"), R"(["wear", "dirt"])");
    rename("mud", "wear");
    EXPECT_EQ(names_of("wear"), R"(["dirt"])");
}

TEST_F(RenamedInputs, ANameThatCannotBeIsSaid) {
    open(aged);
    play("key Shift+E");
    const std::pair<const char*, const char*> rows[] = {
        {"edge", "There is an input edge already."},
        {"rim", "rim is a former name of edge, which other files may use."},
        {"a.b", "\"a.b\" cannot be the name of an input: it contains a '.'."},
        {"$a", "\"$a\" cannot be the name of an input: it begins with '$'."}};
    for (const auto& [name, said] : rows) {
        rename("wear", name);
        EXPECT_EQ(state.status, said);
        play("key Escape\nassert no-target input:wear:name\nassert clean");
    }
    EXPECT_EQ(input_name_problem(state.document(), "wear", ""), "Type a name for the input.");
    EXPECT_EQ(input_name_problem(state.document(), "edge", "rim"), "") << "its own former name";
    rename("wear", "wear");
    play("assert no-target input:wear:name\nassert clean");
}

TEST_F(RenamedInputs, AnExposedPortTakesNoFormerName) {
    const Document document = parsed(R"({"wrinkle": 1,
        "inputs": {"wear": {"type": "float", "renamed": ["gain"]}},
        "nodes": {"noise": {"type": "fbm"}}, "outputs": {}})");
    const NodeType& type = *built_in_registry().find("fbm");
    const Port& gain = type.ports[type.find_input("gain")];
    EXPECT_EQ(expose(document, *document.find("noise"), gain).input, "noise_gain");
}

// A graph that uses a former name is clean and stays as it is on the disk; an edit brings the name
// up to date.
TEST_F(RenamedInputs, AGraphThatUsesAFormerNameIsShownWithTheCurrentOne) {
    folder.write("aged.json", aged);
    open(user);
    play("assert errors 0\nassert clean\nassert value rust.edge 0.5");
    EXPECT_FALSE(state.history.can_undo());
    EXPECT_EQ(write_document(state.document()), user);
    play("click node:number\nkey M\nkey Ctrl+S\nassert clean");
    EXPECT_NE(saved().find(R"("in": { "edge": 0.50 })"), std::string::npos) << saved();
    play("key Ctrl+Z\nassert errors 0\nassert value rust.edge 0.5");
}

// The sub-graph is opened from its user and an input is renamed there: undo and redo of the user's
// earlier steps have the current name.
TEST_F(RenamedInputs, InASubgraphReachItsUserAndItsHistory) {
    folder.write("aged.json", aged);
    open(user);
    const auto set = [&](double value) {
        state.commit("Set",
                     set_value(state.document(), "rust", "wear", json::Value::number(value)));
        play("assert errors 0");
    };
    set(0.125);
    set(0.875);
    play("click node:rust\nkey Tab\nassert node noise\nkey Shift+E");
    rename("wear", "dirt");
    play("key Ctrl+S\nassert clean\nkey Shift+Tab\nassert node rust\nassert errors 0");
    play("assert value rust.dirt 0.875\nkey Ctrl+Z\nassert value rust.dirt 0.125\nassert errors 0");
    play(
        "key Ctrl+Z\nassert clean\nassert errors 0\nkey Ctrl+Shift+Z\nassert value rust.dirt "
        "0.125");
    play("key Ctrl+S");
    EXPECT_NE(saved().find(R"("in": { "edge": 0.50, "dirt": 0.125 })"), std::string::npos)
        << saved();
}

TEST_F(RenamedInputs, DamagedListsAreSaidAndKept) {
    for (const char* list : {R"("rim")", "[1]", R"(["a", "a"])", "{}", "null", R"(["a.b"])"}) {
        std::string text = aged;
        const std::string names = R"(["rim"])";
        text.replace(text.find(names), names.size(), list);
        open(text);
        play("key Shift+E");
        EXPECT_FALSE(state.built.problems.list().empty()) << list;
        rename("wear", "rust");
        play("key Ctrl+S");
        EXPECT_NE(saved().find("\"renamed\": " + std::string(list)), std::string::npos) << saved();
        play("key Shift+E");
    }
}

TEST_F(RenamedInputs, ADroppedPresetFileIsAPresetOfTheGraph) {
    open(aged);
    const std::string head = R"({"wrinkle_preset": 1, "graph": "graph.json", "inputs": )";
    folder.write("Worn.preset.json", head + R"({"wear": 1, "rim": 0.125}})");
    folder.write("Old.preset.json", head + R"({"wear": 0.5}})");
    folder.write("bad.preset.json", head + R"({"wears": 0.5}})");
    folder.write("wrong.preset.json", head + R"({"wear": "much"}})");
    folder.write("a.b.preset.json", head + "{}}");
    folder.write("other.preset.json", R"({"wrinkle_preset": 1, "graph": "other.json"})");
    const auto drop = [&](const std::string& name) { play("drop " + name + " canvas\nfinish"); };
    drop("Worn.preset.json");
    EXPECT_EQ(state.view.preview_request.preset, "Worn");
    EXPECT_EQ(state.history.undo_name(), "Load preset Worn");
    const Preset* preset = state.document().presets.find("Worn");
    ASSERT_TRUE(preset);
    ASSERT_EQ(preset->values.size(), 2U);
    EXPECT_EQ(preset->values[1].key, "edge") << "a former name";
    play("assert errors 0\nassert target input:wear\nkey Ctrl+Z\nassert clean");
    drop("Old.preset.json");
    EXPECT_EQ(state.document().presets.find("Old")->values.size(), 1U) << "it is replaced";
    play("key Ctrl+Z\nassert clean");
    const std::pair<const char*, const char*> rows[] = {
        {"bad", "no input 'wears'"},
        {"wrong", "input 'wear' holds a string"},
        {"other", "of \"other.json\""},
        {"a.b", "the name of the preset contains a '.'"},
        {"gone", "cannot be read"}};
    for (const auto& [name, said] : rows) {
        drop(std::string(name) + ".preset.json");
        EXPECT_NE(state.status.find(said), std::string::npos) << state.status;
        play("assert clean");
    }
}

}  // namespace
}  // namespace wrinkle::editor
