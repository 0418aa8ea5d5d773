// Tests that an Evaluator with changed inputs is the graph with these values, bit for bit.
#include <cmath>

#include "api/support.h"

namespace wrinkle::test {
namespace {

using namespace api;

std::vector<std::string> samples() {
    std::vector<std::string> files;
    for (const char* folder : {"graphs", "graphs/materials"})
        for (const auto& entry :
             fs::directory_iterator(WRINKLE_SOURCE_DIR "/" + std::string(folder))) {
            const std::string name = entry.path().filename().string();
            if (name.ends_with(".json") && name.find(".test.") == name.npos &&
                name.find(".preset.") == name.npos)
                files.push_back(entry.path().string());
        }
    return files;
}

// Points with all inputs, on a plane.
Points plane(size_t count) {
    Points points;
    points.count = count;
    const auto each = [&](const std::string& name, std::vector<double> value) {
        for (size_t i = 0; i < count; ++i)
            for (const double number : value)
                points.values[name].push_back(number + (name.ends_with("0") ? 0.37 * i : 0));
    };
    each("position", {0.3, -0.2, 0.1});
    each("normal", {0, 0, 1});
    each("tangent", {1, 0, 0, 1});
    for (const char* uv : {"uv0", "uv1", "uv2", "uv3"})
        each(uv, {0.4, 0.7});
    each("color0", {0.5, 0.2, 0.9, 1});
    each("view", {0, 0.6, 0.8});
    for (const char* d : {"dx.", "dy."}) {
        const double x = d[1] == 'x' ? 0.01 : 0, y = 0.01 - x;
        each(std::string(d) + "position", {x, y, 0});
        each(std::string(d) + "normal", {0, 0, 0});
        each(std::string(d) + "tangent", {0, 0, 0, 0});
        for (const char* uv : {"uv0", "uv1", "uv2", "uv3"})
            each(std::string(d) + uv, {x, y});
        each(std::string(d) + "color0", {0, 0, 0, 0});
        each(std::string(d) + "view", {0, 0, 0});
    }
    return points;
}

std::string override_of(const Evaluator::Input& input) {
    std::string text = "input." + input.name + "=";
    for (size_t i = 0; i < input.value.size(); ++i) {
        char number[40];
        std::snprintf(number, sizeof number, "%.17g", input.value[i]);
        text += (i ? "," : input.value.size() > 1 ? "[" : "") + std::string(number);
    }
    return text + (input.value.size() > 1 ? "]" : "");
}

void expect_same(const Evaluated& a, const Evaluated& b, const std::string& what) {
    ASSERT_EQ(a.ok, b.ok) << what << to_text(a.problems) << to_text(b.problems);
    ASSERT_EQ(a.outputs.size(), b.outputs.size());
    for (size_t i = 0; i < a.outputs.size(); ++i)
        for (size_t k = 0; k < a.outputs[i].values.size(); ++k) {
            const double left = a.outputs[i].values[k], right = b.outputs[i].values[k];
            ASSERT_TRUE(left == right || (std::isnan(left) && std::isnan(right)))
                << what << " " << a.outputs[i].name << " " << left << " " << right;
        }
}

TEST(Evaluator, ChangesEveryInputOfTheSamplesAsWithDoes) {
    size_t inputs = 0, changed_results = 0;
    const Points points = plane(3);
    for (const std::string& file : samples()) {
        const Graph graph = library().load(file, WRINKLE_SOURCE_DIR);
        Evaluator evaluator = graph.evaluator();
        if (has_errors(evaluator.problems())) continue;
        const Evaluated before = evaluator.evaluate(points);
        expect_same(before, graph.evaluate(points), file);
        for (const auto& [name, value] : evaluator.inputs()) {
            std::vector<double> other = value;
            for (double& number : other)
                number = number * 0.75 + 0.0625;
            const int index = evaluator.find(name);
            ASSERT_GE(index, 0);
            ASSERT_EQ(to_text(evaluator.set(index, other)), "") << file << " " << name;
            const Evaluator::Input now = evaluator.inputs()[static_cast<size_t>(index)];
            const Evaluated got = evaluator.evaluate(points);
            expect_same(got, graph.with({override_of(now)}).evaluate(points), file + " " + name);
            for (size_t i = 0; i < got.outputs.size(); ++i)
                changed_results += got.outputs[i].values != before.outputs[i].values;
            ASSERT_EQ(to_text(evaluator.set(index, value)), "");
            ++inputs;
        }
        expect_same(evaluator.evaluate(points), before, file);
    }
    EXPECT_GT(inputs, 100u);
    EXPECT_GT(changed_results, inputs / 2);
}

Graph two_inputs() {
    return library().load_text(R"({ "wrinkle": 1,
        "inputs": { "wear": { "type": "float", "default": 0.25, "limits": [0, 1], "renamed": ["age"] },
                    "tint": { "type": "color", "default": [1, 0, 0] },
                    "unread": { "type": "float", "default": 2 },
                    "lit": { "type": "flag", "default": true } },
        "outputs": { "roughness": { "from": "input.wear" }, "base_color": { "from": "input.tint" } } })");
}

TEST(Evaluator, FindsNumericInputsByNameAndFormerName) {
    const Evaluator evaluator = two_inputs().evaluator();
    EXPECT_EQ(to_text(evaluator.problems()), "");
    EXPECT_EQ(evaluator.inputs().size(), 3u);
    EXPECT_EQ(evaluator.find("wear"), 0);
    EXPECT_EQ(evaluator.find("age"), 0);
    EXPECT_EQ(evaluator.find("tint"), 1);
    EXPECT_EQ(evaluator.find("lit"), -1);
    EXPECT_EQ(evaluator.find("no"), -1);
}

TEST(Evaluator, ClampsToTheLimitsAndRefusesOthers) {
    Evaluator evaluator = two_inputs().evaluator();
    EXPECT_TRUE(evaluator.set(0, {7}).empty());
    EXPECT_EQ(evaluator.evaluate({1, {}}).outputs[0].values[0], 1);
    EXPECT_TRUE(says(evaluator.set(0, {1, 2}), "input 'wear' is given 2 numbers"));
    EXPECT_TRUE(says(evaluator.set(0, {std::nan("")}), "not finite"));
    EXPECT_TRUE(says(evaluator.set(3, {0}), "there is no input 3"));
    EXPECT_TRUE(says(evaluator.set(-1, {0}), "there is no input -1"));
    EXPECT_EQ(evaluator.inputs()[0].value[0], 1);
    EXPECT_TRUE(evaluator.set(2, {5}).empty());
}

TEST(Evaluator, CopiesAreIndependent) {
    Evaluator first = two_inputs().evaluator();
    Evaluator second = first;
    EXPECT_TRUE(second.set(0, {0.5}).empty());
    EXPECT_EQ(first.evaluate({1, {}}).outputs[0].values[0], 0.25);
    EXPECT_EQ(second.evaluate({1, {}}).outputs[0].values[0], 0.5);
    EXPECT_EQ(first.evaluate({1, {}}).outputs[0].values[0], 0.25);
}

TEST(Evaluator, HasTheProblemsOfItsGraph) {
    EXPECT_TRUE(says(Graph().evaluator().problems(), "there is no graph"));
    EXPECT_TRUE(says(Evaluator().problems(), "there is no evaluator"));
    Evaluator bad = library().load_text("{").evaluator();
    EXPECT_TRUE(has_errors(bad.problems()));
    EXPECT_FALSE(bad.evaluate({1, {}}).ok);
    EXPECT_TRUE(has_errors(bad.set(0, {1})));
}

TEST(Export, WritesTheFilesOfAHost) {
    const TemporaryFolder folder;
    const Graph graph = library().load(WRINKLE_SOURCE_DIR "/graphs/rings.json");
    const Exported exported = graph.export_to("three", (folder.path() / "rings").string());
    EXPECT_TRUE(exported.ok) << to_text(exported.problems);
    EXPECT_FALSE(exported.files.empty());
    for (const std::string& file : exported.files)
        EXPECT_TRUE(fs::exists(folder.path() / "rings" / file)) << file;
    EXPECT_TRUE(says(graph.export_to("tree", folder.path().string()).problems,
                     "there is no host 'tree' (did you mean 'three'?)"));
    ExportOptions options;
    options.size = 0;
    EXPECT_TRUE(says(graph.export_to("gltf", folder.path().string(), options).problems,
                     "the size is 0 (1 to 8192)"));
    options = {};
    options.mesh = "no.obj";
    EXPECT_FALSE(graph.export_to("gltf", folder.path().string(), options).ok);
}

}  // namespace
}  // namespace wrinkle::test
