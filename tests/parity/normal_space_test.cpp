// Tests of normals in world and view space on the GPU: transformed back, they are the normals in
// object space, for rotations, mirrored and non-uniform matrices.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "certify/points.h"
#include "gpu/point_runner.h"
#include "parity/compare.h"
#include "parity/context.h"
#include "parity/node_graph.h"
#include "support/angle.h"
#include "support/files.h"

namespace wrinkle::test {
namespace {

using glm::dmat3;
using glm::dvec3;

const dmat3 matrices[] = {dmat3(1),
                          dmat3(0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 1),
                          dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1),
                          dmat3(3, 0, 0, 0, 0.4, 0, 0, 0, 1),
                          dmat3(1.5, 0.2, -0.3, 0.4, -0.7, 0.1, 0, 0.5, 2),
                          dmat3(-2e-3, 0, 0, 0, 3e-3, 1e-3, 0, 0, 1e-3)};

// The matrix that a host passes: the cofactors of M, times the sign of its determinant.
dmat3 normal_matrix(const dmat3& m) {
    const dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return glm::determinant(m) < 0 ? -cofactors : cofactors;
}

std::string glsl_of(const dmat3& m) {
    std::string list;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            list += (list.empty() ? "" : ", ") + std::to_string(m[column][row] * 1e4);
    return "mat3(" + list + ")";
}

dvec3 vector(const std::array<float, 4>& pixel) {
    return {pixel[0], pixel[1], pixel[2]};
}

class NormalSpaces : public WithGpu {
protected:
    static Module material() {
        Diagnostics diagnostics;
        const Project project = load_project(read_document(R"({"wrinkle": 1, "nodes": {
                "map": {"type": "tangent_normal_map", "in": {"image": "a.exr"}},
                "end": {"type": "resolve", "in": {"gradient": {"from": "map.gradient"}}}},
                "outputs": {"normal": {"from": "end.normal"}, "x": {"from": "end.normal"},
                            "paint": {"from": "surface.color0"}}})",
                                                           "g.json", diagnostics),
                                             image_folder(), {}, diagnostics);
        MaterialOptions options;
        options.given_differentials = true;
        Compiled compiled = compile_material(project, all_nodes(), options, diagnostics);
        EXPECT_TRUE(compiled.ok) << to_text(diagnostics);
        return std::move(compiled.module);
    }

    static gpu::PointResults results(const Module& module, NormalSpace space, bool bare,
                                     const dmat3& m, const PointSet& points) {
        EmitOptions options;
        options.differentials = Differentials::given;
        options.name = "subject";
        options.normal_space = space;
        options.bare_result = bare;
        const Shader shader = emit(module, options);
        EXPECT_EQ(compile_errors(shader), "");
        gpu::PointJob job = gpu::point_job_from(shader);
        job.points = points.count;
        for (const MemberInfo& member : shader.reflection.members) {
            if (member.normal_matrix) {
                job.body = "mat3 normal_matrix = " + glsl_of(normal_matrix(m)) + ";\n" + job.body;
                continue;
            }
            const std::vector<double>& values = points.at(member.input, member.variant);
            job.attributes.push_back(
                {member.name, info(member.type).lanes, {values.begin(), values.end()}});
        }
        for (const SamplerInfo& sampler : job.samplers)
            job.images.push_back({sampler.file, &test_image(sampler.file)});
        Diagnostics diagnostics;
        auto made = gpu::run_points(job, diagnostics);
        EXPECT_TRUE(made) << to_text(diagnostics);
        return made ? *made : gpu::PointResults(module.outputs.size());
    }
};

TEST_F(NormalSpaces, OfWorldAndViewAreThoseOfTheObjectTransformed) {
    const PointSet points = certify::random_points(400, 31);
    const Module module = material();
    const auto object = results(module, NormalSpace::object, false, {}, points);
    for (const NormalSpace space : {NormalSpace::world, NormalSpace::view})
        for (const dmat3& m : matrices) {
            const auto found = results(module, space, false, m, points);
            for (size_t i = 0; i < points.count; ++i) {
                for (const size_t normal : {0, 1}) {
                    const dvec3 n = vector(found[normal][i]);
                    EXPECT_NEAR(glm::length(n), 1, 1e-5);
                    // A normal is a covector: M^T takes it back.
                    EXPECT_LE(angle_deg(glm::transpose(m) * n, vector(object[normal][i])), 0.01);
                }
                EXPECT_EQ(found[2][i], object[2][i]) << "not a normal";
            }
        }
}

TEST_F(NormalSpaces, OfABareResultAreTransformedToo) {
    const PointSet points = certify::random_points(50, 31);
    Module module = material();
    module.outputs.resize(1);
    const auto structure = results(module, NormalSpace::view, false, matrices[4], points);
    EXPECT_EQ(results(module, NormalSpace::view, true, matrices[4], points), structure);
}

TEST(NormalSpace, OfTheWorldIsValidTextInEveryLanguage) {
    Module module;
    const std::array values{0.0, 0.6, 0.8};
    module.outputs = {{"normal", WR_PORT_normal, module.constant(Type::vec3_, values)},
                      {"bump", WR_PORT_normal, module.input(SurfaceInput::normal_)},
                      {"position", WR_PORT_vec3, module.input(SurfaceInput::position_)}};
    for (const Target& target : targets()) {
        if (!supports(target, Form::function)) continue;
        EmitOptions options;
        options.target = &target;
        options.name = "subject";
        options.normal_space = NormalSpace::world;
        const Shader shader = emit(module, options);
        ASSERT_TRUE(shader.problems.empty());
        EXPECT_EQ(shader.reflection.members.back().name, "normal_matrix");
        if (!has_validator(target)) continue;
        EXPECT_EQ(compile_errors(shader), "") << shader.source;
    }
}

}  // namespace
}  // namespace wrinkle::test
