// Tests that the library and the command line give the same output: text, diagnostics, numbers.
#include <algorithm>
#include <map>

#include "api/support.h"
#include "bench/graphs.h"
#include "json/parse.h"
#include "json/write.h"
#include "support/samples.h"

namespace wrinkle::test {
namespace {

using namespace api;
using Form = CompileOptions::Form;

const std::string graphs = WRINKLE_SOURCE_DIR "/graphs";

// Sample graphs by folder; within one folder all stems differ.
std::map<fs::path, std::vector<fs::path>> samples_by_folder() {
    std::map<fs::path, std::vector<fs::path>> folders;
    for (const fs::path& graph : sample_graphs())
        folders[graph.parent_path()].push_back(graph);
    return folders;
}

struct Written {
    std::string target, suffix;
    Form form = Form::function;
    std::vector<std::string> more = {};  // options of the command line
    CompileOptions options = {};         // the same options for the library
};

void expect_same(const Written& written, const fs::path& graph, const fs::path& folder) {
    const std::string stem = folder / graph.stem();
    CompileOptions options = written.options;
    options.target = written.target;
    options.form = written.form;
    const Shader shader = library().load(graph, graphs).compile(options);
    ASSERT_TRUE(shader.ok) << graph << to_text(shader.problems);
    EXPECT_EQ(shader.reflection, bytes_of(stem + ".json")) << graph;
    if (written.form == Form::function) {
        EXPECT_EQ(shader.source,
                  bytes_of(stem + (written.suffix.empty() ? ".glsl" : written.suffix)))
            << graph;
        EXPECT_TRUE(shader.vertex.empty() && shader.fragment.empty());
        return;
    }
    EXPECT_EQ(shader.vertex, bytes_of(stem + ".vert" + written.suffix)) << graph;
    EXPECT_EQ(shader.fragment, bytes_of(stem + ".frag" + written.suffix)) << graph;
    EXPECT_TRUE(shader.source.empty());
}

class SameTextTest : public testing::TestWithParam<Written> {};

TEST_P(SameTextTest, OfEverySample) {
    const Written& written = GetParam();
    for (const auto& [from, samples] : samples_by_folder()) {
        const TemporaryFolder folder;
        const std::string to = folder.path();
        // With several graphs, --out names a folder; with one graph it names a file.
        ASSERT_GT(samples.size(), 1u) << from;
        std::vector<std::string> words = {"compile",
                                          "--root",
                                          graphs,
                                          "--target",
                                          written.target,
                                          "--form",
                                          written.form == Form::function ? "function" : "shader",
                                          "-o",
                                          to,
                                          "--reflect",
                                          to};
        words.insert(words.end(), written.more.begin(), written.more.end());
        for (const fs::path& sample : samples)
            words.push_back(sample);
        const Said said = run_wrinkle(words);
        ASSERT_EQ(said.code, 0) << said.err;
        for (const fs::path& sample : samples)
            expect_same(written, sample, folder.path());
    }
}

CompileOptions changed(void (*change)(CompileOptions&)) {
    CompileOptions options;
    change(options);
    return options;
}

INSTANTIATE_TEST_SUITE_P(
    Targets, SameTextTest,
    testing::Values(Written{"glsl330", ""}, Written{"glsl450", ""}, Written{"essl300", ""},
                    Written{"glsl330", "", Form::shader}, Written{"glsl450", "", Form::shader},
                    Written{"essl300", "", Form::shader}, Written{"spirv", ".spv", Form::shader},
                    Written{"hlsl", ".hlsl", Form::shader}, Written{"msl", ".msl", Form::shader},
                    Written{"wgsl", ".wgsl", Form::shader}, Written{"hlsl", ".hlsl"},
                    Written{"wgsl", ".wgsl"}, Written{"godot3", ".shader"},
                    Written{"glsl330",
                            "",
                            Form::function,
                            {"--differentials", "given", "--no-tangents", "--srgb", "shader",
                             "--uv-origin", "top", "--normal-space", "tangent"},
                            changed([](CompileOptions& o) {
                                o.differentials = CompileOptions::Differentials::given;
                                o.vertex_tangents = false;
                                o.srgb = CompileOptions::Srgb::shader;
                                o.uv_origin = CompileOptions::UvOrigin::top;
                                o.normal_space = CompileOptions::NormalSpace::tangent;
                            })},
                    Written{"glsl450",
                            "",
                            Form::shader,
                            {"--params", "uniform", "--descriptor-set", "2", "--first-binding", "5",
                             "--name", "mine"},
                            changed([](CompileOptions& o) {
                                o.parameters = CompileOptions::Parameters::uniform;
                                o.descriptor_set = 2;
                                o.first_binding = 5;
                                o.name = "mine";
                            })}),
    [](const auto& info) {
        return info.param.target + (info.param.form == Form::shader ? "_shader" : "_function") +
               (info.param.more.empty() ? "" : "_with_options");
    });

TEST(SameProblems, WordForWord) {
    const TemporaryFolder folder;
    const auto with_node = [](const std::string& node) {
        return R"({ "wrinkle": 1, "nodes": { "n": )" + node + R"( },
  "outputs": { "out": { "from": "n.result" } } })";
    };
    const std::map<std::string, std::string> texts = {
        {"syntax", "{ \"wrinkle\": 1, }"},
        {"empty", ""},
        {"type", with_node(R"({ "type": "multipli" })")},
        {"port", with_node(R"({ "type": "multiply", "in": { "c": 1, "a": "x" } })")},
        {"link", with_node(R"({ "type": "multiply", "in": { "a": { "from": "n.result" } } })")},
        {"twice", with_node(R"({ "type": "add", "in": { "a": 1, "a": 2 } })")},
        {"sub", with_node(R"({ "type": "graph:../outside.json" })")},
        {"image", R"({ "wrinkle": 1, "nodes": { "n": { "type": "tangent_normal_map",
  "in": { "image": "none.png" } } }, "outputs": { "normal": { "from": "n.gradient" } } })"},
        {"fine", tilt_graph()},
    };
    size_t wrong = 0;
    for (const auto& [name, text] : texts) {
        const std::string file = folder.put(name + ".json", text);
        const Said said = run_wrinkle({"check", file});
        const Problems problems = library().load(file).check();
        EXPECT_EQ(to_text(problems), said.err) << name;
        EXPECT_EQ(has_errors(problems), said.code == 1) << name;
        EXPECT_EQ(to_text(library().load_text(text, folder.path(), name + ".json").check()),
                  said.err)
            << name;
        wrong += has_errors(problems);
    }
    EXPECT_EQ(wrong, texts.size() - 1);
    const std::string missing = folder.path() / "none.json";
    EXPECT_EQ(to_text(library().load(missing).check()), run_wrinkle({"check", missing}).err);
}

