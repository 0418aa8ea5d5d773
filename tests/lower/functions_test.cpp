// Tests of sub-graphs as functions: the number of functions built and of calls.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "emit/emit.h"
#include "ir/inspect.h"
#include "lower/fixture.h"
#include "lower/reachable.h"

namespace wrinkle {
namespace {

std::string level_file(int level) {
    return "g" + std::to_string(level) + ".json";
}

// `levels` files, each of which uses the next one `uses` times with different numbers; the last one
// has a node.
std::map<std::string, std::string> tower(int levels, int uses) {
    std::map<std::string, std::string> files;
    const std::string input = "\"inputs\": {\"x\": {\"type\": \"height\"}}, ";
    for (int level = 0; level < levels; ++level) {
        std::string nodes, sum = level == 0 ? R"({"from": "top.value"})" : R"({"from": "input.x"})";
        for (int use = 0; use < uses; ++use) {
            const std::string name = std::to_string(use);
            nodes += "\"n" + name + "\": {\"type\": \"number\", \"in\": {\"value\": 0." + name +
                     "}}, \"p" + name + "\": {\"type\": \"many\", \"in\": {\"height\": " + sum +
                     ", \"value\": {\"from\": \"n" + name + ".value\"}}}, \"u" + name +
                     "\": {\"type\": \"graph:" + level_file(level + 1) +
                     "\", \"in\": {\"x\": {\"from\": \"p" + name + ".height\"}}}, ";
            sum = "{\"from\": \"u" + name + ".y\"}";
        }
        nodes += R"("top": {"type": "number"})";
        files[level_file(level)] = test::graph(nodes, "\"y\": " + sum, level == 0 ? "" : input);
    }
    files[level_file(levels)] =
        test::graph(R"("p": {"type": "many", "in": {"height": {"from": "input.x"}}})",
                    R"("y": {"from": "p.height"})", input);
    return files;
}

struct Built {
    explicit Built(const std::map<std::string, std::string>& files)
        : written(files), project(load_project(written.folder / "g0.json", {}, diagnostics)) {}

    Compiled compile(const MaterialOptions& options = {}) {
        return compile_material(project, test::registry(), options, diagnostics);
    }

    const test::Files written;
    Diagnostics diagnostics;
    Project project;
};

TEST(ExpandedCalls, CountEveryUse) {
    EXPECT_EQ(expanded_calls(Built(tower(1, 2)).project), 2U);
    EXPECT_EQ(expanded_calls(Built(tower(2, 2)).project), 6U);
    EXPECT_EQ(expanded_calls(Built(tower(30, 2)).project), (uint64_t{1} << 31) - 2);
    EXPECT_EQ(expanded_calls(Built(tower(10, 3)).project), 88572U);
    EXPECT_EQ(expanded_calls(Built(tower(70, 2)).project), std::numeric_limits<uint64_t>::max());
}

TEST(ExpandedCalls, OfWhatIsReachedAlone) {
    auto files = tower(1, 2);
    files["g0.json"] =
        test::graph(R"("a": {"type": "graph:g1.json"}, "b": {"type": "graph:g1.json"},
                       "m": {"type": "graph:g1.json", "muted": true, "in": {"x": {"from": "a.y"}}})",
                    R"("y": {"from": "m.y"})");
    EXPECT_EQ(expanded_calls(Built(files).project), 1U);
}

TEST(ExpandedCalls, AreRefusedBeforeAnythingIsBuilt) {
    Built built(tower(30, 2));
    MaterialOptions options;
    EXPECT_TRUE(built.compile(options).ok);
    options.runs_calls = "eval";
    EXPECT_FALSE(built.compile(options).ok);
    EXPECT_EQ(to_text(built.diagnostics),
              (built.written.folder / "g0.json").string() +
                  ": error: eval would make 2147483646 calls of sub-graphs, and makes 100000 at "
                  "most ('wrinkle compile' makes a function of each sub-graph)\n");
}

TEST(ExpandedCalls, UpToAHundredThousandAreMade) {
    Built built(tower(10, 3));
    MaterialOptions options;
    options.runs_calls = "eval";
    EXPECT_TRUE(built.compile(options).ok) << to_text(built.diagnostics);
}

// The number of instructions per level does not depend on the depth.
TEST(LowerFunctions, GrowWithTheFilesAndNotWithTheUses) {
    const Module ten = Built(tower(10, 2)).compile().module;
    const Module twenty = Built(tower(20, 2)).compile().module;
    const Module thirty = Built(tower(30, 2)).compile().module;
    EXPECT_EQ(thirty.size() - twenty.size(), twenty.size() - ten.size());
    EXPECT_EQ(thirty.region_count(), 31U);
    EXPECT_EQ(verify(thirty), "");
    const size_t text10 = emit(ten, {}).source.size(), text30 = emit(thirty, {}).source.size();
    EXPECT_LT(text30, 4 * text10);
}

TEST(LowerFunctions, AreWrittenOutInASmallGraph) {
    EXPECT_EQ(Built(tower(2, 2)).compile().module.region_count(), 1U);
    MaterialOptions options;
    options.lower.inline_up_to = 0;
    EXPECT_EQ(Built(tower(2, 2)).compile(options).module.region_count(), 3U);
}

// A number in a function's body is one parameter, named after the first use.
TEST(LowerFunctions, HaveTheirParametersOnce) {
    MaterialOptions options;
    options.uniform_parameters = true;
    options.lower.inline_up_to = 0;
    const Module module = Built(tower(2, 2)).compile(options).module;
    std::vector<std::string> names;
    for (const Parameter& parameter : module.parameters)
        names.push_back(module.nodes[parameter.node].path + "." + parameter.port);
    EXPECT_EQ(std::count(names.begin(), names.end(), "u0/n1.value"), 1);
    EXPECT_EQ(std::count(names.begin(), names.end(), "u1/n1.value"), 0);
}

TEST(LowerFunctions, DeeperThanFunctionsMayCallAreRefusedByTheLimitOfNodes) {
    Built built(tower(70, 2));
    MaterialOptions options;
    options.lower.max_nodes = 10'000;
    EXPECT_FALSE(built.compile(options).ok);
    EXPECT_EQ(to_text(built.diagnostics),
              (built.written.folder / "g0.json").string() +
                  ": error: the graph needs more than 10000 nodes (each inlined use of a sub-graph "
                  "counts)\n");
}

}  // namespace
}  // namespace wrinkle
