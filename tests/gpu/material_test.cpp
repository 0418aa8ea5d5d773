// Tests of materials: uniforms, images, and the errors of invalid ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>

#include "fixture.h"
#include "image/load.h"
#include "support/files.h"

namespace wrinkle::gpu {
namespace {

using MaterialTest = WithRenderer;

Shader with_uniform() {
    Shader material = material_of({{"normal", "tint_color * gain"}}, {},
                                  "uniform vec3 tint_color;\nuniform float gain;\n");
    material.reflection.uniforms = {uniform_info("tint_color", Type::vec3_, {1, 2, 3}),
                                    uniform_info("gain", Type::float_, {2})};
    return material;
}

glm::vec3 middle(const std::vector<Pixel>& pixels) {
    return pixels[32 * 64 + 32].value;
}

TEST_F(MaterialTest, TakesUniformsWithoutCompiling) {
    EXPECT_FALSE(renderer->set_uniform("gain", std::vector<float>{1})) << "there is no material";
    EXPECT_EQ(middle(draw(with_uniform(), View::normal)), glm::vec3(2, 4, 6));
    EXPECT_TRUE(renderer->set_uniform("gain", std::vector<float>{-1}));
    EXPECT_EQ(middle(draw(View::normal)), glm::vec3(-1, -2, -3));
    EXPECT_FALSE(renderer->set_uniform("gain", std::vector<float>{1, 2}));
    EXPECT_FALSE(renderer->set_uniform("pain", std::vector<float>{1}));
    Shader changed = with_uniform();
    changed.reflection.uniforms[1].value = {10};
    EXPECT_EQ(middle(draw(changed, View::normal)), glm::vec3(10, 20, 30));
}

Shader with_image(const std::string& file) {
    Shader material = material_of({{"normal", "texture(map, vec2(1.25, 0.5)).rgb"}}, {},
                                  "uniform sampler2D map;\n");
    material.reflection.samplers = {
        sampler_info("map", file, {Encoding::linear, Wrap::clamp, Filter::linear})};
    return material;
}

MipChain two_texels() {
    Image image = make_image(2, 1, 3);
    image.data = {1, 2, 3, 4, 5, 6};
    return build_mips(image);
}

TEST_F(MaterialTest, LooksImagesUpAsTheSamplerSays) {
    ASSERT_TRUE(renderer->add_image({"given"}, two_texels(), diagnostics));
    Shader material = with_image("given");
    EXPECT_EQ(middle(draw(material, View::normal)), glm::vec3(4, 5, 6));
    material.reflection.samplers[0].options.wrap = Wrap::repeat;
    EXPECT_EQ(middle(draw(material, View::normal)), glm::vec3(1, 2, 3));
    renderer->forget_images();
    EXPECT_EQ(middle(draw(View::normal)), glm::vec3(1, 2, 3)) << "a given image is kept";
    EXPECT_EQ(middle(draw(material, View::normal)), glm::vec3(1, 2, 3));
}

TEST_F(MaterialTest, ReadsImageFilesOnceUntilToldToForgetThem) {
    const test::TemporaryFolder folder;
    const std::string file = folder.path() / "flat.exr";
    const auto save = [&](float value) {
        Image image = make_image(1, 1, 3);
        image.data = {value, value, value};
        WriterOptions options;
        options.type = PixelType::float32;
        ASSERT_TRUE(save_image(image, file, options, diagnostics)) << errors();
    };
    save(3);
    EXPECT_EQ(middle(draw(with_image(file), View::normal)), glm::vec3(3));
    save(4);
    EXPECT_EQ(middle(draw(with_image(file), View::normal)), glm::vec3(3));
    renderer->forget_images();
    EXPECT_EQ(middle(draw(View::normal)), glm::vec3(3)) << "still drawn with";
    EXPECT_EQ(middle(draw(with_image(file), View::normal)), glm::vec3(4));
}

TEST_F(MaterialTest, DecodesTheTexelsOfSrgbImages) {
    const test::TemporaryFolder folder;
    const std::string file = folder.path() / "grey.png";
    Image image = make_image(1, 1, 3, PixelType::u8);
    image.data = {0, 51.0F / 255, 188.0F / 255};
    ASSERT_TRUE(save_image(image, file, {}, diagnostics)) << errors();
    Shader material = with_image(file);
    const auto expect = [&](const glm::vec3& expected) {
        EXPECT_LE(glm::distance(middle(draw(material, View::normal)), expected), 2e-5F);
    };
    expect({0, 51.0F / 255, 188.0F / 255});
    TextureOptions& options = material.reflection.samplers[0].options;
    options.encoding = Encoding::srgb;
    expect({0, 0.0331048F, 0.5028865F});
    options.srgb = SrgbDecoder::shader;
    expect({0, 51.0F / 255, 188.0F / 255});
}

TEST_F(MaterialTest, KeepsTheFormerMaterialWhenOneIsRefused) {
    EXPECT_EQ(middle(draw(with_uniform(), View::normal)), glm::vec3(2, 4, 6));
    Shader broken = with_uniform();
    const auto line = std::count(broken.source.begin(), broken.source.end(), '\n') + 1;
    broken.source += "float nonsense() { return oops; }\n";
    EXPECT_FALSE(renderer->set_material(broken, diagnostics));
    EXPECT_TRUE(mentions(errors(), ":" + std::to_string(line) + "(")) << errors();
    EXPECT_FALSE(renderer->set_material(with_image("/nowhere/at_all.png"), diagnostics));
    EXPECT_NE(errors().find("/nowhere/at_all.png"), std::string::npos) << errors();
    EXPECT_EQ(middle(draw(View::normal)), glm::vec3(2, 4, 6));
}

TEST_F(MaterialTest, RefusesImagesWithoutTexels) {
    EXPECT_FALSE(renderer->add_image({"empty"}, MipChain{}, diagnostics));
    EXPECT_NE(errors().find("'empty'"), std::string::npos);
}

TEST_F(MaterialTest, RefusesWhatTheMeshCannotGive) {
    const Shader wants = material_with_normal(
        "vec3(s.a, s.b.x)",
        {{"a", Type::vec2_, SurfaceInput::uv2_}, {"b", Type::vec4_, SurfaceInput::tangent_}});
    Mesh bare = *make_shape("sphere");
    bare.tangents.clear();
    renderer->set_mesh(bare);
    ASSERT_TRUE(renderer->set_material(wants, diagnostics)) << errors();
    EXPECT_FALSE(renderer->draw(scene, {}, *target, diagnostics));
    EXPECT_NE(errors().find("'uv2'"), std::string::npos) << errors();
    EXPECT_NE(errors().find("'tangent'"), std::string::npos) << errors();
}

TEST_F(MaterialTest, RefusesPropertiesThatNoSurfaceHas) {
    const MemberInfo given{"uv0_dx", Type::vec2_, SurfaceInput::uv0_, Variant::dx};
    EXPECT_FALSE(
        renderer->set_material(material_with_normal("vec3(s.uv0_dx, 0.0)", {given}), diagnostics));
    EXPECT_NE(errors().find("'uv0_dx'"), std::string::npos) << errors();
}

TEST_F(MaterialTest, RefusesMoreTexturesThanTheDriverBinds) {
    Shader greedy = with_uniform();
    for (int i = 0; i < 300; ++i)
        greedy.reflection.samplers.push_back(sampler_info("s" + std::to_string(i), "given"));
    EXPECT_FALSE(renderer->set_material(greedy, diagnostics));
    EXPECT_NE(errors().find("300 textures"), std::string::npos) << errors();
}

TEST_F(MaterialTest, RefusesViewsOfMissingOutputs) {
    ASSERT_TRUE(renderer->set_material(with_uniform(), diagnostics));
    ViewOptions options;
    options.view = View::height;
    EXPECT_FALSE(renderer->draw(scene, options, *target, diagnostics));
    EXPECT_NE(errors().find("no output 'height'"), std::string::npos) << errors();
    EXPECT_FALSE(renderer->measure(scene, "other", 8, 8, diagnostics));
    EXPECT_NE(errors().find("'other'"), std::string::npos) << errors();
}

TEST_F(MaterialTest, RefusesToDrawNothingOrWithAFlatMatrix) {
    EXPECT_FALSE(renderer->draw(scene, {}, *target, diagnostics));
    ASSERT_TRUE(renderer->set_material(Shader{}, diagnostics));
    scene.object = glm::scale(glm::mat4(1), glm::vec3(1, 1, 0));
    Diagnostics said;
    EXPECT_FALSE(renderer->draw(scene, {}, *target, said));
    EXPECT_NE(to_text(said).find("matrix"), std::string::npos);
}

TEST_F(MaterialTest, RefusesPicturesWithoutPixelsOrTooLarge) {
    for (const auto& [width, height] : {std::pair(0, 8), std::pair(8, -1), std::pair(8, 1 << 20)}) {
        Diagnostics said;
        EXPECT_FALSE(Target::make({width, height}, said));
        EXPECT_EQ(said.error_count(), 1U);
        EXPECT_NE(to_text(said).find(std::to_string(width) + "x"), std::string::npos);
    }
}

TEST(Views, HaveNames) {
    ASSERT_EQ(view_names().size(), 7U);
    for (std::string_view name : view_names())
        EXPECT_EQ(view_names()[static_cast<size_t>(*view_named(name))], name);
    EXPECT_EQ(view_named("difference"), View::difference);
    EXPECT_FALSE(view_named("outline"));
}

}  // namespace
}  // namespace wrinkle::gpu
