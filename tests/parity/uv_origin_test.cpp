// Tests that a text with the uv origin at the top gives the values of the text with the origin at
// the bottom: (u, 1 - v), (du, -dv), the same tangents, and images with reversed rows. The
// points have rotated and mirrored uvs, tangents with w of either sign, and four uv sets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "certify/points.h"
#include "gpu/point_runner.h"
#include "ir/rewrite.h"
#include "ir/tangent_space.h"
#include "parity/compare.h"
#include "parity/context.h"
#include "parity/node_graph.h"
#include "support/angle.h"
#include "support/samples.h"

namespace wrinkle::test {
namespace {

constexpr std::array uv_sets = {SurfaceInput::uv0_, SurfaceInput::uv1_, SurfaceInput::uv2_,
                                SurfaceInput::uv3_};

PointSet flipped(PointSet points) {
    for (const SurfaceInput uv : uv_sets)
        for (const Variant variant : {Variant::value, Variant::dx, Variant::dy}) {
            std::vector<double>& values = points.at(uv, variant);
            for (size_t i = 1; i < values.size(); i += 2)
                values[i] = variant == Variant::value ? 1 - values[i] : -values[i];
        }
    return points;
}

const MipChain& flipped_image(const std::string& file) {
    static std::map<const MipChain*, MipChain> images;
    const MipChain& upright = test_image(file);
    MipChain& image = images[&upright];
    if (image.levels.empty()) {
        image = upright;
        for (size_t k = 0; k < image.levels.size(); ++k) {
            const size_t row = size_t{image.levels[k].width} * image.levels[k].channels;
            for (size_t y = 0; y < image.levels[k].height; ++y)
                std::copy_n(upright.levels[k].data.begin() + static_cast<long>(y * row), row,
                            image.levels[k].data.end() - static_cast<long>((y + 1) * row));
        }
    }
    return image;
}

Module module_of(const std::filesystem::path& graph, bool given, bool vertex_tangents) {
    Diagnostics diagnostics;
    const Project project = load_project(graph, {}, diagnostics);
    MaterialOptions options;
    options.given_differentials = given;
    options.vertex_tangents = vertex_tangents;
    Compiled compiled = compile_material(project, all_nodes(), options, diagnostics);
    EXPECT_TRUE(compiled.ok) << to_text(diagnostics);
    return std::move(compiled.module);
}

void expect_same_values(const Module& bottom, const PointSet& points) {
    const Module top = with_uv_origin_top(Module(bottom));
    const Reference reference = make_reference(bottom, points, test_image);
    const Values values = on_cpu<double>(top, flipped(points), flipped_image);
    const Comparison found = reference.compare(reference.precise, values);
    EXPECT_EQ(found.different, 0U) << found.first->a << " and " << found.first->b;
    EXPECT_LT(found.unstable, found.values / 2);
}

TEST(UvOriginAtTheTop, GivesTheValuesOfTheBottomForEverySample) {
    const PointSet points = certify::random_points(300, 11);
    for (const std::filesystem::path& path : sample_graphs())
        for (const bool tangents : {true, false}) {
            SCOPED_TRACE(path.string() + (tangents ? "" : ", no tangents"));
            const Module object = module_of(path, true, tangents);
            expect_same_values(object, points);
            expect_same_values(with_tangent_space_normals(Module(object), tangents), points);
        }
}

// A quad of pixels for each point: pixels (2 q, 0) to (2 q + 1, 1) of the two rows of the table.
// Numbers are multiples of 2^-20, so 1 - v and differences of pixels are exact in float.
class Quads {
public:
    static constexpr size_t count = 512, row = 2 * count;

    explicit Quads(const PointSet& points) : points_(points) {}

