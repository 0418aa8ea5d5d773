// Tests of the channels recognised in file names. The names are those of downloads: the stems of
// files as the libraries distribute them.
#include <gtest/gtest.h>

#include "import/texture_names.h"

namespace wrinkle::textures {
namespace {

using Names = std::vector<std::string>;

// "roughness=1-alpha metalness=red", "normal=color (gl)"; "-" if it is not recognised, "unused" if
// no channel is in it.
std::string words_of(const TextureRole* role) {
    if (!role) return "-";
    std::string text;
    for (const ChannelSource& source : role->sources)
        text += (text.empty() ? "" : " ") + std::string(name_of(source.channel)) + "=" +
                (source.inverted ? "1-" : "") + std::string(name_of(source.component));
    if (role->green == NamedGreen::gl) text += " (gl)";
    if (role->green == NamedGreen::dx) text += " (dx)";
    return text.empty() ? "unused" : text;
}

struct Library {
    const char* name;
    const char* set;
    std::vector<std::pair<const char*, const char*>> files;
};

const Library libraries[] = {
    {"ambientCG",
     "Bricks102",
     {{"Bricks102", "-"},
      {"Bricks102_1K-JPG_AmbientOcclusion", "occlusion=red"},
      {"Bricks102_1K-JPG_Color", "color=color"},
      {"Bricks102_1K-JPG_Displacement", "height=red"},
      {"Bricks102_1K-JPG_NormalDX", "normal=color (dx)"},
      {"Bricks102_1K-JPG_NormalGL", "normal=color (gl)"},
      {"Bricks102_1K-JPG_Roughness", "roughness=red"}}},
    {"ambientCG, a metal with a preview",
     "Metal032",
     {{"Metal032", "-"},
      {"Metal032_4K-PNG_Color", "color=color"},
      {"Metal032_4K-PNG_Metalness", "metalness=red"},
      {"Metal032_4K-PNG_Opacity", "opacity=red"},
      {"Metal032_4K-PNG_Emission", "emission=color"}}},
    {"Poly Haven",
     "rosewood_veneer1",
     {{"rosewood_veneer1_ao_1k", "occlusion=red"},
      {"rosewood_veneer1_arm_1k", "occlusion=red roughness=green metalness=blue"},
      {"rosewood_veneer1_diff_1k", "color=color"},
      {"rosewood_veneer1_disp_1k", "height=red"},
      {"rosewood_veneer1_metal_1k", "metalness=red"},
      {"rosewood_veneer1_nor_dx_1k", "normal=color (dx)"},
      {"rosewood_veneer1_nor_gl_1k", "normal=color (gl)"},
      {"rosewood_veneer1_rough_1k", "roughness=red"},
      {"rosewood_veneer1_spec_1k", "unused"}}},
    {"Poly Haven, a set whose name ends like a channel",
     "wood_rough",
     {{"wood_rough_1k", "-"},
      {"wood_rough_diff_1k", "color=color"},
      {"wood_rough_rough_1k", "roughness=red"}}},
    {"Quixel Megascans",
     "vd3jbhf",
     {{"vd3jbhf_4K_AO", "occlusion=red"},
      {"vd3jbhf_4K_Albedo", "color=color"},
      {"vd3jbhf_4K_Cavity", "unused"},
      {"vd3jbhf_4K_Displacement", "height=red"},
      {"vd3jbhf_4K_Gloss", "roughness=1-red"},
      {"vd3jbhf_4K_Normal_LOD0", "normal=color"},
      {"vd3jbhf_4K_Opacity", "opacity=red"},
      {"vd3jbhf_4K_Roughness", "roughness=red"}}},
    {"Megascans of Unreal",
     "T_vd3jbhf",
     {{"T_vd3jbhf_4K_D", "color=color"},
      {"T_vd3jbhf_4K_N", "normal=color"},
      {"T_vd3jbhf_4K_ORDp", "occlusion=red roughness=green height=blue"}}},
    {"FreePBR",
     "rusted-metal",
     {{"rusted-metal_albedo", "color=color"},
      {"rusted-metal_ao", "occlusion=red"},
      {"rusted-metal_height", "height=red"},
      {"rusted-metal_metallic", "metalness=red"},
      {"rusted-metal_normal-dx", "normal=color (dx)"},
      {"rusted-metal_normal-ogl", "normal=color (gl)"},
      {"rusted-metal_roughness", "roughness=red"}}},
    {"cgbookcase",
     "Tiles31",
     {{"Tiles31_2K_AO", "occlusion=red"},
      {"Tiles31_2K_BaseColor", "color=color"},
      {"Tiles31_2K_Height", "height=red"},
      {"Tiles31_2K_Normal", "normal=color"},
      {"Tiles31_2K_Roughness", "roughness=red"}}},
    {"Textures.com",
     "TexturesCom_Wall_Brick5",
     {{"TexturesCom_Wall_Brick5_2x2_1K_albedo", "color=color"},
      {"TexturesCom_Wall_Brick5_2x2_1K_normal", "normal=color"},
      {"TexturesCom_Wall_Brick5_2x2_1K_height", "height=red"}}},
    {"Poliigon",
     "Bricks01",
     {{"Bricks01_COL_VAR1_2K_METALNESS", "color=color"},
      {"Bricks01_DISP16_2K_METALNESS", "height=red"},
      {"Bricks01_METALNESS_2K_METALNESS", "metalness=red"},
      {"Bricks01_NRM_2K_METALNESS", "normal=color"},
      {"Bricks01_REFL_2K_SPECULAR", "unused"},
      {"Bricks01_ROUGHNESS_2K_METALNESS", "roughness=red"}}},
    {"3DTextures.me",
     "Brick_Wall_019",
     {{"Brick_Wall_019", "-"},
      {"Brick_Wall_019_COLOR", "color=color"},
      {"Brick_Wall_019_NORM", "normal=color"},
      {"Brick_Wall_019_ambientOcclusion", "occlusion=red"}}},
    {"Substance with color spaces",
     "helmet",
     {{"helmet_BaseColor_Utility - sRGB - Texture", "color=color"},
      {"helmet_Roughness_Utility - Raw", "roughness=red"}}},
    {"Substance Painter",
     "Helmet_Visor",
     {{"Helmet_Visor_Base_color", "color=color"},
      {"Helmet_Visor_Emissive", "emission=color"},
      {"Helmet_Visor_Height", "height=red"},
      {"Helmet_Visor_Metallic", "metalness=red"},
      {"Helmet_Visor_Mixed_AO", "occlusion=red"},
      {"Helmet_Visor_Normal_DirectX", "normal=color (dx)"},
      {"Helmet_Visor_Normal_OpenGL", "normal=color (gl)"},
      {"Helmet_Visor_Roughness", "roughness=red"}}},
    {"Substance for Unreal",
     "helmet",
     {{"helmet_BaseColor", "color=color"},
      {"helmet_Normal", "normal=color"},
      {"helmet_OcclusionRoughnessMetallic", "occlusion=red roughness=green metalness=blue"}}},
    {"Substance for Unity",
     "helmet",
     {{"helmet_AlbedoTransparency", "color=color opacity=alpha"},
      {"helmet_MaskMap", "metalness=red occlusion=green roughness=1-alpha"},
      {"helmet_MetallicSmoothness", "metalness=red roughness=1-alpha"},
      {"helmet_Normal", "normal=color"}}},
    {"packings by their letters",
     "a",
     {{"a_ORM", "occlusion=red roughness=green metalness=blue"},
      {"a_RMA", "roughness=red metalness=green occlusion=blue"},
      {"a_MRA", "metalness=red roughness=green occlusion=blue"},
      {"a_metallicRoughness", "roughness=green metalness=blue"}}},
    {"words alone",
     "",
     {{"albedo", "color=color"},
      {"heightMap", "height=red"},
      {"normal map", "normal=color"},
      {"ROUGHNESS", "roughness=red"},
      {"ambient occlusion", "occlusion=red"},
      {"notes", "-"}}},
    {"separators, capitals, indices",
     "Old Wall",
     {{"Old Wall-Base Color-2048x2048", "color=color"},
      {"Old Wall-Normal GL-16bit", "normal=color (gl)"},
      {"Old Wall-ROUGH-01", "roughness=red"},
      {"Old Wall-HeightMap 4096", "height=red"}}},
};

TEST(TextureNames, OfTheLibraries) {
    for (const Library& library : libraries) {
        Names stems;
        for (const auto& [stem, role] : library.files)
            stems.emplace_back(stem);
        const RecognisedNames found = recognise(stems);
        ASSERT_EQ(found.roles.size(), stems.size());
        EXPECT_EQ(found.set, library.set) << library.name;
        for (size_t i = 0; i < stems.size(); ++i)
            EXPECT_EQ(words_of(found.roles[i]), library.files[i].second)
                << library.name << ": " << stems[i];
    }
}

TEST(TextureNames, OfOneFileNeedTheirChannelAtTheEnd) {
    const std::pair<const char*, const char*> files[] = {{"brick_normal", "normal=color"},
                                                         {"normal_brick", "-"},
                                                         {"brick", "-"},
                                                         {"roughcast", "-"},
                                                         {"brick rough cast", "-"},
                                                         {"brickRough", "roughness=red"},
                                                         {"", "-"},
                                                         {"___", "-"},
                                                         {"\xFF\xC3", "-"},
                                                         {"12", "-"},
                                                         {"1k_2k", "-"}};
    for (const auto& [stem, role] : files)
        EXPECT_EQ(words_of(recognise(Names{stem}).roles[0]), role) << stem;
}

// Names that end within the common beginning are dropped, but not if none would remain.
TEST(TextureNames, ThatAreAllOfOneChannelAreAllRecognised) {
    for (const Names& stems :
         {Names{"a_normal_1k", "a_normal_2k"}, Names{"a_normal", "a_normal"}}) {
        const RecognisedNames found = recognise(stems);
        EXPECT_EQ(words_of(found.roles[0]), "normal=color") << stems[0];
        EXPECT_EQ(words_of(found.roles[1]), "normal=color") << stems[1];
        EXPECT_EQ(found.set, "a");
    }
}

TEST(TextureNames, OfNoFilesAreNone) {
    const RecognisedNames found = recognise({});
    EXPECT_TRUE(found.roles.empty());
    EXPECT_EQ(found.set, "");
}

}  // namespace
}  // namespace wrinkle::textures
