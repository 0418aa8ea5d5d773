// Tests of baked maps: against frames built by hand, analytic slopes, and graphs that read the
// maps.
#include "bake/maps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "bake/support.h"
#include "mesh/shapes.h"
#include "support/angle.h"
#include "support/files.h"
#include "support/surface.h"

namespace wrinkle::test {
namespace {

using glm::dvec3;

std::string graph(const char* name) {
    return bytes_of(std::string(WRINKLE_SOURCE_DIR "/graphs/") + name);
}

// A wave along u with amplitude `amount` in object space, with its normal.
Module wave(const char* amount = "0.05") {
    return bake_module(
        R"("s": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
           "m": {"type": "multiply", "in": {"a": {"from": "s.x"}, "b": 20}},
           "w": {"type": "sine", "in": {"angle": {"from": "m.result"}}},
           "h": {"type": "height_scale", "in": {"height": {"from": "w.result"}, "amount": )" +
            std::string(amount) + R"(}},
           "n": {"type": "resolve", "in": {"gradient": {"from": "h.height"}}})",
        R"("normal": {"from": "n.normal"}, "height": {"from": "h.height"})");
}

struct Stored {
    uint32_t width = 0;
    size_t channels = 0;
    std::vector<float> values;
    std::vector<uint8_t> covered;