TEST(SameProblems, OfCompilingToo) {
    const TemporaryFolder folder;
    std::string nodes, sum = "m0.gradient";
    for (int i = 0; i < 20; ++i) {
        const std::string image = "i" + std::to_string(i) + ".png", n = std::to_string(i);
        folder.put(image, "");
        nodes += "\"m" + n + R"(": { "type": "tangent_normal_map", "in": { "image": ")" + image +
                 "\" } },\n";
        if (i == 0) continue;
        nodes += "\"s" + n + R"(": { "type": "gradient_add", "in": { "a": { "from": ")" + sum +
                 R"(" }, "b": { "from": "m)" + n + ".gradient\" } } },\n";
        sum = "s" + n + ".gradient";
    }
    const std::string file = folder.put(
        "many.json", "{ \"wrinkle\": 1, \"nodes\": {\n" + nodes +
                         R"("end": { "type": "resolve", "in": { "gradient": { "from": ")" + sum +
                         R"(" } } } },
  "outputs": { "normal": { "from": "end.normal" } } })");
    const Graph graph = library().load(file);
    CompileOptions options;
    const Shader shader = graph.compile(options);
    EXPECT_TRUE(shader.ok);
    ASSERT_EQ(shader.problems.size(), 1u);
    EXPECT_FALSE(shader.problems[0].is_error);
    EXPECT_EQ(to_text(shader.problems), run_wrinkle({"compile", file}).err);
    options.strict = true;
    const Shader refused = graph.compile(options);
    EXPECT_FALSE(refused.ok);
    EXPECT_EQ(refused.source, "");
    EXPECT_EQ(to_text(refused.problems), run_wrinkle({"compile", file, "--strict"}).err);
}

// Thirty nested levels of sub-graphs compile, but need more calls than can be evaluated.
TEST(SameProblems, OfTooManyCalls) {
    const TemporaryFolder folder;
    for (int level = 0; level <= 30; ++level)
        folder.put("level_" + std::to_string(level) + ".json", bench::nested_level(level));
    const std::string file = folder.put("top.json", bench::nested_top(30));
    const Graph graph = library().load(file);
    EXPECT_EQ(graph.compile({}).source, run_wrinkle({"compile", file}).out);
    const Evaluated refused = graph.evaluate({1, {}});
    EXPECT_FALSE(refused.ok);
    EXPECT_TRUE(says(refused.problems, "2147483647 calls")) << to_text(refused.problems);
    EXPECT_EQ(to_text(refused.problems), run_wrinkle({"eval", file, "--at", "{}"}).err);
}

