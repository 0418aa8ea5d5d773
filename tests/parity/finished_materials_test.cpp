// Tests of the finished materials in graphs/materials with each of their presets: finite numbers,
// and equal text however a value is given.
#include <gtest/gtest.h>

#include <cmath>

#include "certify/points.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "image/load.h"
#include "json/write.h"
#include "lower/override.h"
#include "lower/preset.h"
#include "parity/compare.h"
#include "parity/node_graph.h"
#include "support/samples.h"

namespace wrinkle::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> finished_graphs() {
    std::vector<fs::path> graphs = sample_graphs();
    std::erase_if(
        graphs, [](const fs::path& path) { return path.parent_path().filename() != "materials"; });
    return graphs;
}

Project loaded(const fs::path& graph) {
    Diagnostics diagnostics;
    Project project = load_project(graph, {}, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    return project;
}

Project with(const Project& project, const std::string& preset) {
    Diagnostics diagnostics;
    Project result = with_preset(project, preset, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "") << preset;
    return result;
}

Project with(const Project& project, const std::vector<std::string>& texts) {
    Diagnostics diagnostics;
    std::vector<Override> overrides;
    for (const std::string& text : texts)
        if (auto parsed = parse_override(text, diagnostics)) overrides.push_back(*parsed);
    Project result = with_overrides(project, all_nodes(), overrides, 0, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    return result;
}

// The project after its document was written to a file and read.
Project reread(const fs::path& graph, const Document& document) {
    Diagnostics diagnostics;
    Project project =
        load_project(read_document(canonical_text(document), graph.string(), diagnostics),
                     graph.parent_path(), {}, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    return project;
}

Compiled compiled(const Project& project) {
    Diagnostics diagnostics;
    Compiled result =
        compile_material(project, all_nodes(), {.given_differentials = true}, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    return result;
}

// Source with numbers as literals, and the reflection, which has the values of inputs.
std::string baked_text(const Project& project) {
    const Shader shader = certify::given_text(compiled(project).module);
    return shader.source + to_json(shader.reflection);
}

Document with_defaults(Document document, const Preset& preset) {
    for (const auto& [name, value] : preset.values) {
        GraphInput input = *document.inputs.find(name);
        input.default_value = value;
        document = set_graph_input(document, std::move(input));
    }
    return document;
}

TEST(FinishedMaterials, AreTwentyWithPresets) {
    const auto graphs = finished_graphs();
    EXPECT_EQ(graphs.size(), 20U);
    for (const fs::path& graph : graphs)
        EXPECT_GE(loaded(graph).top().presets.size(), 2U) << graph;
}

TEST(FinishedMaterials, AreFiniteWithEveryPreset) {
    const PointSet points = certify::random_points(4096, 41, {0, 1});
    const auto images = [](const std::string&) -> const MipChain& { return test_image("a.exr"); };
    for (const fs::path& graph : finished_graphs()) {
        const Project project = loaded(graph);
        std::vector<Project> all{project};
        for (const Preset& preset : project.top().presets)
            all.push_back(with(project, preset.name));
        for (const Project& each : all)
            for (const auto& output : on_cpu<float>(compiled(each).module, points, images))
                EXPECT_TRUE(std::all_of(output.begin(), output.end(), [](double number) {
                    return std::isfinite(number);
                })) << graph;
    }
}

TEST(FinishedMaterials, HaveOneTextOfAPresetHoweverItIsGiven) {
    for (const fs::path& graph : finished_graphs()) {
        SCOPED_TRACE(graph);
        const Project project = loaded(graph);
        const std::string unset = baked_text(project);
        for (const Preset& preset : project.top().presets) {
            const Project once = with(project, preset.name);
            const std::string text = baked_text(once);
            EXPECT_NE(text, unset) << preset.name;
            EXPECT_EQ(baked_text(with(once, preset.name)), text) << preset.name;
            std::vector<std::string> sets;
            for (const auto& [name, value] : preset.values)
                sets.push_back("input." + name + "=" + json::one_line(value));
            EXPECT_EQ(baked_text(with(project, sets)), text) << preset.name;
            EXPECT_EQ(baked_text(reread(graph, with_defaults(project.top(), preset))), text)
                << preset.name;
        }
    }
}

// The first number of each node, if it is one.
TEST(FinishedMaterials, HaveOneTextOfANumberHoweverItIsGiven) {
    for (const fs::path& graph : finished_graphs()) {
        SCOPED_TRACE(graph);
        const Project project = loaded(graph);
        std::vector<std::string> sets;
        Document document = project.top();
        for (const NodePtr& node : project.top().nodes)
            for (const Input& input : node->inputs) {
                if (input.kind != Input::Kind::literal || !input.value.is(json::Kind::number))
                    continue;
                const NodeType* type = all_nodes().find(node->type);
                const uint32_t port = type ? type->find_input(input.port) : NodeType::none;
                if (port == NodeType::none || type->ports[port].is_option()) continue;
                const json::Value value =
                    json::Value::number(0.75 * input.value.as_number() + 1e-3);
                sets.push_back(node->id + "." + input.port + "=" + json::one_line(value));
                document = set_value(document, node->id, input.port, value);
                break;
            }
        ASSERT_GT(sets.size(), 2U);
        const std::string text = baked_text(with(project, sets));
        EXPECT_EQ(baked_text(reread(graph, document)), text);
        EXPECT_NE(baked_text(project), text);
    }
}

}  // namespace
}  // namespace wrinkle::test
