// Tests of every registered node and every sample graph: the CPU evaluator against generated GLSL
// at the same points.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "certify/checks.h"
#include "certify/points.h"
#include "image/load.h"
#include "parity/compare.h"
#include "parity/context.h"
#include "parity/node_graph.h"
#include "support/samples.h"

namespace wrinkle::test {
namespace {

constexpr size_t point_count = 300;

using Parity = WithGpu;

const PointSet& the_points() {
    static const PointSet points = certify::random_points(point_count, 7);
    return points;
}

// Sums of comparisons by the name of the node or graph.
class Tally {
public:
    void add(const std::string& name, const Comparison& more) {
        for (Comparison* sum : {&all_, &by_name_[name]}) {
            sum->values += more.values;
            sum->unstable += more.unstable;
        }
    }
    size_t values() const { return all_.values; }

    // At most the share `most` of the values may be skipped as unstable.
    testing::AssertionResult is_stable(double most = 0.001) const {
        if (static_cast<double>(all_.unstable) <= most * static_cast<double>(all_.values))
            return testing::AssertionSuccess();
        return testing::AssertionFailure() << "left out " << share(all_) << ", most of it by\n"
                                           << worst();
    }

    // The entries with the most skipped values, one per line.
    std::string worst() const {
        std::vector<std::pair<std::string, Comparison>> rows(by_name_.begin(), by_name_.end());
        std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
            return a.second.unstable > b.second.unstable;
        });
        std::string text;
        for (size_t i = 0; i < rows.size() && i < 8 && rows[i].second.unstable > 0; ++i)
            text += "    " + rows[i].first + ": " + share(rows[i].second) + "\n";
        return text;
    }

private:
    static std::string share(const Comparison& of) {
        return std::to_string(of.unstable) + " of " + std::to_string(of.values);
    }

    Comparison all_;
    std::map<std::string, Comparison> by_name_;
};

void expect_equal(const char* sides, const Comparison& comparison) {
    EXPECT_EQ(comparison.different, 0U);
    if (const auto& first = comparison.first)
        ADD_FAILURE() << sides << ": output " << first->output << " at point " << first->point
                      << ": " << first->a << " and " << first->b << ", precisely " << first->precise
                      << "; allowed " << first->allowed;
}

// Compares float with GLSL, and float with double.
Comparison compare_all(const Module& module, const PointSet& points, const ImageOf& images) {
    const Reference reference = make_reference(module, points, images);
    const Values cpu = on_cpu<float>(module, points, images);
    const Values gpu = on_gpu(module, points, images);
    if (gpu.size() != cpu.size()) return {};
    expect_equal("float and double", reference.compare(cpu, reference.precise));
    const Comparison result = reference.compare(cpu, gpu);
    expect_equal("CPU and GPU", result);
    return result;
}

void expect_none(const NodeType& type, const certify::Report& report) {
    for (const certify::Finding& finding : report.findings)
        ADD_FAILURE() << to_text(to_diagnostic(finding, report, type.origin)) << "\n"
                      << finding.graph;
}

TEST_F(Parity, OfEveryNode) {
    Tally all;
    for (const NodeType& type : all_nodes().list()) {
        certify::Report report;
        certify::check_parity(type, bench(true), report);
        expect_none(type, report);
        all.add(type.id, {report.values, report.unstable, 0, {}});
    }
    EXPECT_GE(all.values(), all_nodes().list().size() * point_count * 4);
    EXPECT_TRUE(all.is_stable());
}

TEST_F(Parity, IsFiniteOnDegenerateInput) {
    for (const NodeType& type : all_nodes().list()) {
        certify::Report report;
        certify::check_finite(type, bench(true), report);
        expect_none(type, report);
    }
}

