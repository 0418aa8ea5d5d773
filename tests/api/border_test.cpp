// Tests that invalid arguments to the library produce a diagnostic and nothing else.
#include <sys/resource.h>
#include <sys/wait.h>

#include <cmath>
#include <limits>
#include <type_traits>

#include "api/support.h"

namespace wrinkle::test {
namespace {

using namespace api;

Graph tilt() {
    return library().load_text(tilt_graph());
}

Points up(size_t count = 1) {
    Points points;
    points.count = count;
    for (size_t i = 0; i < count; ++i)
        for (const double value : {0.0, 0.0, 1.0})
            points.values["normal"].push_back(value);
    return points;
}

// Expects exactly one problem: a caller error with this message.
void expect_one(const Problems& problems, const std::string& words) {
    ASSERT_EQ(problems.size(), 1u) << to_text(problems);
    EXPECT_TRUE(problems[0].is_error);
    EXPECT_EQ(problems[0].file, "");
    EXPECT_TRUE(says(problems, words)) << to_text(problems);
}

void expect_refused(const CompileOptions& options, const std::string& words) {
    const Shader shader = tilt().compile(options);
    EXPECT_FALSE(shader.ok);
    EXPECT_EQ(shader.source + shader.vertex + shader.fragment + shader.reflection, "");
    expect_one(shader.problems, words);
}

TEST(Border, HasNoExceptions) {
    const Graph graph;
    const CompileOptions options;
    static_assert(noexcept(Library())&& noexcept(to_text(Problems()))&& noexcept(targets()));
    static_assert(noexcept(graph.check())&& noexcept(graph.inputs()));
    static_assert(noexcept(graph.compile(options))&& noexcept(graph.evaluate(Points())));
    static_assert(noexcept(graph.with(std::vector<std::string>())));
    static_assert(noexcept(graph.presets())&& noexcept(graph.with_preset(std::string())));
    static_assert(std::is_nothrow_move_constructible_v<Graph> &&
                  std::is_nothrow_copy_assignable_v<Library>);
    EXPECT_STREQ(version(), WRINKLE_VERSION);
}

TEST(Border, OptionsThatAreNone) {
    CompileOptions options;
    options.target = "glsl33";
    expect_refused(options, "there is no target 'glsl33' (did you mean 'glsl330'?)");
    options.target = "nothing like it";
    expect_refused(options, "glsl330, glsl450, essl300, spirv, hlsl, msl, wgsl, godot3, godot4");
    options = {};
    options.target = "spirv";
    options.form = CompileOptions::Form::function;
    expect_refused(options, "the target 'spirv' is only written as a complete pair");
    options = {};
    options.form = CompileOptions::Form::shader;
    options.differentials = CompileOptions::Differentials::given;
    expect_refused(options, "the shader form takes its differentials from the screen");
    options = {};
    options.descriptor_set = 32;
    expect_refused(options, "descriptor_set is 32 (0 to 31)");
    options = {};
    options.first_binding = -1;
    expect_refused(options, "first_binding is -1 (0 to 4095)");
}

TEST(Border, EveryTargetThatIsNamedIsOne) {
    for (const std::string& target : targets()) {
        CompileOptions options;
        options.target = target;
        EXPECT_TRUE(tilt().compile(options).ok) << target;
    }
    EXPECT_GE(targets().size(), 6u);
}

void expect_no_points(const Points& points, const std::string& words, bool full = false) {
    EvaluateOptions options;
    options.double_precision = full;
    const Evaluated evaluated = tilt().evaluate(points, options);
    EXPECT_FALSE(evaluated.ok);
    EXPECT_TRUE(evaluated.outputs.empty());
    expect_one(evaluated.problems, words);
}

TEST(Border, PointsThatAreNone) {
    expect_no_points({1, {}}, "the points lack 'normal' (the graph needs it)");
    expect_no_points({2, {{"normal", {0, 0, 1, 0}}}},
                     "'normal' holds 4 numbers (3 for each of 2 points)");
    expect_no_points({1, {{"normal", {0, 0, 1}}, {"uv", {0, 0}}}}, "there is no 'uv'");
    expect_no_points({1, {{"normal", {0, 0, 1}}, {"dx.dy.uv0", {0, 0}}}}, "no 'dx.dy.uv0'");
    expect_no_points({2, {{"normal", {0, 0, 1, 0, 0, 0}}}}, "point 1: normal is zero");
    expect_no_points({1, {{"normal", {0, std::nan(""), 1}}}}, "point 0: 'normal' is not finite");
    expect_no_points({1, {{"normal", {0, 0, 1}}, {"uv1", {0, HUGE_VAL}}}}, "'uv1' is not finite");
    expect_no_points({1, {{"normal", {0, 0, 1e300}}}},
                     "point 0: 'normal' holds 1e+300, which single precision does not");
    expect_no_points({std::numeric_limits<size_t>::max() / 3 + 2, {{"normal", {0, 0, 1}}}},
                     "'normal' holds 3 numbers");
}

// Sizes above std::vector's maximum, and above the machine's memory. The second one is omitted
// under ASan, whose operator new aborts instead of throwing.
#ifdef __SANITIZE_ADDRESS__
constexpr size_t too_many[] = {std::numeric_limits<size_t>::max()};
#else
constexpr size_t too_many[] = {std::numeric_limits<size_t>::max(), size_t{1} << 59};
#endif

TEST(Border, MorePointsThanThereIsMemory) {
    const Graph graph = library().load_text(R"({ "wrinkle": 1, "nodes": {
  "a": { "type": "add", "in": { "a": 1 } } }, "outputs": { "x": { "from": "a.result" } } })");
    EXPECT_TRUE(graph.evaluate({3, {}}).ok);
    for (const size_t count : too_many) {
        const Evaluated evaluated = graph.evaluate({count, {}});
        EXPECT_FALSE(evaluated.ok);
        expect_one(evaluated.problems, "out of memory");
    }
}

