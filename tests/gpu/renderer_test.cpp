#include "gpu/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "fixture.h"

namespace wrinkle::gpu {
namespace {

using glm::mat4;
using glm::vec3;
using glm::vec4;
using RendererTest = WithRenderer;

const MemberInfo normal_member{"normal", Type::vec3_, SurfaceInput::normal_};

double mean_value(const std::vector<Pixel>& pixels, size_t from_row, size_t to_row, size_t side) {
    double sum = 0;
    size_t count = 0;
    for (size_t i = from_row * side; i < to_row * side; ++i) {
        if (!pixels[i].covered) continue;
        sum += pixels[i].value.g;
        ++count;
    }
    return sum / static_cast<double>(std::max<size_t>(count, 1));
}

TEST_F(RendererTest, DrawsEveryShapeLitFromAbove) {
    for (const Shape& shape : shapes()) {
        show(std::string(shape.name));
        const std::vector<Pixel> pixels = draw(Shader{}, View::shaded);
        const size_t part = shape.name == "teapot" ? 5 : 3;
        EXPECT_GT(covered(pixels), pixels.size() / part) << shape.name;
        EXPECT_LT(covered(pixels), pixels.size()) << shape.name;
        EXPECT_FALSE(pixels.front().covered) << shape.name << " leaves the corners empty";
        for (const Pixel& pixel : pixels)
            if (pixel.covered) {
                ASSERT_GT(pixel.value.g, 0.02F) << shape.name;
                ASSERT_LT(pixel.value.g, 8) << shape.name << " reflects no more than a rim light";
            }
        if (shape.name == "sphere") {
            EXPECT_GT(mean_value(pixels, 32, 64, 64), 1.1 * mean_value(pixels, 0, 32, 64));
        }
    }
}

TEST_F(RendererTest, GivesTheSphereItsNormals) {
    const Shader where =
        material_with_normal("s.position", {{"position", Type::vec3_, SurfaceInput::position_}});
    const auto positions = draw(where, View::normal);
    const auto normals = draw(Shader{}, View::normal);
    const auto uvs = draw(View::uv);
    for (size_t i = 0; i < positions.size(); ++i) {
        if (!positions[i].covered) continue;
        ASSERT_NEAR(glm::length(normals[i].value), 1, 1e-5);
        ASSERT_LT(glm::distance(normals[i].value, glm::normalize(positions[i].value)), 2e-3);
        const double longitude = 2 * std::numbers::pi * (uvs[i].value.x - 0.5);
        const vec3 n = normals[i].value;
        ASSERT_NEAR(std::atan2(n.x, n.z), longitude, 2e-2 / std::max(1e-2F, std::hypot(n.x, n.z)));
        ASSERT_NEAR(std::asin(n.y), std::numbers::pi * (uvs[i].value.y - 0.5), 3e-3);
    }
}

// A mesh drawn under a matrix gives the same image as the mesh transformed by the matrix. Normals
// of the latter follow from the equation of the transformed ellipsoid, so no cofactor is used.
TEST_F(RendererTest, LightsATransformedObjectAsItsTransformedMesh) {
    scene.camera.distance = 12;
    for (const vec3 scale :
         {vec3(2, 0.5F, 1), vec3(-1, 1, 1), vec3(1.5F, -0.4F, -1), vec3(-0.5F, -1, -2)}) {
        const mat4 turn = glm::rotate(mat4(1), 0.7F, glm::normalize(vec3(1, 2, 3)));
        scene.object = glm::scale(turn, scale);
        show("sphere");
        scene.camera.distance = 12;
        const auto found = draw(Shader{}, View::shaded);

        Mesh mesh = *make_shape("sphere");
        for (size_t v = 0; v < mesh.vertex_count(); ++v) {
            const vec3 p = mesh.positions[v];
            mesh.positions[v] = vec3(scene.object * vec4(p, 1));
            const vec3 gradient = p / scale;  // grad of (x/a)^2 + (y/b)^2 + (z/c)^2 at scale * p
            mesh.normals[v] = glm::normalize(vec3(turn * vec4(gradient, 0)));
        }
        if (scale.x * scale.y * scale.z < 0)
            for (size_t i = 0; i < mesh.indices.size(); i += 3)
                std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
        renderer->set_mesh(mesh);
        scene.object = mat4(1);
        const auto expected = draw(View::shaded);
        EXPECT_GT(covered(found), 200U);
        double worst = 0;
        size_t edge = 0;
        for (size_t i = 0; i < found.size(); ++i) {
            if (found[i].covered != expected[i].covered)
                ++edge;
            else
                worst = std::max<double>(worst, std::abs(found[i].value.g - expected[i].value.g));
        }
        EXPECT_LT(worst, 0.02) << scale.x << " " << scale.y << " " << scale.z;
        EXPECT_LE(edge, 4U);
    }
}

TEST_F(RendererTest, SeesFrontFacesOfMirroredObjects) {
    const Shader facing =
        material_with_normal("vec3(s.facing)", {{"facing", Type::float_, SurfaceInput::facing_}});
    for (const vec3 scale : {vec3(1), vec3(-1, 1, 1), vec3(1, -2, 1), vec3(-1, -1, -1)}) {
        scene.object = glm::scale(mat4(1), scale);
        const auto pixels = draw(facing, View::normal);
        EXPECT_GT(covered(pixels), 500U);
        for (const Pixel& pixel : pixels)
            ASSERT_EQ(pixel.value.x, pixel.covered ? 1 : 0) << scale.x << scale.y << scale.z;
    }
}

TEST_F(RendererTest, SeesBackFacesFromBehind) {
    show("plane");
    scene.camera.yaw = std::numbers::pi_v<float>;
    const auto facing = draw(
        material_with_normal("vec3(s.facing)", {{"facing", Type::float_, SurfaceInput::facing_}}),
        View::normal);
    const auto normals = draw(Shader{}, View::normal);
    EXPECT_GT(covered(facing), 500U);
    for (size_t i = 0; i < facing.size(); ++i) {
        if (!facing[i].covered) continue;
        ASSERT_EQ(facing[i].value.x, -1);
        ASSERT_EQ(normals[i].value, vec3(0, 0, -1)) << "a missing normal is turned to the eye";
    }
    // A normal that faces away from the eye is not changed and is not a bump.
    draw(material_with_normal("s.normal", {normal_member}), View::normal);
    for (const Pixel& pixel : draw(View::gradient))
        ASSERT_LT(glm::length(pixel.value), 1e-6);
}

TEST_F(RendererTest, GivesTheEyeInObjectSpace) {
    scene.object = glm::scale(glm::translate(mat4(1), vec3(0.5F, 0, 0)), vec3(2, -1, 0.5F));
    const vec3 eye = (vec3(eye_of(scene.camera)) - vec3(0.5F, 0, 0)) / vec3(2, -1, 0.5F);
    const std::vector<MemberInfo> members{
        {"p", Type::vec3_, SurfaceInput::position_},
        {"r", Type::vec3_, SurfaceInput::position_, Variant::value, true},
        {"v", Type::vec3_, SurfaceInput::view_}};
    const auto eyes = draw(material_with_normal("s.p - s.r", members), View::normal);
    for (const Pixel& pixel : eyes)
        ASSERT_LT(glm::distance(pixel.value, pixel.covered ? eye : vec3(0)), 1e-4);
    const auto off = draw(material_with_normal("s.v + normalize(s.r)", members), View::normal);
    const auto views = draw(material_with_normal("s.v", members), View::normal);
    EXPECT_GT(covered(off), 500U);
    for (size_t i = 0; i < off.size(); ++i) {
        if (!off[i].covered) continue;
        ASSERT_LT(glm::length(off[i].value), 1e-5);
        ASSERT_NEAR(glm::length(views[i].value), 1, 1e-5);
    }
}

TEST_F(RendererTest, HandsVertexAttributesOn) {
    Mesh mesh = *make_shape("plane");
    mesh.uvs[2].assign(mesh.vertex_count(), glm::vec2(3, 4));
    mesh.uvs[3].assign(mesh.vertex_count(), glm::vec2(5, 6));
    mesh.colors.assign(mesh.vertex_count(), vec4(0.1F, 0.2F, 0.3F, 0.4F));
    mesh.tangents.assign(mesh.vertex_count(), vec4(1, 0, 0, -1));
    renderer->set_mesh(mesh);
    const std::vector<MemberInfo> members{{"b", Type::vec2_, SurfaceInput::uv1_},
                                          {"c", Type::vec2_, SurfaceInput::uv2_},
                                          {"d", Type::vec2_, SurfaceInput::uv3_},
                                          {"t", Type::vec4_, SurfaceInput::tangent_},
                                          {"k", Type::vec4_, SurfaceInput::color0_}};
    const auto at_middle = [&](const std::string& expression) {
        return draw(material_with_normal(expression, members), View::normal)[32 * 64 + 32].value;
    };
    const auto near = [](vec3 a, vec3 b) { return glm::distance(a, b) < 1e-5; };
    EXPECT_LT(glm::distance(at_middle("vec3(s.b, 0.0)"), vec3(0.5F, 0.5F, 0)), 0.06F);
    EXPECT_TRUE(near(at_middle("vec3(s.c, s.d.x)"), vec3(3, 4, 5)));
    EXPECT_TRUE(near(at_middle("vec3(s.d.y, s.t.xw)"), vec3(6, 1, -1)));
    EXPECT_TRUE(near(at_middle("s.k.rgb + s.k.a"), vec3(0.5F, 0.6F, 0.7F)));
}

TEST_F(RendererTest, DrawsTheSameBytesTwice) {
    std::vector<float> first;
    for (int run = 0; run < 2; ++run) {
        const auto own = Context::offscreen(diagnostics);
        ASSERT_TRUE(own && const_cast<Context&>(*own).make_current());
        Renderer fresh;
        fresh.set_mesh(*make_shape("torus"));
        ASSERT_TRUE(fresh.set_material(tilted(), diagnostics)) << errors();
        TargetOptions options{size, size};
        options.samples = 4;
        const auto picture = Target::make(options, diagnostics);
        ASSERT_TRUE(fresh.draw(scene, {}, *picture, diagnostics)) << errors();
        if (run == 0) first = picture->read();
        EXPECT_EQ(picture->read(), first);
    }
    ASSERT_TRUE(context->make_current());
}

// A time limit that no strip can meet gives strips of one row, except for the first.
TEST_F(RendererTest, DrawsTheSameBytesInStrips) {
    Renderer fresh;
    fresh.set_mesh(*make_shape("torus"));
    ASSERT_TRUE(fresh.set_material(tilted(), diagnostics)) << errors();
    TargetOptions options{size, size};
    options.samples = 4;
    const auto whole = Target::make(options, diagnostics);
    ASSERT_TRUE(fresh.draw(scene, {}, *whole, diagnostics)) << errors();
    for (const double milliseconds : {1e-9, 0.5, 1e9}) {
        const auto strips = Target::make(options, diagnostics);
        ViewOptions view;
        view.strip_milliseconds = milliseconds;
        ASSERT_TRUE(fresh.draw(scene, view, *strips, diagnostics)) << errors();
        EXPECT_EQ(strips->read(), whole->read()) << milliseconds;
        EXPECT_GT(fresh.strips_took(), 0);
    }
}

// Eye, light and normal coincide: GGX times pi is then 1 / a^2 with a = roughness^2, its visibility
// 1/4, Fresnel's term f0. With the albedo E of the white lobe, the loss to masking comes back
// as the factor 1 + f0 (1 / E - 1). The diffuse lobe gets the light that the specular one does not
// reflect, figures of an integrator.
TEST_F(RendererTest, ReflectsStraightBackAsTheFormulaSays) {
    show("plane");
    scene.to_light = vec3(0, 0, 3);
    scene.light = 0.5F;
    scene.environment = 0;
    struct Case {
        float roughness, metalness, albedo, reflected;
    };
    for (const Case& c : {Case{1, 0, 0.3069F, 0.0127F}, Case{0.5F, 0, 0.9158F, 0.0370F},
                          Case{0.5F, 1, 0.9158F, 1}, Case{0.75F, 1, 0.6269F, 1}}) {
        const float color = 0.8F, f0 = c.metalness > 0 ? color : 0.04F;
        const float gain = 1 + f0 * (1 / c.albedo - 1);
        const float lobe = f0 * gain / (4 * std::pow(c.roughness, 4.0F));
        const float diffuse = c.metalness > 0 ? 0 : color * (1 - c.reflected * gain);
        const float expected = scene.light * (diffuse + lobe);
        Shader material = material_of({{"roughness", "rough_metal.x", Type::float_},
                                       {"metalness", "rough_metal.y", Type::float_}},
                                      {}, "uniform vec2 rough_metal;\n");
        material.reflection.uniforms = {
            uniform_info("rough_metal", Type::vec2_, {c.roughness, c.metalness})};
        const auto pixels = draw(material, View::shaded);
        EXPECT_NEAR(pixels[32 * 64 + 32].value.g, expected, 0.01 * expected) << c.roughness;
    }
}

TEST_F(RendererTest, OcclusionDarkensDiffuseLight) {
    const Expression diffuse{"specular_weight", "0.0", Type::float_};
    const Expression occlusion{"occlusion", "0.5", Type::float_};
    const auto open = draw(material_of({diffuse}, {}), View::shaded);
    EXPECT_GT(mean_value(open, 40, 64, 64), 1.5 * mean_value(open, 0, 24, 64));
    const auto dark = draw(material_of({diffuse, occlusion}, {}), View::shaded);
    for (size_t i = 0; i < open.size(); ++i)
        ASSERT_NEAR(dark[i].value.g, open[i].value.g / 2, 1e-4);
}

TEST_F(RendererTest, EmissionIsAddedToWhatIsLit) {
    const Expression color{"color", "vec3(0.2, 0.4, 0.8)"};
    for (const Lighting lighting : {Lighting::ggx, Lighting::phong}) {
        scene.lighting = lighting;
        const auto dark = draw(material_of({color}, {}), View::shaded);
        const Expression nits{"emission_luminance", "250.0", Type::float_};
        const std::tuple<std::vector<Expression>, vec3> cases[] = {
            {{{"emission", "vec3(0.25, 0.5, 3.0)"}}, vec3(0.25F, 0.5F, 3)},
            {{{"emission", "vec3(-1.0)"}}, vec3(0)},
            {{{"emission", "vec3(0.25, 0.5, 3.0)"}, nits}, 2.5F * vec3(0.25F, 0.5F, 3)},
            {{nits}, vec3(2.5F)}};
        for (auto [outputs, emitted] : cases) {
            outputs.push_back(color);
            const auto bright = draw(material_of(outputs, {}), View::shaded);
            const auto pixel = size_t{32} * 64 + 32;
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(bright[pixel].value[k], dark[pixel].value[k] + emitted[k], 1e-5);
        }
    }
}

TEST_F(RendererTest, SmoothsEdgesWithSamples) {
    TargetOptions options{size, size};
    options.samples = 4;
    const auto smooth = Target::make(options, diagnostics);
    ASSERT_TRUE(smooth) << errors();
    ASSERT_TRUE(renderer->set_material(Shader{}, diagnostics));
    scene.background = vec4(0, 1, 0, 1);
    scene.light = 0;
    scene.environment = 0;
    ASSERT_TRUE(renderer->draw(scene, {}, *smooth, diagnostics)) << errors();
    const std::vector<float> pixels = smooth->read();
    size_t partial = 0;
    for (size_t i = 1; i < pixels.size(); i += 4)
        partial += pixels[i] > 0.1F && pixels[i] < 0.9F ? 1 : 0;
    EXPECT_GT(partial, 40U);
    EXPECT_LT(partial, 600U);
}

}  // namespace
}  // namespace wrinkle::gpu