// Textures from the named files, each read once.
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
    Tally all, finished;
    size_t graphs = 0;
    const ImageOf images = images_of_files();
    // The uvs of a mesh: further out, rounding of floats moves a steep height map by more.
    const PointSet points = certify::random_points(3000, 7, {0, 1});
    for (const std::filesystem::path& path : sample_graphs()) {
        SCOPED_TRACE(path.string());
        Diagnostics diagnostics;
        const Project project = load_project(path, {}, diagnostics);
        MaterialOptions options;
        options.uniform_parameters = true;
        options.given_differentials = true;
        const Compiled compiled = compile_material(project, all_nodes(), options, diagnostics);
        EXPECT_TRUE(compiled.ok) << to_text(diagnostics);
        const std::filesystem::path folder = path.parent_path().filename();
        Tally& tally = folder == "materials" || folder == "rebuilt" ? finished : all;
        if (compiled.ok) tally.add(path.filename(), compare_all(compiled.module, points, images));
        ++graphs;
    }
    EXPECT_GE(graphs, 6U);
    EXPECT_TRUE(all.is_stable());
    // Cracks, threads and veins are thin next to the bends that move them: more points are near an
    // edge.
    EXPECT_TRUE(finished.is_stable(0.008));
}

TEST(Tally, NamesThoseThatLeaveOutMost) {
    Tally tally;
    tally.add("steady", {5000, 0, 0, {}});
    tally.add("some", {1000, 2, 0, {}});
    tally.add("most", {1000, 5, 0, {}});
    EXPECT_TRUE(tally.is_stable());
    tally.add("some", {1000, 2, 0, {}});
    EXPECT_STREQ(tally.is_stable().message(),
                 "left out 9 of 8000, most of it by\n    most: 5 of 1000\n    some: 4 of 2000\n");
}

// The comparison detects errors: a wrong factor, texel or texture, a NaN.
class SeededError : public WithGpu {
protected:
    SeededError()
        : subject(compile_harness(*all_nodes().find("tangent_normal_map"), Inputs::numbers, 3)),
          module(subject.compiled.module),
          reference(make_reference(module, the_points(), test_image)),
          gpu(on_gpu(module, the_points(), test_image)) {}

    Subject subject;
    Module& module;
    Reference reference;
    Values gpu;
};

TEST_F(SeededError, IsNotThereUnlessSeeded) {
    EXPECT_EQ(reference.compare(reference.precise, gpu).different, 0U);
}

TEST_F(SeededError, OfAFactorIsFound) {
    ASSERT_FALSE(module.parameters.empty());
    Module wrong = module;
    for (Parameter& parameter : wrong.parameters)
        if (parameter.port == "strength") parameter.value[0] *= 1.25;
    const Values cpu = on_cpu<float>(wrong, the_points(), test_image);
    EXPECT_GT(reference.compare(cpu, gpu).different, point_count / 4);
}

TEST_F(SeededError, InTheGeneratedTextIsFound) {
    EmitOptions options;
    options.differentials = Differentials::given;
    Shader shader = emit(module, options);
    const size_t place = shader.source.find("textureLod(");
    ASSERT_NE(place, std::string::npos);
    shader.source.insert(place, "1.01 * ");
    EXPECT_GT(
        reference.compare(reference.precise, on_gpu(shader, the_points(), test_image)).different,
        point_count / 4);
}

TEST_F(SeededError, OfATextureIsFound) {
    const auto other = [](const std::string& file) -> const MipChain& {
        return test_image(file.ends_with("a.exr") ? "b.exr" : "a.exr");
    };
    const Values cpu = on_cpu<float>(module, the_points(), other);
    EXPECT_GT(reference.compare(cpu, gpu).different, point_count / 2);
}

TEST_F(SeededError, AsNoNumberIsFound) {
    const Comparison before = reference.compare(reference.precise, gpu);
    gpu[0][4] = NAN;
    const Comparison result = reference.compare(reference.precise, gpu);
    EXPECT_EQ(result.different + result.unstable, before.different + before.unstable + 1);
    ASSERT_TRUE(result.first);
    EXPECT_EQ(result.first->point, 1U);
}

}  // namespace
}  // namespace wrinkle::test