// Surface points in the format of `eval --at`.
Points points_of(const json::Value& list) {
    Points points;
    points.count = list.size();
    const auto add = [&](const std::string& name, const json::Value& value) {
        for (const json::Member& number : value.children())
            points.values[name].push_back(number.value.as_number());
    };
    for (const json::Member& point : list.children())
        for (const json::Member& member : point.value.children())
            if (member.value.is(json::Kind::object))
                for (const json::Member& change : member.value.children())
                    add(std::string(member.key) + "." + std::string(change.key), change.value);
            else
                add(std::string(member.key), member.value);
    return points;
}

json::Value parsed(const std::string& text) {
    Diagnostics diagnostics;
    const json::Value root = json::parse(text, "text", diagnostics).root;
    EXPECT_FALSE(diagnostics.has_errors()) << text;
    return root;
}

// Floats are printed with the fewest digits that identify them, so they are compared as floats.
bool is_same(double number, double printed, bool full) {
    return full ? number == printed : static_cast<float>(number) == static_cast<float>(printed);
}

void expect_numbers(const Evaluated& evaluated, const json::Value& points, bool full,
                    const fs::path& graph) {
    for (size_t point = 0; point < points.size(); ++point)
        for (const Column& column : evaluated.outputs) {
            const json::Value value = points.at(point).find(column.name);
            for (size_t i = 0; i < column.components; ++i) {
                const double number = column.values[point * column.components + i];
                const json::Value wanted = column.components == 1 ? value : value.at(i);
                ASSERT_TRUE(wanted.is(json::Kind::number)) << graph;
                EXPECT_TRUE(is_same(number, wanted.as_number(), full))
                    << graph << " " << column.name << ": " << number << ", not "
                    << wanted.as_number();
            }
        }
}

TEST(SameNumbers, OfTheSamples) {
    const TemporaryFolder folder;
    const json::Value cases = parsed(bytes_of(graphs + "/plain_height.test.json"));
    const Points points = points_of(cases.find("points"));
    ASSERT_EQ(points.count, 4u);
    const std::string at = folder.put("at.json", json::one_line(cases.find("points")));
    size_t compared = 0;
    for (const char* name : {"plain_height", "base_and_detail", "woven_strap", "everything",
                             "triplanar_rock", "noise_rock", "operators", "hex_pebbles"}) {
        const std::string graph = graphs + "/" + name + ".json";
        const Graph loaded = library().load(graph);
        for (const int way : {0, 1, 2}) {
            const bool full = way == 1;
            std::vector<std::string> words = {"eval",   graph,         "--at",
                                              "@" + at, "--precision", full ? "double" : "float"};
            EvaluateOptions options;
            options.double_precision = full;
            options.vertex_tangents = way < 2;
            if (way == 2) words.emplace_back("--no-tangents");
            const Said said = run_wrinkle(words);
            const Evaluated evaluated = loaded.evaluate(points, options);
            EXPECT_EQ(evaluated.ok, said.code == 0) << graph << to_text(evaluated.problems);
            if (!evaluated.ok) continue;
            const json::Value list = parsed(said.out).find("points");
            ASSERT_EQ(list.size(), points.count);
            expect_numbers(evaluated, list, full, graph);
            compared += evaluated.outputs.size();
        }
    }
    EXPECT_GE(compared, 21u);
}

TEST(SameInputs, AsWrinkleInputsLists) {
    const std::string graph = graphs + "/everything.json";
    std::string lines;
    for (const InputFile& file : library().load(graph).inputs())
        lines += file.path + "\n";
    EXPECT_EQ(lines, run_wrinkle({"inputs", graph}).out);
    EXPECT_NE(lines.find(".png"), std::string::npos);
}

TEST(SameText, WithOtherValues) {
    const std::string graph = graphs + "/woven_strap.json";
    const Graph loaded = library().load(graph);
    const std::string before = loaded.compile({}).source;
    const Graph other = loaded.with({"softer.amount=0.125"});
    const Shader shader = other.compile({});
    const Said said = run_wrinkle({"compile", graph, "--set", "softer.amount=0.125"});
    ASSERT_EQ(said.code, 0) << said.err;
    EXPECT_EQ(shader.source, said.out) << to_text(shader.problems);
    EXPECT_NE(shader.source, before);
    EXPECT_EQ(loaded.compile({}).source, before);
}

