// Every registered node and every sample graph: the CPU evaluator against generated GLSL on the
// same points.
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "image/load.h"
#include "parity/compare.h"
#include "parity/context.h"
#include "parity/node_graph.h"
#include "parity/points.h"
#include "parity/samples.h"

namespace wrinkle::test {
namespace {

constexpr size_t point_count = 300;
constexpr Inputs all_inputs[] = {Inputs::defaults, Inputs::numbers, Inputs::wires, Inputs::mixed};

using Parity = WithGpu;

const PointSet& the_points() {
    static const PointSet points = random_points(point_count, 7);
    return points;
}

void add(Comparison& sum, const Comparison& more) {
    sum.values += more.values;
    sum.unstable += more.unstable;
    sum.different += more.different;
}

// Float against GLSL, and float against double.
Comparison compare_all(const Module& module, const PointSet& points, const ImageOf& images) {
    const Judge judge = make_judge(module, points, images);
    const Values cpu = on_cpu<float>(module, points, images);
    const Values gpu = on_gpu(module, points, images);
    if (gpu.size() != cpu.size()) return {0, 0, 1, "no result from the GPU"};
    const Comparison in_double = judge.compare(cpu, judge.precise);
    EXPECT_EQ(in_double.different, 0U) << "float and double: " << in_double.first;
    const Comparison result = judge.compare(cpu, gpu);
    EXPECT_EQ(result.different, 0U) << "CPU and GPU: " << result.first;
    return result;
}

TEST_F(Parity, OfEveryNode) {
    Comparison all;
    for (const NodeType& type : all_nodes().list()) {
        unsigned seed = 1;
        for (const Inputs inputs : all_inputs) {
            const Subject subject = compile_around(type, inputs, seed++);
            ASSERT_TRUE(subject.compiled.ok);
            SCOPED_TRACE(subject.text);
            add(all, compare_all(subject.compiled.module, the_points(), test_image));
        }
    }
    EXPECT_GE(all.values, all_nodes().list().size() * point_count * std::size(all_inputs));
    EXPECT_LE(static_cast<double>(all.unstable), 0.001 * static_cast<double>(all.values));
}

TEST_F(Parity, IsFiniteOnDegenerateInput) {
    const PointSet points = degenerate_points();
    for (const NodeType& type : all_nodes().list()) {
        for (const Inputs inputs : {Inputs::defaults, Inputs::zeros, Inputs::wires}) {
            const Subject subject = compile_around(type, inputs, 17);
            ASSERT_TRUE(subject.compiled.ok);
            const Module& module = subject.compiled.module;
            const std::pair<const char*, Values> sides[] = {
                {"float", on_cpu<float>(module, points, test_image)},
                {"double", on_cpu<double>(module, points, test_image)},
                {"GPU", on_gpu(module, points, test_image)}};
            for (const auto& [side, values] : sides)
                for (size_t output = 0; output < values.size(); ++output)
                    for (size_t k = 0; k < values[output].size(); ++k)
                        EXPECT_TRUE(std::isfinite(values[output][k]))
                            << side << ", " << module.outputs[output].name << ", number " << k
                            << "\n"
                            << subject.text;
        }
    }
}

// Textures as the files say, each read once.
ImageOf images_of_files() {
    auto loaded = std::make_shared<std::map<std::string, MipChain>>();
    return [loaded](const std::string& file) -> const MipChain& {
        const auto found = loaded->find(file);
        if (found != loaded->end()) return found->second;
        Diagnostics diagnostics;
        auto image = load_image(file, diagnostics);
        EXPECT_TRUE(image) << to_text(diagnostics);
        return (*loaded)[file] = image ? build_mips(std::move(*image)) : test_image(file);
    };
}

TEST_F(Parity, OfEverySampleGraph) {
    Comparison all;
    size_t graphs = 0;
    const ImageOf images = images_of_files();
    // The uvs of a mesh: further out, a float's own steps move a steep height map by more.
    const PointSet points = random_points(3000, 7, {0, 1});
    for (const std::filesystem::path& path : sample_graphs()) {
        SCOPED_TRACE(path.string());
        Diagnostics diagnostics;
        const Project project = load_project(path, {}, diagnostics);
        MaterialOptions options;
        options.uniform_parameters = true;
        options.given_differentials = true;
        const Compiled compiled = compile_material(project, all_nodes(), options, diagnostics);
        EXPECT_TRUE(compiled.ok) << to_text(diagnostics);
        if (compiled.ok) add(all, compare_all(compiled.module, points, images));
        ++graphs;
    }
    EXPECT_GE(graphs, 6U);
    EXPECT_LE(static_cast<double>(all.unstable), 0.001 * static_cast<double>(all.values));
}

// The comparison can fail: a factor, a texel, a texture that are off, a NaN.
class SeededError : public WithGpu {
protected:
    SeededError()
        : subject(compile_around(*all_nodes().find("tangent_normal_map"), Inputs::numbers, 3)),
          module(subject.compiled.module),
          judge(make_judge(module, the_points(), test_image)),
          gpu(on_gpu(module, the_points(), test_image)) {}

    Subject subject;
    Module& module;
    Judge judge;
    Values gpu;
};

TEST_F(SeededError, IsNotThereUnlessSeeded) {
    EXPECT_EQ(judge.compare(judge.precise, gpu).different, 0U);
}

TEST_F(SeededError, OfAFactorIsFound) {
    ASSERT_FALSE(module.parameters.empty());
    Module wrong = module;
    for (Parameter& parameter : wrong.parameters)
        if (parameter.port == "strength") parameter.value[0] *= 1.25;
    const Values cpu = on_cpu<float>(wrong, the_points(), test_image);
    EXPECT_GT(judge.compare(cpu, gpu).different, point_count / 4);
}

TEST_F(SeededError, InTheGeneratedTextIsFound) {
    EmitOptions options;
    options.differentials = Differentials::given;
    Shader shader = emit(module, options);
    const size_t place = shader.source.find("textureLod(");
    ASSERT_NE(place, std::string::npos);
    shader.source.insert(place, "1.01 * ");
    EXPECT_GT(judge.compare(judge.precise, on_gpu(shader, the_points(), test_image)).different,
              point_count / 4);
}

TEST_F(SeededError, OfATextureIsFound) {
    const auto other = [](const std::string& file) -> const MipChain& {
        return test_image(file.ends_with("a.exr") ? "b.exr" : "a.exr");
    };
    const Values cpu = on_cpu<float>(module, the_points(), other);
    EXPECT_GT(judge.compare(cpu, gpu).different, point_count / 2);
}

TEST_F(SeededError, AsNoNumberIsFound) {
    const Comparison before = judge.compare(judge.precise, gpu);
    gpu[0][4] = NAN;
    const Comparison result = judge.compare(judge.precise, gpu);
    EXPECT_EQ(result.different + result.unstable, before.different + before.unstable + 1);
    EXPECT_NE(result.first.find("at point 1"), std::string::npos) << result.first;
}

}  // namespace
}  // namespace wrinkle::test
