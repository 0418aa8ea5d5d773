// Tests of --preset on every command that takes it, and of wrinkle inputs --exposed.
#include "cli/support.h"
#include "json/write.h"

namespace wrinkle::test {
namespace {

constexpr const char* painted = R"({
  "wrinkle": 1,
  "inputs": {
    "wear": { "type": "float", "default": 0.25, "label": "Wear", "group": "Wear/Edges", "limits": [0, 1] },
    "tint": { "type": "color", "default": [0.5, 0.25, 0.125] }
  },
  "presets": { "Old": { "wear": 0.75 }, "White": { "tint": "#ffffff" } },
  "nodes": {},
  "outputs": { "roughness": { "from": "input.wear" }, "color": { "from": "input.tint" } }
}
)";

// Returns the graph after its input "age" was renamed; the preset still has the former name.
std::string with_renamed(std::string text) {
    const std::string limits = "\"limits\": [0, 1]", preset = "\"wear\": 0.75";
    text.replace(text.find(limits), limits.size(), limits + ", \"renamed\": [\"age\"]");
    return text.replace(text.find(preset), preset.size(), "\"age\": 0.75");
}

class PresetTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        put("g.json", painted);
        put("p.preset.json",
            R"({"wrinkle_preset": 1, "graph": "g.json", "inputs": {"wear": 0.875}})");
    }
    // Returns the roughness and the color with these options.
    std::string values(std::vector<std::string> options) const {
        options.insert(options.begin(), {"eval", "g.json", "--at", "{}"});
        const Ran ran = run(options);
        if (ran.code != 0) return ran.err;
        const size_t begin = ran.out.find("\"roughness\"");
        return ran.out.substr(begin, ran.out.find('}') - begin);
    }
};

TEST_F(PresetTest, ComesBeforeEverySet) {
    EXPECT_EQ(values({}), "\"roughness\": 0.25, \"color\": [0.5, 0.25, 0.125]");
    EXPECT_EQ(values({"--preset", "Old"}), "\"roughness\": 0.75, \"color\": [0.5, 0.25, 0.125]");
    EXPECT_EQ(values({"--set", "input.wear=0.5", "--preset", "Old"}),
              "\"roughness\": 0.5, \"color\": [0.5, 0.25, 0.125]");
    EXPECT_EQ(values({"--preset", "Old", "--preset", "White"}),
              "\"roughness\": 0.75, \"color\": [1, 1, 1]");
    EXPECT_EQ(values({"--preset", "Old", "--preset", "Old"}), values({"--preset", "Old"}));
    EXPECT_EQ(values({"--preset", "p.preset.json", "--set", "input.tint=#000000"}),
              "\"roughness\": 0.875, \"color\": [0, 0, 0]");
    EXPECT_EQ(values({"--set", "input.wear=2"}), "\"roughness\": 1, \"color\": [0.5, 0.25, 0.125]")
        << "limits clamp";
}

