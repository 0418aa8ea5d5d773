// Tests of the C interface: null objects, problems, lifetimes.
#include <wrinkle/wrinkle.h>

#include <memory>

#include "api/support.h"

namespace wrinkle::test {
namespace {

template <auto Free>
struct Freed {
    template <class T>
    void operator()(T* object) const {
        Free(object);
    }
};
template <class T, auto Free>
using Owned = std::unique_ptr<T, Freed<Free>>;
using OwnedGraph = Owned<wrinkle_graph, wrinkle_graph_free>;
using OwnedProblems = Owned<wrinkle_problems, wrinkle_problems_free>;
using OwnedShader = Owned<wrinkle_shader, wrinkle_shader_free>;
using OwnedEvaluator = Owned<wrinkle_evaluator, wrinkle_evaluator_free>;
using OwnedResults = Owned<wrinkle_results, wrinkle_results_free>;
using OwnedFiles = Owned<wrinkle_files, wrinkle_files_free>;

OwnedGraph tilted() {
    const Owned<wrinkle_library, wrinkle_library_free> made(wrinkle_library_new(nullptr, 0, false));
    EXPECT_EQ(wrinkle_problems_count(wrinkle_library_problems(made.get())), 0u);
    return OwnedGraph(wrinkle_graph_load_text(made.get(), tilt_graph().c_str(), nullptr, nullptr,
                                              nullptr));  // alive as long as the graph
}

TEST(CInterface, TakesNullObjects) {
    const OwnedGraph graph(wrinkle_graph_load(nullptr, nullptr, nullptr));
    const OwnedProblems problems(wrinkle_graph_check(graph.get()));
    ASSERT_EQ(wrinkle_problems_count(problems.get()), 1u);
    EXPECT_TRUE(wrinkle_problems_have_errors(problems.get()));
    EXPECT_NE(std::string(wrinkle_problems_at(problems.get(), 0)->message).find("no graph"),
              std::string::npos);
    EXPECT_EQ(wrinkle_problems_at(problems.get(), 1), nullptr);
    const OwnedShader shader(wrinkle_graph_compile(nullptr, nullptr, 0));
    EXPECT_TRUE(wrinkle_problems_have_errors(wrinkle_shader_problems(shader.get())));
    const OwnedEvaluator evaluator(wrinkle_evaluator_new(nullptr));
    EXPECT_TRUE(wrinkle_problems_have_errors(wrinkle_evaluator_problems(evaluator.get())));
    const OwnedResults results(wrinkle_evaluator_evaluate(nullptr, nullptr, false));
    EXPECT_TRUE(wrinkle_problems_have_errors(wrinkle_results_problems(results.get())));
    EXPECT_EQ(wrinkle_results_count(nullptr), 0u);
    EXPECT_EQ(wrinkle_results_values(results.get(), 0), nullptr);
    EXPECT_FALSE(wrinkle_evaluator_set(nullptr, 0, nullptr, 0));
    EXPECT_EQ(wrinkle_evaluator_find(nullptr, "x"), -1);
    EXPECT_FALSE(wrinkle_points_set(nullptr, "uv0", nullptr, 0));
    size_t size = 7;
    EXPECT_EQ(wrinkle_shader_source(nullptr, &size), nullptr);
    EXPECT_EQ(size, 0u);
}

TEST(CInterface, CompilesAsTheCppInterfaceDoes) {
    const OwnedGraph graph = tilted();
    const char* options[] = {"target=glsl450", "params=uniform", "normal-space=world"};
    const OwnedShader shader(wrinkle_graph_compile(graph.get(), options, 3));
    api::CompileOptions same;
    same.target = "glsl450";
    same.parameters = api::CompileOptions::Parameters::uniform;
    same.normal_space = api::CompileOptions::NormalSpace::world;
    size_t size = 0;
    const char* source = wrinkle_shader_source(shader.get(), &size);
    const api::Shader expected = library().load_text(tilt_graph()).compile(same);
    EXPECT_EQ(std::string(source, size), expected.source);
    EXPECT_EQ(wrinkle_shader_reflection(shader.get(), nullptr), expected.reflection);
    EXPECT_EQ(wrinkle_problems_text(wrinkle_shader_problems(shader.get())),
              to_text(expected.problems));
}

void expect_option_refused(const char* option, const std::string& words) {
    const OwnedGraph graph = tilted();
    const OwnedShader shader(wrinkle_graph_compile(graph.get(), &option, 1));
    const std::string text = wrinkle_problems_text(wrinkle_shader_problems(shader.get()));
    EXPECT_NE(text.find(words), std::string::npos) << text;
    EXPECT_STREQ(wrinkle_shader_source(shader.get(), nullptr), "");
}

TEST(CInterface, RefusesOptionsThatItDoesNotHave) {
    expect_option_refused("targt=glsl450", "there is no option 'targt' (did you mean 'target'?)");
    expect_option_refused("strict", "option 'strict' has no value (strict=VALUE)");
    expect_option_refused("strict=maybe", "strict has no value 'maybe' (false or true)");
    expect_option_refused("first-binding=1.5", "first-binding=1.5 (a whole number)");
    expect_option_refused("first-binding=5000", "first_binding is 5000 (0 to 4095)");
    expect_option_refused("normal-space=up", "object or world or view or tangent");
    expect_option_refused("", "there is no option ''");
}

TEST(CInterface, EvaluatesWithChangedInputs) {
    const OwnedGraph graph(wrinkle_graph_load_text(
        Owned<wrinkle_library, wrinkle_library_free>(wrinkle_library_new(nullptr, 0, false)).get(),
        R"({ "wrinkle": 1, "inputs": { "wear": { "type": "float", "default": 0.25, "limits": [0, 1] } },
             "presets": { "Old": { "wear": 0.75 } },
             "outputs": { "roughness": { "from": "input.wear" } } })",
        nullptr, nullptr, nullptr));
    ASSERT_EQ(wrinkle_graph_preset_count(graph.get()), 1u);
    EXPECT_STREQ(wrinkle_graph_preset(graph.get(), 0), "Old");
    EXPECT_EQ(wrinkle_graph_preset(graph.get(), 1), nullptr);
    const OwnedEvaluator evaluator(wrinkle_evaluator_new(graph.get()));
    ASSERT_EQ(wrinkle_evaluator_input_count(evaluator.get()), 1u);
    EXPECT_STREQ(wrinkle_evaluator_input_name(evaluator.get(), 0), "wear");
    const double* value = wrinkle_evaluator_input_value(evaluator.get(), 0);
    EXPECT_EQ(*value, 0.25);
    const double large = 4, several[] = {1, 2};
    EXPECT_TRUE(wrinkle_evaluator_set(evaluator.get(), 0, &large, 1));
    EXPECT_EQ(*value, 1);
    EXPECT_FALSE(wrinkle_evaluator_set(evaluator.get(), 0, several, 2));
    EXPECT_FALSE(wrinkle_evaluator_set(evaluator.get(), 1, &large, 1));
    const OwnedEvaluator copy(wrinkle_evaluator_copy(evaluator.get()));
    const Owned<wrinkle_points, wrinkle_points_free> points(wrinkle_points_new(1));
    const OwnedResults results(wrinkle_evaluator_evaluate(copy.get(), points.get(), false));
    ASSERT_EQ(wrinkle_results_count(results.get()), 1u);
    EXPECT_STREQ(wrinkle_results_name(results.get(), 0), "roughness");
    EXPECT_EQ(wrinkle_results_components(results.get(), 0), 1u);
    EXPECT_EQ(wrinkle_results_values(results.get(), 0)[0], 1);
}

TEST(CInterface, NamesInputFilesAndExports) {
    const TemporaryFolder folder;
    const OwnedGraph graph = tilted();
    const OwnedFiles inputs(wrinkle_graph_inputs(graph.get()));
    const OwnedFiles files(
        wrinkle_graph_export(graph.get(), "three", folder.path().c_str(), nullptr, 0, "tilt"));
    ASSERT_GT(wrinkle_files_count(files.get()), 0u)
        << wrinkle_problems_text(wrinkle_files_problems(files.get()));
    EXPECT_TRUE(fs::exists(folder.path() / wrinkle_files_at(files.get(), 0)));
    EXPECT_EQ(wrinkle_files_at(files.get(), 1000), nullptr);
    const OwnedFiles none(wrinkle_graph_export(graph.get(), nullptr, nullptr, nullptr, 0, nullptr));
    EXPECT_EQ(wrinkle_files_count(none.get()), 0u);
    EXPECT_TRUE(wrinkle_problems_have_errors(wrinkle_files_problems(none.get())));
}

}  // namespace
}  // namespace wrinkle::test