TEST(Border, NumbersAreThoseOfTheSurface) {
    const Evaluated evaluated = tilt().evaluate(up(2));
    ASSERT_TRUE(evaluated.ok) << to_text(evaluated.problems);
    ASSERT_EQ(evaluated.outputs.size(), 1u);
    const Column& normal = evaluated.outputs[0];
    EXPECT_EQ(normal.name, "normal");
    EXPECT_EQ(normal.components, 3u);
    ASSERT_EQ(normal.values.size(), 6u);
    for (const size_t point : {0u, 1u}) {
        EXPECT_NEAR(normal.values[point * 3], -0.6, 1e-6);
        EXPECT_NEAR(normal.values[point * 3 + 1], 0, 1e-6);
        EXPECT_NEAR(normal.values[point * 3 + 2], 0.8, 1e-6);
    }
    EXPECT_TRUE(tilt().evaluate({0, {{"normal", {}}}}).ok);
}

TEST(Border, ValuesThatDoNotFit) {
    EXPECT_FALSE(has_errors(tilt().with({"input.slope=1"}).check()));
    EXPECT_TRUE(says(tilt().with({"input.slop=1"}).check(), "slop"));
    EXPECT_TRUE(says(tilt().with({"input.slope=0:1:3"}).check(), "is a sweep (one value)"));
    EXPECT_TRUE(says(tilt().with({"="}).check(), "="));
    EXPECT_FALSE(tilt().with({"nothing"}).compile({}).ok);
}

TEST(Border, PresetsThatAreNone) {
    EXPECT_TRUE(tilt().presets().empty());
    for (const char* name : {"Steep", "", "gone.preset.json", "/dev/null/x.json"}) {
        const Graph none = tilt().with_preset(name);
        EXPECT_TRUE(has_errors(none.check())) << name;
        EXPECT_FALSE(none.compile({}).ok) << name;
        EXPECT_FALSE(none.evaluate(up()).ok) << name;
    }
    EXPECT_TRUE(says(tilt().with_preset("Steep").check(), "the graph has no preset 'Steep'"));
}

void expect_nothing(const Graph& graph) {
    expect_one(graph.check(), "there is no graph");
    expect_one(graph.compile({}).problems, "there is no graph");
    expect_one(graph.evaluate(up()).problems, "there is no graph");
    EXPECT_TRUE(graph.inputs().empty());
    expect_one(graph.with({"input.slope=1"}).check(), "there is no graph");
    EXPECT_TRUE(graph.presets().empty());
    expect_one(graph.with_preset("Steep").check(), "there is no graph");
}

TEST(Border, WhatWasMovedFromHoldsNothing) {
    expect_nothing(Graph());
    Graph graph = tilt();
    const Graph other = std::move(graph);
    expect_nothing(graph);
    EXPECT_TRUE(other.compile({}).ok);
    graph = other;
    EXPECT_TRUE(graph.compile({}).ok);
    Graph& same = graph;
    graph = same;
    graph = std::move(same);
    EXPECT_TRUE(graph.compile({}).ok);

    Library first({{}, false});
    Library second = std::move(first);
    expect_nothing(first.load_text(tilt_graph()));
    expect_one(first.problems(), "there is no library");
    EXPECT_TRUE(second.load_text(tilt_graph()).compile({}).ok);
    first = second;
    EXPECT_TRUE(first.problems().empty());
}

