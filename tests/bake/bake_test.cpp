// Tests of the rows of a bake: against sample_mesh(), other settings, and brute-force dilation.
#include "bake/bake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <glm/geometric.hpp>

#include "bake/mesh_check.h"
#include "bake/support.h"
#include "mesh/shapes.h"
#include "support/files.h"
#include "support/surface.h"

namespace wrinkle::test {
namespace {

bool same(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

// A program with every input and its differentials as outputs, in the order of their numbers.
Program all_inputs(const Mesh& mesh) {
    Module module;
    for (int i = 0; i < surface_input_count; ++i) {
        const auto input = static_cast<SurfaceInput>(i);
        if (input == SurfaceInput::uv2_ || input == SurfaceInput::uv3_) continue;
        for (const Variant variant : {Variant::value, Variant::dx, Variant::dy})
            module.outputs.push_back({"o", WR_PORT_float, module.input(input, variant)});
    }
    std::string why;
    const Program program = compile_program(module, why);
    EXPECT_EQ(why, "");
    Mesh bare = mesh;
    EXPECT_EQ(missing_input(bare, program), "");
    return program;
}

template <class Vector>
void append(std::vector<float>& values, const Vector& vector) {
    for (int i = 0; i < Vector::length(); ++i)
        values.push_back(static_cast<float>(vector[i]));
}

// Not square, so that x and y differ.
constexpr BakeHow oblong = {.width = 96, .height = 40};

// Values of all_inputs() at `uv`; the differential of `view` is a finite difference.
std::vector<float> sampled(const Mesh& mesh, glm::dvec2 uv, uint32_t& triangle) {
    const auto point = sample_surface(mesh, uv, oblong.width);
    const auto upward = sample_surface(mesh, uv, oblong.height);
    EXPECT_TRUE(point && upward);
    std::vector<float> values;
    triangle = point->triangle;
    const SurfaceAttributes* all[] = {&point->value, &point->dx, &upward->dy};
    const glm::dvec3 view = glm::normalize(point->value.normal);
    for (const auto* each : all)
        append(values, each->position);
    for (const auto* each : all)
        append(values, each->normal);
    for (const auto* each : all)
        append(values, each->tangent);
    for (const auto* each : all)
        append(values, each->uv[0]);
    for (const auto* each : all)
        append(values, each->uv[1]);
    for (const auto* each : all)
        append(values, each->color);
    append(values, view);
    for (size_t k = 1; k < 3; ++k)
        append(values, (glm::normalize(point->value.normal + all[k]->normal * 1e-5) - view) / 1e-5);
    values.insert(values.end(), {1, 0, 0});  // facing
    return values;
}

TEST(BakeRows, PointsAreThoseOfSampleMesh) {
    for (const char* name : {"torus", "teapot", "cube"}) {
        const Mesh mesh = *make_shape(name);
        const Program program = all_inputs(mesh);
        const LanePicture picture = bake_lanes(mesh, program, oblong);
        const UvRaster raster(mesh, {oblong.width, oblong.height, glm::ivec2(0), 1});
        Coverage owners;
        raster.cover({0, 0, oblong.width, oblong.height}, raster.in_rows(0, oblong.height), owners);
        size_t compared = 0;
        for (uint32_t y = 0; y < oblong.height; ++y)
            for (uint32_t x = 0; x < oblong.width; ++x) {
                const uint32_t owner = owners.owners[size_t{y} * oblong.width + x];
                ASSERT_EQ(picture.covered_at(x, y) == 1, owner != Coverage::none);
                uint32_t triangle = 0;
                if (owner == Coverage::none) continue;
                const auto expected =
                    sampled(mesh, {(x + 0.5) / oblong.width, (y + 0.5) / oblong.height}, triangle);
                if (triangle != owner) continue;  // on an edge
                ++compared;
                ASSERT_EQ(expected.size(), picture.lanes);
                for (size_t lane = 0; lane < picture.lanes; ++lane) {
                    const bool differences = lane >= picture.lanes - 9 && lane < picture.lanes - 3;
                    ASSERT_NEAR(picture.at(x, y)[lane], expected[lane], differences ? 1e-4 : 0)
                        << name << ": lane " << lane << " at " << x << ", " << y;
                }
            }
        EXPECT_GT(compared, 700U) << name;
    }
}

std::string strap() {
    return bytes_of(WRINKLE_SOURCE_DIR "/graphs/noise_rock.json");
}

// Sets that the machine lacks fall back to its best one.
constexpr const char* instruction_sets[] = {"baseline", "avx2", "avx512"};

TEST(BakeRows, AreTheSameBitsForAnyThreadsRowsAndInstructions) {
    const Mesh mesh = *make_shape("teapot");
    const BakePlan plan = plan_of(bake_module_of(strap()), {"normal"});
    const BakeHow how = {.width = 200, .height = 300, .samples = 16, .dilate = 9};
    const LanePicture whole = bake_lanes(mesh, plan.program, how, plan.unit);
    for (const uint32_t threads : {2U, 7U}) {
        BakeHow other = how;
        other.threads = threads;
        EXPECT_TRUE(same(bake_lanes(mesh, plan.program, other, plan.unit).values, whole.values));
    }
    LanePicture parts;
    for (uint32_t first = 0; first < 300; first += 128) {
        BakeHow other = how;
        other.first = first;
        other.last = first + 128;
        const LanePicture part = bake_lanes(mesh, plan.program, other, plan.unit);
        parts.values.insert(parts.values.end(), part.values.begin(), part.values.end());
        parts.findings.add(part.findings);
    }
    EXPECT_TRUE(same(parts.values, whole.values));
    EXPECT_EQ(parts.findings.covered, whole.findings.covered);
    for (const char* set : instruction_sets) {
        setenv("WRINKLE_ISA", set, 1);
        EXPECT_TRUE(same(bake_lanes(mesh, plan.program, how, plan.unit).values, whole.values));
    }
    unsetenv("WRINKLE_ISA");
}

TEST(BakeRows, StopWhenTheyAreToldTo) {
    const Mesh mesh = *make_shape("plane");
    const Program program = all_inputs(mesh);
    const UvRaster raster(mesh, {256, 1024, glm::ivec2(0), 1});
    BakeInput input;
    input.mesh = &mesh;
    input.program = &program;
    uint32_t taken = 0;
    const auto take = [&](const BakedRows& rows) {
        EXPECT_EQ(rows.first, taken);
        taken += rows.count;
        return taken < 200;
    };
    EXPECT_FALSE(bake_rows(input, raster, 0, 1024, 2, take));
    EXPECT_LT(taken, 300U);
}

// Two triangles with a gap; one is thinner than a texel.
Mesh islands() {
    Mesh mesh = *make_shape("plane");
    mesh.uvs[0] = {};
    for (const glm::vec2 uv :
         {glm::vec2(0.1F, 0.2F), glm::vec2(0.45F, 0.17F), glm::vec2(0.2F, 0.8F),
          glm::vec2(0.6F, 0.3F), glm::vec2(0.95F, 0.6F), glm::vec2(0.6F, 0.303F)})
        mesh.uvs[0].push_back(uv);
    mesh.positions.assign(6, glm::vec3(0));
    mesh.normals.assign(6, glm::vec3(0, 0, 1));
    mesh.tangents.assign(6, glm::vec4(1, 0, 0, 1));
    mesh.colors.clear();
    mesh.uvs[1] = mesh.uvs[0];
    mesh.indices = {0, 1, 2, 3, 4, 5};
    return mesh;
}

Program uv_program(SurfaceInput set = SurfaceInput::uv0_) {
    Module module;
    module.outputs.push_back({"o", WR_PORT_vec2, module.input(set)});
    std::string why;
    return compile_program(module, why);
}

TEST(BakeRows, ATexelThatIsOwnedByRoundingIsOfItsTrianglesBorder) {
    Mesh mesh = islands();
    mesh.indices = {0, 1, 2};
    const float left = 10.501F / 128;  // rounds to a centre: raster corners are in 1/256 texel
    mesh.uvs[0] = {{left, 0.1F}, {0.9F, 0.5F}, {left, 0.9F}, {}, {}, {}};
    mesh.uvs[1] = mesh.uvs[0];
    for (const char* set : instruction_sets) {
        setenv("WRINKLE_ISA", set, 1);
        const LanePicture picture = bake_lanes(mesh, uv_program(SurfaceInput::uv1_));
        const LanePicture places = bake_lanes(mesh, uv_program());
        for (uint32_t y = 15; y < 113; ++y) {
            ASSERT_TRUE(picture.covered_at(10, y));
            EXPECT_FALSE(picture.covered_at(9, y));
            EXPECT_NEAR(picture.at(10, y)[0] * 128, 10.501, 1e-4) << set << " " << y;
            EXPECT_NEAR(picture.at(11, y)[0] * 128, 11.5, 1e-4) << set << " " << y;
            EXPECT_EQ(places.at(10, y)[0] * 128, 10.5F) << set << " " << y;
            EXPECT_EQ(places.at(10, y)[1] * 128, static_cast<float>(y) + 0.5F) << set;
        }
    }
    unsetenv("WRINKLE_ISA");
}

// Covers several rows of tiles.
constexpr BakeHow bare_how = {.width = 128, .height = 320, .samples = 4};
constexpr int reach = 11;

LanePicture dilated(uint32_t first = 0, uint32_t last = 320) {
    BakeHow how = bare_how;
    how.dilate = reach;
    how.threads = 2;
    how.first = first;
    how.last = last;
    return bake_lanes(islands(), uv_program(), how);
}

// Calls `see` with the position of each covered texel within `reach` and its squared distance.
template <class See>
void around(const LanePicture& bare, uint32_t x, uint32_t y, const See& see) {
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) {
            const auto column = static_cast<uint32_t>(static_cast<int>(x) + i);
            const auto row = static_cast<uint32_t>(static_cast<int>(y) + j);
            if (i * i + j * j <= reach * reach && column < bare_how.width &&
                row < bare_how.height && bare.covered_at(column, row))
                see(column, row, i * i + j * j);
        }
}

TEST(BakeRows, DilationTakesTheNearest) {
    const LanePicture bare = bake_lanes(islands(), uv_program(), bare_how), wide = dilated();
    size_t filled = 0;
    for (uint32_t y = 0; y < bare_how.height; ++y)
        for (uint32_t x = 0; x < bare_how.width; ++x) {
            int least = reach * reach + 1;
            around(bare, x, y, [&](uint32_t, uint32_t, int d) { least = std::min(least, d); });
            const int expected = least == 0 ? 1 : least <= reach * reach ? 2 : 0;
            ASSERT_EQ(wide.covered_at(x, y), expected) << x << ", " << y;
            if (expected == 0) continue;
            filled += expected == 2;
            bool found = false;  // among the nearest texels
            around(bare, x, y, [&](uint32_t i, uint32_t j, int d) {
                found = found || (d == least && std::memcmp(wide.at(x, y), bare.at(i, j), 8) == 0);
            });
            ASSERT_TRUE(found) << x << ", " << y;
        }
    EXPECT_GT(filled, 3000U);
}

TEST(BakeRows, PartsAreDilatedFromWhatLiesBesideThem) {
    std::vector<float> parts;
    for (uint32_t first = 0; first < bare_how.height; first += bake_tile) {
        const LanePicture part = dilated(first, first + bake_tile);
        parts.insert(parts.end(), part.values.begin(), part.values.end());
    }
    EXPECT_TRUE(same(parts, dilated().values));
}

TEST(BakeRows, AnEdgeTexelIsTheMeanOfWhatIsCoveredOfIt) {
    const Mesh mesh = islands();
    const LanePicture picture = bake_lanes(mesh, uv_program(), {.samples = 64});
    const LanePicture centres = bake_lanes(mesh, uv_program());
    size_t edges = 0;
    for (uint32_t y = 0; y < 128; ++y)
        for (uint32_t x = 0; x < 128; ++x) {
            if (!picture.covered_at(x, y)) continue;
            const float* uv = picture.at(x, y);
            // The sample is within its texel, and off its centre at the border of an island.
            EXPECT_NEAR(uv[0] * 128, x + 0.5, 0.5);
            EXPECT_NEAR(uv[1] * 128, y + 0.5, 0.5);
            const bool centre = std::hypot(uv[0] * 128 - x - 0.5, uv[1] * 128 - y - 0.5) < 1e-4;
            edges += !centre;
            EXPECT_FALSE(centre && !centres.covered_at(x, y));
        }
    EXPECT_GT(edges, 150U);
    EXPECT_GT(picture.findings.covered, centres.findings.covered + 60);
}

TEST(BakeRows, FindsWhatOverlapsAndWhatIsNoNumber) {
    Mesh mesh = islands();
    mesh.indices = {0, 1, 2, 0, 1, 2};
    const LanePicture picture = bake_lanes(mesh, uv_program());
    EXPECT_EQ(picture.findings.overlapped, picture.findings.covered);
    EXPECT_EQ(picture.findings.overlap_triangle, 1U);
    const glm::dvec2 texel = picture.findings.overlap_uv *
                             glm::dvec2(picture.width, picture.covered.size() / picture.width);
    EXPECT_TRUE(picture.covered_at(static_cast<uint32_t>(texel.x), static_cast<uint32_t>(texel.y)));
    EXPECT_EQ(picture.findings.not_finite, 0U);
    Module module;
    const Id u = module.component(module.input(SurfaceInput::uv0_), 0);
    const Id less = module.add(Op::sub_, {u, module.number(0.3)});
    module.outputs.push_back({"o", WR_PORT_float, module.add(Op::sqrt_, {less})});
    std::string why;
    const LanePicture roots = bake_lanes(mesh, compile_program(module, why));
    EXPECT_GT(roots.findings.not_finite, 500U);
    EXPECT_LT(roots.findings.not_finite, roots.findings.covered);
}

}  // namespace
}  // namespace wrinkle::test