// Both ways of a host: the preset by its name, and its values one by one.
TEST(SameText, WithAPresetOfTheGraph) {
    const std::string graph = graphs + "/painted_metal.json";
    const Graph loaded = library().load(graph);
    const std::vector<Preset> presets = loaded.presets();
    ASSERT_EQ(presets.size(), 2u);
    EXPECT_EQ(presets[0].name, "New");
    EXPECT_EQ(presets[1].name, "Old");
    ASSERT_EQ(presets[0].values.size(), 3u);
    EXPECT_EQ(presets[0].values[2].input, "paint");
    EXPECT_EQ(presets[0].values[2].json, "\"#a01818\"");
    for (const Preset& preset : presets) {
        const Shader shader = loaded.with_preset(preset.name).compile({});
        const Said said = run_wrinkle({"compile", graph, "--preset", preset.name});
        ASSERT_EQ(said.code, 0) << said.err;
        EXPECT_EQ(shader.source, said.out) << to_text(shader.problems);
        EXPECT_NE(shader.reflection, loaded.compile({}).reflection);
        std::vector<std::string> values;
        for (const Preset::Value& value : preset.values)
            values.push_back("input." + value.input + "=" + value.json);
        const Shader set = loaded.with(values).compile({});
        EXPECT_EQ(set.source, shader.source) << to_text(set.problems);
        EXPECT_EQ(set.reflection, shader.reflection);
    }
}

TEST(SameText, WithAPresetFile) {
    const TemporaryFolder folder;
    const std::string graph = folder.put("tilt.json", tilt_graph());
    const std::string file = folder.put("steep.preset.json", R"({ "wrinkle_preset": 1,
  "graph": "tilt.json", "inputs": { "slope": 3 } })");
    const Graph steep = library().load(graph).with_preset(file);
    EXPECT_EQ(steep.compile({}).reflection,
              library().load(graph).with({"input.slope=3"}).compile({}).reflection);
    const std::vector<InputFile> inputs = steep.inputs();
    const auto is_preset = [](const InputFile& input) {
        return input.kind == InputFile::Kind::preset && input.path.ends_with("steep.preset.json");
    };
    EXPECT_TRUE(std::any_of(inputs.begin(), inputs.end(), is_preset)) << "a preset is an input";
    const std::string other = folder.put("other.preset.json", R"({ "wrinkle_preset": 1,
  "graph": "else.json", "inputs": { "slop": 3 } })");
    EXPECT_EQ(to_text(library().load(graph).with_preset(other).check()),
              run_wrinkle({"check", graph, "--preset", other}).err);
}

// Values under the former name of an input are those of the input.
TEST(SameText, WithARenamedInput) {
    const TemporaryFolder folder;
    std::string text = tilt_graph();
    const std::string type = "\"type\": \"float\"", declared = "\"slope\": {";
    ASSERT_NE(text.find(declared), text.npos) << text;
    text.insert(text.find(type, text.find(declared)), "\"renamed\": [\"tilt\"], ");
    text.insert(text.rfind('}'), R"(, "presets": { "Steep": { "tilt": 3 } })");
    const std::string graph = folder.put("tilt.json", text);
    const std::string file = folder.put("steep.preset.json", R"({ "wrinkle_preset": 1,
  "graph": "tilt.json", "inputs": { "tilt": 3 } })");
    const Graph loaded = library().load(graph);
    const std::string steep = loaded.with({"input.slope=3"}).compile({}).reflection;
    EXPECT_NE(steep, loaded.compile({}).reflection);
    EXPECT_EQ(loaded.with({"input.tilt=3"}).compile({}).reflection, steep);
    EXPECT_EQ(loaded.with_preset("Steep").compile({}).reflection, steep);
    EXPECT_EQ(loaded.with_preset(file).compile({}).reflection, steep);
    EXPECT_NE(steep.find("\"renamed\": [\"tilt\"]"), steep.npos) << steep;
    const std::vector<Preset> presets = loaded.presets();
    ASSERT_EQ(presets.size(), 1u);
    EXPECT_EQ(presets[0].values[0].input, "slope");
    EXPECT_TRUE(says(loaded.with({"input.tild=3"}).check(), "no input 'tild'"));
}

TEST(SameText, WithANodeOfAPlugin) {
    const TemporaryFolder folder;
    const std::string graph = folder.put("r.json", R"({ "wrinkle": 1, "nodes": {
  "r": { "type": "ripples" },
  "end": { "type": "resolve", "in": { "gradient": { "from": "r.height" } } } },
  "outputs": { "normal": { "from": "end.normal" } } })");
    const Said said = run_wrinkle({"compile", graph, "--plugin-path", WRINKLE_RIPPLES});
    ASSERT_EQ(said.code, 0) << said.err;
    const Library with_plugin({{WRINKLE_RIPPLES}, false});
    EXPECT_TRUE(with_plugin.problems().empty()) << to_text(with_plugin.problems());
    const Graph loaded = with_plugin.load(graph);
    EXPECT_EQ(loaded.compile({}).source, said.out);
    const auto inputs = loaded.inputs();
    EXPECT_TRUE(std::any_of(inputs.begin(), inputs.end(), [](const InputFile& file) {
        return file.kind == InputFile::Kind::plugin && file.path == WRINKLE_RIPPLES;
    }));
    EXPECT_TRUE(says(library().load(graph).check(), "unknown node type 'ripples'"));
}

}  // namespace
}  // namespace wrinkle::test