    const float* at(uint32_t x, uint32_t y) const {
        return values.data() + (covered.size() - size_t{y + 1} * width + x) * channels;
    }
    bool covered_at(uint32_t x, uint32_t y) const {
        return covered[covered.size() - size_t{y + 1} * width + x] != 0;
    }
};

Stored stored(const Mesh& mesh, const BakePlan& plan, size_t map, BakeHow how = {}) {
    const LanePicture lanes = bake_lanes(mesh, plan.program, how, plan.unit);
    Stored result{lanes.width, plan.maps[map].channels.size(), {}, lanes.covered};
    result.values.resize(lanes.covered.size() * result.channels);
    std::vector<float> planes;
    for (size_t lane = 0; lane < lanes.lanes; ++lane)
        for (size_t texel = 0; texel < lanes.covered.size(); ++texel)
            planes.push_back(lanes.values[texel * lanes.lanes + lane]);
    store_map(plan.maps[map], planes.data(), lanes.covered.data(), lanes.covered.size(),
              result.values.data());
    return result;
}

// n = m.x T + m.y B + m.z N with the interpolated vectors of the mesh, not normalised.
dvec3 in_object_space(const SurfacePoint& point, const float* texel) {
    const dvec3 t(point.value.tangent);
    const dvec3 b = glm::cross(point.value.normal, t) * (point.value.tangent.w > 0 ? 1.0 : -1.0);
    return t * (2.0 * texel[0] - 1) + b * (2.0 * texel[1] - 1) +
           point.value.normal * (2.0 * texel[2] - 1);
}

TEST(BakedMaps, TangentNormalsAreThoseOfObjectSpace) {
    MapOptions object;
    object.tangent_space = false;
    const Module module = bake_module_of(graph("noise_rock.json"));
    for (const char* name : {"torus", "teapot", "sphere"}) {
        Mesh mesh = *make_shape(name);
        // Mirrors the layout, for the other handedness.
        if (std::string(name) == "torus") {
            for (size_t i = 0; i < mesh.vertex_count(); ++i) {
                mesh.uvs[0][i].x = 1 - mesh.uvs[0][i].x;
                mesh.tangents[i] = -mesh.tangents[i];
            }
        }
        const Stored tangent = stored(mesh, plan_of(module, {"normal"}), 0);
        const Stored expected = stored(mesh, plan_of(module, {"normal"}, object), 0);
        double most = 0, bump = 0;
        size_t compared = 0;
        for (uint32_t y = 0; y < 128; y += 5)
            for (uint32_t x = 0; x < 128; ++x) {
                if (!tangent.covered_at(x, y)) continue;
                const auto point = sample_surface(mesh, {(x + 0.5) / 128, (y + 0.5) / 128}, 128);
                ASSERT_TRUE(point);
                const float* e = expected.at(x, y);
                const dvec3 n(2.0 * e[0] - 1, 2.0 * e[1] - 1, 2.0 * e[2] - 1);
                most = std::max(most, angle_deg(in_object_space(*point, tangent.at(x, y)), n));
                bump = std::max(bump, angle_deg(point->value.normal, n));
                ++compared;
            }
        EXPECT_LT(most, 0.02) << name;
        EXPECT_GT(bump, 5) << name;
        EXPECT_GT(compared, 1000U);
    }
}

TEST(BakedMaps, AFlatSurfaceIsStraightUpWithAndWithoutTangents) {
    const std::string flat = R"("n": {"type": "resolve"})",
                      out = R"("normal": {"from": "n.normal"})";
    for (const bool tangents : {true, false}) {
        Mesh mesh = *make_shape("sphere");
        if (!tangents) mesh.tangents.clear();
        MapOptions options;
        options.vertex_tangents = tangents;
        const BakePlan plan = plan_of(bake_module(flat, out, tangents), {"normal"}, options);
        const Stored map = stored(mesh, plan, 0);
        for (uint32_t y = 2; y < 126; y += 4)
            for (uint32_t x = 0; x < 128; x += 3) {
                EXPECT_NEAR(map.at(x, y)[0], 0.5, 1e-5);
                EXPECT_NEAR(map.at(x, y)[1], 0.5, 1e-5);
                EXPECT_NEAR(map.at(x, y)[2], 1, 1e-5);
            }
    }
}

// The plane has side length 2: du = 1 is two units of length.
TEST(BakedMaps, AWaveHasItsAnalyticNormalDerivativeAndSlopes) {
    MapOptions options;
    options.width = 200;
    options.height = 100;
    const BakePlan plan =
        plan_of(wave(), {"normal", "derivative", "slopes", "height"}, options, false);
    const BakeHow how = {.width = 200, .height = 100};
    const Mesh plane = *make_shape("plane");
    const Stored normal = stored(plane, plan, 0, how), derivative = stored(plane, plan, 1, how),
                 slopes = stored(plane, plan, 2, how), height = stored(plane, plan, 3, how);
    EXPECT_EQ(plan.maps[2].channels[5].name, "b5_dh2dsdt");
    for (uint32_t x = 0; x < 200; ++x) {
        const double u = (x + 0.5) / 200, h = 0.05 * std::sin(20 * u);
        const double dh = 0.05 * 20 * std::cos(20 * u);
        const double length = std::hypot(dh / 2, 1);
        EXPECT_NEAR(height.at(x, 7)[0], h, 1e-6);
        EXPECT_NEAR(normal.at(x, 7)[0], 0.5 - 0.5 * dh / 2 / length, 1e-6);
        EXPECT_NEAR(normal.at(x, 7)[1], 0.5, 1e-6);
        EXPECT_NEAR(normal.at(x, 7)[2], 0.5 + 0.5 / length, 1e-6);
        EXPECT_NEAR(derivative.at(x, 7)[0], dh, 2e-6);
        EXPECT_NEAR(derivative.at(x, 7)[1], 0, 2e-6);
        const double expected[] = {h, dh / 200, 0, dh * dh / 40000, 0, 0};
        for (size_t c = 0; c < 6; ++c)
            EXPECT_NEAR(slopes.at(x, 7)[c], expected[c], 1e-6) << c;
    }
}

TEST(BakedMaps, SlopesRunDownTheMap) {
    const Module module = bake_module(
        R"("s": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
           "n": {"type": "resolve", "in": {"gradient": {"from": "s.y"}}})",
        R"("normal": {"from": "n.normal"})");
    MapOptions options;
    options.width = 128;
    options.height = 64;
    const BakePlan plan = plan_of(module, {"slopes"}, options, false);
    const Stored map = stored(*make_shape("plane"), plan, 0, {.width = 128, .height = 64});
    const double expected[] = {-1, 0, -1 / 64.0, 0, 1 / 64.0 / 64, 0};
    for (size_t c = 0; c < 6; ++c)
        EXPECT_NEAR(map.at(5, 9)[c], expected[c], 1e-6) << c;
}

TEST(BakedMaps, GreenDownScaleAndIntegersChangeTheCode) {
    const Mesh sphere = *make_shape("sphere");
    const Module module = bake_module_of(graph("noise_rock.json"));
    MapOptions down;
    down.green_down = true;
    const Stored gl = stored(sphere, plan_of(module, {"normal"}), 0);
    const Stored dx = stored(sphere, plan_of(module, {"normal"}, down), 0);
    bool differs = false;
    for (size_t i = 0; i < gl.values.size(); i += 3) {
        EXPECT_EQ(gl.values[i], dx.values[i]);
        EXPECT_NEAR(gl.values[i + 1], 1 - dx.values[i + 1], 1e-7);
        differs = differs || std::abs(gl.values[i + 1] - dx.values[i + 1]) > 0.1F;
    }
    EXPECT_TRUE(differs);
    const Mesh plane = *make_shape("plane");
    MapOptions scaled;
    scaled.scale = 4;
    const Stored d = stored(plane, plan_of(wave(), {"derivative"}, {}, false), 0);
    const Stored c = stored(plane, plan_of(wave(), {"derivative"}, scaled), 0);
    const Stored s = stored(plane, plan_of(wave(), {"slopes"}, scaled, false), 0);
    const Stored one = stored(plane, plan_of(wave(), {"slopes"}, {}, false), 0);
    for (uint32_t x = 0; x < 128; x += 3) {
        EXPECT_NEAR(d.at(x, 1)[0], (2 * c.at(x, 1)[0] - 1) * 4, 1e-5);
        EXPECT_NEAR(one.at(x, 1)[0], s.at(x, 1)[0] * 4, 1e-6);
        EXPECT_NEAR(one.at(x, 1)[1], s.at(x, 1)[1] * 4, 1e-6);
        EXPECT_NEAR(one.at(x, 1)[3], s.at(x, 1)[3] * 16, 1e-6);
    }
}

TEST(BakedMaps, ColorsAreCodedForIntegersAlone) {
    const Module module =
        bake_module(R"("c": {"type": "combine_vec3", "in": {"x": 0.5, "y": 0.002, "z": 1}})",
                    R"("color": {"from": "c.vector"})");
    const Mesh plane = *make_shape("plane");
    const Stored coded = stored(plane, plan_of(module, {"color"}), 0);
    const Stored raw = stored(plane, plan_of(module, {"color"}, {}, false), 0);
    const float codes[] = {0.735357F, 0.02584F, 1}, numbers[] = {0.5F, 0.002F, 1};
    for (size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(coded.at(9, 9)[c], codes[c], 1e-5);
        EXPECT_EQ(raw.at(9, 9)[c], numbers[c]);
    }
}

TEST(BakedMaps, UnknownMapsAndChannelsAreErrors) {
    const auto refused = [](const std::vector<MapRequest>& requests, const MapOptions& options) {
        Diagnostics diagnostics;
        EXPECT_FALSE(plan_maps(wave(), requests, options, diagnostics));
        return to_text(diagnostics);
    };
    const auto has = [](const std::string& text, const char* words) {
        return text.find(words) != text.npos;
    };
    EXPECT_TRUE(has(refused({{"normla", {}, true}}, {}), "did you mean 'normal'?"));
    EXPECT_TRUE(has(refused({{"color", {}, true}}, {}), "normal, height, derivative, slopes"));
    EXPECT_TRUE(has(refused({{"slopes", {}, true}}, {}), "--type half or float"));
    EXPECT_TRUE(has(refused({{"p", {{'r', "height", 1}}, true}}, {}), "has 1 channels"));
}

TEST(BakedMaps, PacksAreReadAsTheyAreWritten) {
    Diagnostics none;
    const auto orm = parse_pack("orm: r=occlusion g=roughness  b=normal.y", none);
    ASSERT_TRUE(orm);
    EXPECT_EQ(orm->name, "orm");
    ASSERT_EQ(orm->pack.size(), 3U);
    EXPECT_EQ(orm->pack[2].to, 'b');
    EXPECT_EQ(orm->pack[2].map, "normal");
    EXPECT_EQ(orm->pack[2].channel, 1U);
    EXPECT_EQ(parse_pack("a=height", none)->name, "packed");
    for (const char* text :
         {"", "r", "r=", "x=height", "r=a r=b", "r=a.q", "r=.r", "../x: r=a", ":r=a"}) {
        Diagnostics diagnostics;
        EXPECT_FALSE(parse_pack(text, diagnostics)) << text;
        EXPECT_EQ(diagnostics.error_count(), 1U);
    }
}

TEST(BakedMaps, APackHoldsTheChannelsOfOthers) {
    Diagnostics diagnostics;
    const MapRequest pack{"p", {{'a', "height", 0}, {'r', "normal", 2}}, true};
    const auto plan =
        plan_maps(wave(), {{"normal", {}, true}, {"height", {}, true}, pack}, {}, diagnostics);
    ASSERT_TRUE(plan) << to_text(diagnostics);
    const Mesh plane = *make_shape("plane");
    const Stored normal = stored(plane, *plan, 0), height = stored(plane, *plan, 1),
                 packed = stored(plane, *plan, 2);
    ASSERT_EQ(packed.channels, 4U);
    EXPECT_EQ(plan->lanes, 4U);  // no value is computed twice
    for (uint32_t x = 0; x < 128; x += 7) {
        EXPECT_EQ(packed.at(x, 3)[0], normal.at(x, 3)[2]);
        EXPECT_EQ(packed.at(x, 3)[1], 0);
        EXPECT_EQ(packed.at(x, 3)[3], height.at(x, 3)[0]);
    }
}

}  // namespace
}  // namespace wrinkle::test
