// Tests of the export to glTF. Expected factors are worked out by hand from the specifications of
// OpenPBR and of the Khronos extensions.
#include <cmath>
#include <glm/geometric.hpp>

#include "export/support.h"
#include "image/load.h"
#include "mesh/load.h"
#include "mesh/shapes.h"

namespace wrinkle::test {
namespace {
namespace fs = std::filesystem;

class GltfExportTest : public ExportTest {
protected:
    GlbFile exported(const std::string& in, const std::string& nodes = "") {
        EXPECT_FALSE(export_channels("gltf", in, nodes).empty()) << to_text(diagnostics);
        return read_glb(out() / "rock.glb");
    }

    static double number(const GlbFile& file, const std::string& pointer) {
        const json::Value value = file.at("materials/0/" + pointer);
        EXPECT_TRUE(value.is(json::Kind::number)) << pointer;
        return value.is(json::Kind::number) ? value.as_number() : NAN;
    }

    // The pixels of the image of a texture info, "normalTexture".
    Image pixels(const GlbFile& file, const std::string& pointer) {
        const auto texture = static_cast<size_t>(number(file, pointer + "/index"));
        const auto image = load_image(folder.put("map.png", file.image(texture)), diagnostics);
        EXPECT_TRUE(image) << to_text(diagnostics);
        return image.value_or(Image());
    }
};

const std::string extensions = "extensions/KHR_materials_";

TEST_F(GltfExportTest, ConstantsAreFactors) {
    const GlbFile file = exported(R"("color": [0.5, 0.25, 1],
        "base_weight": 0.5, "roughness": 0.75, "metalness": 1,
        "specular_ior": 1.75, "specular_weight": 0.5)");
    EXPECT_FALSE(file.root.has("textures"));
    EXPECT_FLOAT_EQ(number(file, "pbrMetallicRoughness/baseColorFactor/0"), 0.25);
    EXPECT_FLOAT_EQ(number(file, "pbrMetallicRoughness/baseColorFactor/1"), 0.125);
    EXPECT_FLOAT_EQ(number(file, "pbrMetallicRoughness/baseColorFactor/2"), 0.5);
    EXPECT_FLOAT_EQ(number(file, "pbrMetallicRoughness/roughnessFactor"), 0.75);
    EXPECT_FLOAT_EQ(number(file, "pbrMetallicRoughness/metallicFactor"), 1);
    EXPECT_FLOAT_EQ(number(file, extensions + "ior/ior"), 1.75);
    EXPECT_FLOAT_EQ(number(file, extensions + "specular/specularFactor"), 0.5);
}

// (1.6 - 1)^2 / (1.6 + 1)^2 = 0.0532544; over 0.04 and times 0.5: 0.66568.
TEST_F(GltfExportTest, ACoatHasTheReflectanceOfItsIndex) {
    const GlbFile file = exported(R"("coat_weight": 0.5, "coat_roughness": 0.2)");
    EXPECT_NEAR(number(file, extensions + "clearcoat/clearcoatFactor"), 0.66568, 1e-5);
    EXPECT_FLOAT_EQ(number(file, extensions + "clearcoat/clearcoatRoughnessFactor"), 0.2);
}

// r = 0.5, a = 0.5: at = 0.25 sqrt(2 / 1.25) = 0.316228, ab = 0.158114, so roughness = 0.397635 and
// strength = sqrt(0.158114 / 0.841886) = 0.433369.
TEST_F(GltfExportTest, AnisotropyHasTheAxesOfTheLobe) {
    const GlbFile file = exported(R"("roughness": 0.5, "specular_roughness_anisotropy": 0.5)");
    EXPECT_NEAR(number(file, "pbrMetallicRoughness/roughnessFactor"), 0.397635, 1e-5);
    EXPECT_NEAR(number(file, extensions + "anisotropy/anisotropyStrength"), 0.433369, 1e-5);
}

// 250 nits of a white of 100: the factor (1, 0.5, 0) times the strength 2.5.
TEST_F(GltfExportTest, EmissionIsAFactorTimesAStrength) {
    const GlbFile file = exported(R"("emission": [1, 0.5, 0], "emission_luminance": 250)");
    EXPECT_FLOAT_EQ(number(file, "emissiveFactor/0"), 1);
    EXPECT_FLOAT_EQ(number(file, "emissiveFactor/1"), 0.5);
    EXPECT_FLOAT_EQ(number(file, extensions + "emissive_strength/emissiveStrength"), 2.5);
}

// Red is u and green is v, in sRGB: 0.28125 is 144.6 of 255, 0.15625 110.1 and 0.78125 228.7.
TEST_F(GltfExportTest, ColorsAreSrgbWithTheTopRowFirst) {
    const GlbFile file = exported(R"("color": {"from": "c.vector"})",
                                  R"("uv": {"type": "uv_transform"},
           "s": {"type": "separate_vec2", "in": {"vector": {"from": "uv.uv"}}},
           "c": {"type": "combine_vec3", "in": {"x": {"from": "s.x"}, "y": {"from": "s.y"}}},)");
    const Image image = pixels(file, "pbrMetallicRoughness/baseColorTexture");
    ASSERT_EQ(image.width, 16U);
    EXPECT_EQ(image.source, PixelType::u8);
    EXPECT_NEAR(image.texel(4, 2)[0] * 255, 144.6, 0.5);
    EXPECT_NEAR(image.texel(4, 2)[1] * 255, 110.1, 0.5);
    EXPECT_NEAR(image.texel(0, 12)[1] * 255, 228.7, 0.5);
}

TEST_F(GltfExportTest, TheMeshIsReadBackAsItWas) {
    mesh = *make_shape("torus");
    exported(R"("normal": {"from": "rough.height"})", R"("rough": {"type": "fbm"},)");
    const auto read = load_mesh(out() / "rock.glb", {}, diagnostics);
    ASSERT_TRUE(read) << to_text(diagnostics);
    EXPECT_EQ(read->positions, mesh.positions);
    EXPECT_EQ(read->indices, mesh.indices);
    ASSERT_EQ(read->uvs[0].size(), mesh.uvs[0].size());
    ASSERT_EQ(read->tangents.size(), mesh.tangents.size());
    for (size_t i = 0; i < mesh.uvs[0].size(); ++i) {
        EXPECT_NEAR(read->uvs[0][i].y, mesh.uvs[0][i].y, 1e-6);
        EXPECT_LT(glm::distance(read->normals[i], mesh.normals[i]), 1e-6);
        EXPECT_LT(glm::distance(read->tangents[i], mesh.tangents[i]), 1e-6);
    }
}

TEST_F(GltfExportTest, WarnsOfOutputsWithoutACounterpart) {
    exported(R"("displacement": 0.1, "subsurface_weight": 0.5)");
    EXPECT_TRUE(says("'displacement' has no counterpart in glTF"));
    EXPECT_TRUE(says("'subsurface_weight' has no counterpart in glTF"));
}

}  // namespace
}  // namespace wrinkle::test