// An input that had another name: every way to give its value, and the lists of inputs.
TEST_F(PresetTest, AFormerNameIsTheInput) {
    put("g.json", with_renamed(painted));
    put("p.preset.json", R"({"wrinkle_preset": 1, "graph": "g.json", "inputs": {"age": 0.875}})");
    EXPECT_EQ(values({"--set", "input.age=0.5"}), values({"--set", "input.wear=0.5"}));
    EXPECT_TRUE(says(values({"--set", "input.age=0.5"}), "\"roughness\": 0.5"));
    EXPECT_TRUE(says(values({"--preset", "Old"}), "\"roughness\": 0.75"));
    EXPECT_TRUE(says(values({"--preset", "p.preset.json"}), "\"roughness\": 0.875"));
    EXPECT_TRUE(says(run({"inputs", "--exposed", "g.json"}).out,
                     "(\"Wear\", group \"Wear/Edges\", 0 to 1, was \"age\")"));
    const Ran ran = run({"compile", "g.json", "-o", "o.glsl", "--reflect", "o.refl"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    const json::Value wear = parsed(get("o.refl")).find("inputs").at(0);
    EXPECT_EQ(wear.find("renamed").at(0).as_string(), "age");
    EXPECT_EQ(wear.find("uniform").as_string(), "g_input_wear");
    EXPECT_TRUE(says(run({"inputs", "--json", "g.json"}).out, "\"renamed\": [\"age\"]"));
    put("top.json", R"({"wrinkle": 1, "nodes": {"m": {"type": "graph:g.json", "in": {"age": 0.5}}},
  "outputs": {"roughness": {"from": "m.roughness"}}})");
    EXPECT_TRUE(says(run({"eval", "top.json", "--at", "{}"}).out, "\"roughness\": 0.5"));
    put("g.test.json", R"({"cases": [{"name": "a", "set": ["input.age=0.5"], "points": [{}],
  "expect": [{"roughness": 0.5}]}]})");
    EXPECT_EQ(run({"test", "g.test.json"}).out, "1 passed, 0 failed\n");
}

// The file of a graph that uses a former name is unchanged until `upgrade` or an edit.
TEST_F(PresetTest, FormatAndUpgradeWriteTheNamesThatTheyKnow) {
    put("g.json", with_renamed(painted));
    put("top.json", R"({
  "wrinkle": 1,
  "nodes": {
    "m": { "type": "graph:g.json", "in": { "age": 0.50 } }
  },
  "outputs": {
    "roughness": { "from": "m.roughness" }
  }
}
)");
    const std::string before = get("top.json");
    EXPECT_EQ(run({"format", "g.json", "top.json"}).code, 0);
    EXPECT_TRUE(says(get("g.json"), "\"Old\": { \"wear\": 0.75 }"));
    EXPECT_EQ(get("top.json"), before) << "format reads no other file";
    EXPECT_EQ(run({"upgrade", "--check", "top.json"}).code, 1);
    EXPECT_EQ(run({"upgrade", "top.json"}).code, 0);
    EXPECT_TRUE(says(get("top.json"), "\"in\": { \"wear\": 0.50 }"));
    EXPECT_EQ(run({"upgrade", "--check", "top.json"}).code, 0);
}