TEST(Border, AGraphKeepsItsLibrary) {
    const Graph graph = Library({{}, false}).load_text(tilt_graph());
    EXPECT_TRUE(graph.compile({}).ok);
}

TEST(Border, FilesThatAreNone) {
    const TemporaryFolder folder;
    for (const std::string& file :
         {folder.path().string(), std::string(), std::string("/dev/null/x"), std::string(5000, 'x'),
          std::string("a\0b", 3), (folder.path() / "\xff\xfe.json").string()}) {
        const Graph graph = library().load(file);
        EXPECT_TRUE(has_errors(graph.check())) << file;
        EXPECT_FALSE(graph.compile({}).ok);
        EXPECT_FALSE(graph.evaluate(up()).ok);
        graph.inputs();
    }
    for (const std::string& text : {std::string("\0", 1), std::string(100000, '['),
                                    std::string("\xff"), std::string("[]"), std::string("1e999")})
        EXPECT_TRUE(has_errors(library().load_text(text, "/nowhere", "..", "/none").check()));
}

TEST(Border, PluginsThatAreNone) {
    const Library made({{"/nowhere/nodes.so"}, false});
    EXPECT_TRUE(says(made.problems(), "/nowhere/nodes.so: error: "));
    EXPECT_TRUE(made.load_text(tilt_graph()).compile({}).ok);
}

TEST(Border, AGraphThatGrowsBeyondALimitIsAProblemAtItsNode) {
    std::string nodes = R"("wave": {"type": "waves"})", from = "wave.height";
    for (int i = 0; i < 20; ++i) {
        const std::string id = "n" + std::to_string(i);
        nodes += ", \"" + id +
                 "\": {\"type\": \"gradient_tilt\", \"in\": {\"gradient\": " + "{\"from\": \"" +
                 from + "\"}}}";
        from = id + ".tilt";
    }
    const Graph graph =
        library().load_text("{ \"wrinkle\": 1, \"nodes\": {" + nodes +
                            "}, \"outputs\": {\"tilt\": {\"from\": \"" + from + "\"}} }");
    for (const Problems& problems :
         {graph.compile({}).problems, graph.check(), graph.evaluate(up()).problems}) {
        ASSERT_EQ(problems.size(), 1u);
        EXPECT_TRUE(problems[0].is_error);
        EXPECT_TRUE(problems[0].node.starts_with("n1")) << problems[0].node;
        EXPECT_EQ(problems[0].message, "the graph becomes more than 1000000 values");
    }
}

TEST(Border, ManyProblemsAreCounted) {
    std::string nodes;
    for (int i = 0; i < 1200; ++i)
        nodes += (i ? ",\n\"n" : "\"n") + std::to_string(i) + R"(": { "type": "none_such" })";
    const Problems problems =
        library()
            .load_text("{ \"wrinkle\": 1, \"nodes\": {" + nodes + "}, \"outputs\": {} }")
            .check();
    ASSERT_EQ(problems.size(), 1001u);
    EXPECT_TRUE(problems.back().is_error);
    EXPECT_EQ(problems.back().message, "and 200 more problems");
}

// Runs in a child process limited to 160 MiB of address space. Not used under sanitizers, which
// need more.
int checks_in_little_memory() {
    const rlimit little{rlim_t{160} << 20, rlim_t{160} << 20};
    std::string text = tilt_graph();
    const Graph small = library().load_text(text);
    std::string nodes;
    for (int i = 0; i < 200000; ++i)
        nodes += "\"n" + std::to_string(i) + R"(": { "type": "add", "in": { "a": 1 } },)";
    text.insert(text.find("\"along\""), nodes);
    if (setrlimit(RLIMIT_AS, &little) != 0) return 2;
    const Graph large = library().load_text(text);
    const Problems problems = large.check();
    if (!says(problems, "out of memory")) return 3;
    return small.compile({}).ok ? 0 : 4;
}

TEST(Border, OutOfMemoryIsAProblem) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the address space of a sanitizer is no measure";
#endif
    const pid_t child = fork();
    if (child == 0) _exit(checks_in_little_memory());
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status)) << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace wrinkle::test