    std::vector<float> values(const MemberInfo& member) const {
        const size_t lanes = info(member.type).lanes;
        std::vector<float> result;
        for (size_t pixel = 0; pixel < 2 * row; ++pixel)
            for (size_t lane = 0; lane < lanes; ++lane) {
                const size_t at = pixel % row / 2 * lanes + lane;
                const auto number = [&](Variant variant) {
                    return points_.at(member.input, variant)[at];
                };
                const double x = pixel % 2 ? number(Variant::dx) : 0;
                const double y = pixel >= row ? number(Variant::dy) : 0;
                const double value = member.relative ? 0 : number(Variant::value);
                result.push_back(static_cast<float>(value + x + y));
            }
        return result;
    }

private:
    const PointSet& points_;
};

PointSet quantized_points() {
    PointSet points = certify::random_points(Quads::count, 23, {0, 1});
    for (const SurfaceInput uv : uv_sets)
        for (const Variant variant : {Variant::value, Variant::dx, Variant::dy})
            for (double& value : points.at(uv, variant))
                value = std::round(std::ldexp(value, 20)) / std::ldexp(1, 20);
    return points;
}

class UvOriginOnTheGpu : public WithGpu {
protected:
    static Values screen_values(const Module& module, UvOrigin origin, const PointSet& points,
                                const ImageOf& images) {
        EmitOptions options;
        options.name = "subject";
        options.uv_origin = origin;
        const Shader shader = emit(module, options);
        EXPECT_EQ(compile_errors(shader), "");
        gpu::PointJob job = gpu::point_job_from(shader);
        job.points = 2 * Quads::row;
        for (const MemberInfo& member : shader.reflection.members)
            job.attributes.push_back(
                {member.name, info(member.type).lanes, Quads(points).values(member)});
        for (const SamplerInfo& sampler : job.samplers)
            job.images.push_back({sampler.file, &images(sampler.file)});
        Diagnostics diagnostics;
        const auto results = gpu::run_points(job, diagnostics);
        EXPECT_TRUE(results) << to_text(diagnostics);
        Values values;
        if (!results) return values;
        for (const auto& output : *results) {
            values.emplace_back();
            for (const auto& pixel : output)
                values.back().insert(values.back().end(), pixel.begin(), pixel.begin() + 3);
        }
        return values;
    }

    static constexpr std::array graphs = {"woven_strap.json", "base_and_detail.json",
                                          "hex_pebbles.json"};
};

TEST_F(UvOriginOnTheGpu, GivesTheValuesOfTheBottomForGivenDifferentials) {
    const PointSet points = certify::random_points(2000, 11, {0, 1});
    for (const char* graph : graphs) {
        SCOPED_TRACE(graph);
        const Module bottom =
            module_of(WRINKLE_SOURCE_DIR "/graphs/" + std::string(graph), true, true);
        const Module top = with_uv_origin_top(Module(bottom));
        const Reference reference = make_reference(bottom, points, test_image);
        const Comparison found =
            reference.compare(reference.precise, on_gpu(top, flipped(points), flipped_image));
        EXPECT_EQ(found.different, 0U) << found.first->a << " and " << found.first->b;
        EXPECT_LT(found.unstable, found.values / 10);
    }
}

TEST_F(UvOriginOnTheGpu, GivesTheNormalsOfTheBottomForScreenDifferentials) {
    const PointSet points = quantized_points();
    for (const char* graph : graphs)
        for (const bool tangents : {true, false}) {
            SCOPED_TRACE(graph + std::string(tangents ? "" : ", no tangents"));
            const Module bottom =
                module_of(WRINKLE_SOURCE_DIR "/graphs/" + std::string(graph), false, tangents);
            const Values expected = screen_values(bottom, UvOrigin::bottom, points, test_image);
            const Values found = screen_values(with_uv_origin_top(Module(bottom)), UvOrigin::top,
                                               flipped(points), flipped_image);
            ASSERT_EQ(found.size(), expected.size());
            for (size_t output = 0; output < found.size(); ++output) {
                if (bottom.outputs[output].port_type != WR_PORT_normal) continue;
                for (size_t i = 0; i < found[output].size(); i += 3)
                    ASSERT_LE(angle_deg(&found[output][i], &expected[output][i]), 0.02) << i / 3;
            }
        }
}

}  // namespace
}  // namespace wrinkle::test