// Every command names the fault and its line.
TEST_F(PresetTest, DamagedFormerNamesAreNamed) {
    std::string many = "\"a\"";
    for (int i = 0; i < 100'000; ++i)
        many += ",\"a" + std::to_string(i) + "\"";
    const std::pair<std::string, std::string> rows[] = {
        {"\"age\"", "\"renamed\" is a string (expected an array)"},
        {"null", "\"renamed\" is null (expected an array)"},
        {"[1]", "a name in \"renamed\" is a number (expected a string)"},
        {"[{\"from\": \"a.b\"}]", "a name in \"renamed\" is an object (expected a string)"},
        {"[\"age\", \"age\"]", "\"renamed\" repeats a name (expected different names)"},
        {"[\"tint\"]",
         "\"renamed\" has 'tint', which is the name of another input (remove it "
         "from \"renamed\", or give that input another name)"},
        {"[\"" + std::string(1 << 20, 'x') + "\"]", "is longer than 128 characters"},
        {"[" + many + "]", "\"renamed\" has 100001 names (expected 1 to 32)"},
        {"[\"\\u001b[2J\"]", "a name in \"renamed\" contains a control character"},
    };
    const std::vector<std::vector<std::string>> commands = {
        {"check", "g.json"},
        {"compile", "g.json", "-o", "o.glsl"},
        {"eval", "g.json", "--at", "{}", "--set", "input.wear=1"}};
    const std::string limits = "\"limits\": [0, 1]";
    for (const auto& [list, problem] : rows) {
        std::string text = painted;
        text.replace(text.find(limits), limits.size(), limits + ", \"renamed\": " + list);
        put("g.json", text);
        for (const std::vector<std::string>& words : commands) {
            const Ran ran = run(words);
            EXPECT_EQ(ran.code, 1) << words[0] << list.substr(0, 40);
            EXPECT_TRUE(says(ran.err, problem)) << words[0] << ran.err.substr(0, 400);
            EXPECT_TRUE(says(ran.err, "g.json:4:")) << ran.err.substr(0, 400);
        }
    }
}

TEST_F(PresetTest, FaultsAreNamed) {
    EXPECT_TRUE(says(values({"--preset", "Odl"}),
                     "g.json: error: the graph has no preset 'Odl' (it has Old, White)"));
    EXPECT_TRUE(says(values({"--preset", "gone.preset.json"}), "gone.preset.json: error: "));
    EXPECT_TRUE(says(values({"--preset", "/dev/null.json"}), "/dev/null.json: error: "));
    put("q.preset.json", R"({"wrinkle_preset": 1, "graph": "h.json", "inputs": {}})");
    EXPECT_TRUE(says(values({"--preset", "q.preset.json"}),
                     "q.preset.json:1:32: error: the preset is of \"h.json\", not of \"g.json\""));
    EXPECT_TRUE(says(values({"--set", "input.tint=#12"}),
                     "the value holds a string (expected an array of 3 numbers or \"#rrggbb\")"));
    EXPECT_EQ(run({"eval", "g.json", "--at", "{}", "--preset", "Odl"}).code, 1);
}

// Text and reflection with --set, with a preset and with the value in the file are the same bytes.
TEST_F(PresetTest, EqualsTheValueInTheFile) {
    std::string edited = painted;
    put("e/g.json", edited.replace(edited.find("0.25"), 4, "0.875"));
    const auto made = [&](const std::string& graph, const std::vector<std::string>& more) {
        std::vector<std::string> words = {"compile", graph, "-o", "o.glsl", "--reflect", "o.refl"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(run(words).code, 0);
        return get("o.glsl") + get("o.refl");
    };
    const std::string expected = made("e/g.json", {});
    EXPECT_TRUE(says(expected, "0.875"));
    EXPECT_EQ(made("g.json", {"--preset", "p.preset.json"}), expected);
    EXPECT_EQ(made("g.json", {"--set", "input.wear=0.875"}), expected);
    EXPECT_NE(made("g.json", {}), expected);
}

TEST_F(PresetTest, IsInTheReflectionAndTheDependencies) {
    const Ran ran = run({"compile", "g.json", "--preset", "p.preset.json", "-o", "o.glsl",
                         "--reflect", "o.refl", "-MD"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(parsed(get("o.refl")).find("uniforms").at(0).find("value").as_number(), 0.875);
    EXPECT_TRUE(says(get("o.glsl.d"), "p.preset.json"));
    EXPECT_EQ(run({"compile", "g.json", "--preset", "p.preset.json", "-o", "p.preset.json"}).code,
              1)
        << "a preset is an input";
    put("h.json", painted);
    const Ran several = run({"compile", "g.json", "h.json", "--preset", "Old", "-o", "out"});
    EXPECT_EQ(several.code, 0) << several.err;
}

TEST_F(PresetTest, TheReflectionDescribesTheInputs) {
    put("i.json", R"({"wrinkle": 1, "inputs": {
    "wear": {"type": "float", "default": 0.25, "slider": [0, 0.5], "limits": [0, 1], "step": 0.125,
             "unit": "m", "label": "Wear", "group": "Wear/Edges", "widget": "number"},
    "amount": {"type": "float", "default": 2},
    "idle": {"type": "vec2", "when": "input.wear > 0"},
    "octaves": {"type": "count", "default": 3, "limits": [2, 5]}},
  "presets": {"Old": {"wear": 0.75, "octaves": 4}},
  "nodes": {"f": {"type": "fbm", "in": {"octaves": {"from": "input.octaves"}}},
            "g": {"type": "gradient_from_height", "in": {"height": {"from": "f.height"}}},
            "s": {"type": "gradient_scale", "in": {"gradient": {"from": "g.gradient"},
                                                   "amount": {"from": "input.amount"}}}},
  "outputs": {"roughness": {"from": "input.wear"}, "normal": {"from": "s.gradient"}}})");
    const auto inputs = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = {"compile", "i.json", "-o", "o.glsl", "--reflect", "r"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(run(words).code, 0);
        return parsed(get("r")).find("inputs");
    };
    const json::Value list = inputs({"--preset", "Old", "--name", "rust"});
    ASSERT_EQ(list.size(), 4u);
    EXPECT_EQ(json::one_line(list.at(0)),
              R"({ "name": "wear", "type": "float", "default": 0.75, "slider": [0, 0.5], )"
              R"("limits": [0, 1], "step": 0.125, "unit": "m", "label": "Wear", )"
              R"("group": "Wear/Edges", "widget": "number", "uniform": "rust_input_wear", )"
              R"("built_in": false })");
    EXPECT_TRUE(says(get("o.glsl"), "uniform float rust_input_wear;"));
    EXPECT_EQ(list.at(1).find("slider").at(0).as_number(), -2) << "that of the port it feeds";
    EXPECT_EQ(list.at(1).find("unit").as_string(), "x");
    EXPECT_FALSE(list.at(2).has("uniform")) << "nothing reads it";
    EXPECT_EQ(list.at(2).find("when").as_string(), "input.wear > 0");
    EXPECT_EQ(list.at(3).find("default").as_number(), 4);
    EXPECT_TRUE(list.at(3).find("built_in").as_boolean());
    EXPECT_FALSE(list.at(3).has("uniform"));
    EXPECT_EQ(inputs({"--outputs", "roughness"}).size(), 4u);
}

TEST_F(PresetTest, IsPartOfTheKeyOfTheCache) {
    const auto reflected = [&](const std::string& preset) {
        std::vector<std::string> words = {"compile",   "g.json", "-o",      "o.glsl",
                                          "--reflect", "o.refl", "--cache", "kept"};
        if (!preset.empty()) words.insert(words.end(), {"--preset", preset});
        EXPECT_EQ(run(words).code, 0);
        return parsed(get("o.refl")).find("uniforms").at(0).find("value").as_number();
    };
    for (int turn = 0; turn < 2; ++turn) {
        EXPECT_EQ(reflected(""), 0.25);
        EXPECT_EQ(reflected("Old"), 0.75);
        EXPECT_EQ(reflected("p.preset.json"), 0.875);
    }
}

TEST_F(PresetTest, IsTakenByCheckAndBake) {
    EXPECT_EQ(run({"check", "g.json", "--preset", "Old"}).code, 0);
    EXPECT_EQ(run({"check", "g.json", "--preset", "Odl"}).code, 1);
    const auto baked = [&](const std::string& preset, const std::string& out) {
        const Ran ran = run({"bake", "g.json", "--mesh", "plane", "-o", out, "--map", "roughness",
                             "--size", "16", "--preset", preset});
        EXPECT_EQ(ran.code, 0) << ran.err;
        return get(out);
    };
    EXPECT_NE(baked("Old", "a.png"), baked("p.preset.json", "b.png"));
    EXPECT_EQ(baked("White", "c.png"), baked("White", "d.png"));
}

// Choices, counts and flags are not uniforms: another value is another text.
TEST_F(PresetTest, OptionsAreBuiltIn) {
    put("o.json", R"({"wrinkle": 1, "inputs": {
    "octaves": {"type": "count", "default": 2}, "basis": {"type": "choice", "default": "value"}},
  "presets": {"Fine": {"octaves": 8, "basis": "simplex"}},
  "nodes": {"f": {"type": "fbm", "in": {"octaves": {"from": "input.octaves"},
                                        "basis": {"from": "input.basis"}}}},
  "outputs": {"height": {"from": "f.height"}}})");
    const auto text = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = {"compile", "o.json", "--reflect",
                                          "o.refl",  "-o",     "o.glsl"};
        words.insert(words.end(), more.begin(), more.end());
        const Ran ran = run(words);
        EXPECT_EQ(parsed(get("o.refl")).find("uniforms").size(), 0u);
        return ran.code == 0 ? get("o.glsl") : ran.err;
    };
    const std::string fine = text({"--preset", "Fine"});
    EXPECT_NE(fine, text({}));
    EXPECT_EQ(text({"--set", "input.octaves=8", "--set", "input.basis=simplex"}), fine);
    EXPECT_EQ(text({"--set", "f.octaves=8", "--set", "f.basis=simplex"}), fine);
    EXPECT_TRUE(says(text({"--set", "input.octaves=9"}), "(expected an integer from 1 to 8)"));
    EXPECT_TRUE(
        says(text({"--set", "input.basis=perlin"}), "(expected gradient, simplex or value)"));
    const Ran listed = run({"inputs", "--json", "o.json"});
    const json::Value basis = parsed(listed.out).find("graphs").at(0).find("exposed").at(1);
    EXPECT_TRUE(basis.find("built_in").as_boolean());
    EXPECT_EQ(basis.find("choices").size(), 3u);
}

TEST_F(PresetTest, ExposedInputsAreListed) {
    const Ran ran = run({"inputs", "--exposed", "g.json"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out,
              R"(    wear             float   0.25         ("Wear", group "Wear/Edges", 0 to 1)
    tint             color   [0.5, 0.25, 0.125]
presets
    Old              wear=0.75
    White            tint="#ffffff"
)");
    const json::Value graph = parsed(run({"inputs", "--json", "g.json"}).out).find("graphs").at(0);
    ASSERT_EQ(graph.find("exposed").size(), 2u);
    const json::Value wear = graph.find("exposed").at(0);
    EXPECT_EQ(wear.find("name").as_string(), "wear");
    EXPECT_EQ(wear.find("type").as_string(), "float");
    EXPECT_EQ(wear.find("default").as_number(), 0.25);
    EXPECT_EQ(wear.find("limits").at(1).as_number(), 1);
    EXPECT_EQ(wear.find("group").as_string(), "Wear/Edges");
    EXPECT_FALSE(wear.find("built_in").as_boolean());
    ASSERT_EQ(graph.find("presets").size(), 2u);
    EXPECT_EQ(graph.find("presets").at(1).find("name").as_string(), "White");
    EXPECT_EQ(graph.find("inputs").size(), 1u) << "files, as before";
    put("none.json", R"({"wrinkle": 1, "nodes": {}, "outputs": {}})");
    EXPECT_EQ(run({"inputs", "--exposed", "none.json"}).out, "");
    put("bad.json", R"({"wrinkle": 1, "inputs": {"\u001b[2J": {"type": "float"}}, "nodes": {}})");
    EXPECT_EQ(run({"inputs", "--exposed", "bad.json"}).code, 1);
}

// The inputs of a node's port are those of the port that a single input feeds.
TEST_F(PresetTest, AnExposedInputHasThePortsRange) {
    put("s.json", R"({"wrinkle": 1, "inputs": {"k": {"type": "float", "default": 1}},
  "nodes": {"s": {"type": "gradient_scale", "in": {"amount": {"from": "input.k"}}}},
  "outputs": {"normal": {"from": "s.gradient"}}})");
    const Ran ran = run({"inputs", "--exposed", "s.json"});
    EXPECT_TRUE(says(ran.out, "1 leaves it unchanged, negative inverts it (x, slider -2 to 2)"))
        << ran.out;
}

TEST_F(PresetTest, CasesHaveTheirOwn) {
    put("g.test.json", R"({
  "preset": "Old",
  "points": [{}],
  "expect": [{ "roughness": 0.75 }],
  "cases": [
    { "name": "old", "points": [{}], "expect": [{ "roughness": 0.75 }] },
    { "name": "file", "preset": "p.preset.json", "points": [{}], "expect": [{ "roughness": 0.875 }] },
    { "name": "set", "set": ["input.wear=0.5"], "points": [{}], "expect": [{ "roughness": 0.5 }] },
    { "name": "wrong", "preset": "White", "points": [{}], "expect": [{ "color": [1, 1, 0] }] }
  ]
}
)");
    const Ran ran = run({"test", "g.test.json"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.out, "FAIL g.wrong/points/0: output 'color'"));
    EXPECT_TRUE(ran.out.ends_with("4 passed, 1 failed\n")) << ran.out << ran.err;
    EXPECT_EQ(run({"test", "--update", "g.test.json"}).code, 0);
    EXPECT_TRUE(says(get("g.test.json"), "\"color\": [1, 1, 1]"));
    EXPECT_EQ(run({"test", "g.test.json"}).out, "5 passed, 0 failed\n");
}

TEST_F(PresetTest, UpdateWritesTheEntriesAndGoldenFilesOfEachCase) {
    put("g.test.json", R"({
  "cases": [
    { "name": "a", "glsl": true, "points": [{}, {}] },
    { "name": "b", "preset": "Old", "points": [{}] },
    { "name": "c", "preset": "White", "glsl": true }
  ]
}
)");
    const Ran ran = run({"test", "--update", "g.test.json"});
    EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
    const json::Value cases = parsed(get("g.test.json")).find("cases");
    EXPECT_EQ(cases.at(0).find("expect").size(), 2u);
    EXPECT_EQ(cases.at(1).find("expect").at(0).find("roughness").as_number(), 0.75);
    EXPECT_FALSE(cases.at(2).has("expect"));
    EXPECT_TRUE(exists("golden/g.a.glsl"));
    EXPECT_TRUE(exists("golden/g.c.glsl"));
    EXPECT_EQ(run({"test", "g.test.json"}).out, "5 passed, 0 failed\n");
}

TEST_F(PresetTest, BadCasesAreNamed) {
    const auto problems = [&](const std::string& cases) {
        put("g.test.json", "{\"cases\": " + cases + "}");
        const Ran ran = run({"test", "g.test.json"});
        EXPECT_EQ(ran.code, 1) << cases;
        return ran.err;
    };
    EXPECT_TRUE(says(problems("{}"), "cases is an object (an array)"));
    EXPECT_TRUE(says(problems("[]"), "there is no case in this file"));
    EXPECT_TRUE(says(problems("[3]"), "an entry of 'cases' is a number"));
    EXPECT_TRUE(says(problems(R"([{"name": "a"}])"), "there is no case in this entry"));
    EXPECT_TRUE(says(problems(R"([{"glsl": true}])"), "an entry of 'cases' has no name"));
    EXPECT_TRUE(says(problems(R"([{"name": "../a", "glsl": true}])"), "cannot be part of a file"));
    EXPECT_TRUE(says(problems(R"([{"name": "a", "glsl": true}, {"name": "a", "glsl": true}])"),
                     "two entries of 'cases' have the name 'a'"));
    EXPECT_TRUE(
        says(problems(R"([{"name": "a", "glsl": true, "cases": []}])"), "unknown key 'cases'"));
    EXPECT_TRUE(says(problems(R"([{"name": "a", "glsl": true, "preset": "Odl"}])"),
                     "the graph has no preset 'Odl'"));
    put("../x.json", "{}");
    EXPECT_TRUE(says(problems(R"([{"name": "a", "glsl": true, "preset": "../x.json"}])"),
                     "leads outside the root"));
}

}  // namespace
}  // namespace wrinkle::test
