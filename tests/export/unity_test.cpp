// Tests of the export to Unity. Its shader compiles with glslang's HLSL front end, with the names
// of Unity's libraries declared as their documentation has them.
#include "export/support.h"
#include "glslang/validate.h"
#include "support/samples.h"

namespace wrinkle::test {
namespace {
namespace fs = std::filesystem;

using UnityExportTest = ExportTest;

constexpr const char* unity_names = R"(
#define TEXTURE2D(name) Texture2D name
#define SAMPLER(name) SamplerState name
#define CBUFFER_START(name) cbuffer name {
#define CBUFFER_END };
#define UNITY_VERTEX_INPUT_INSTANCE_ID
#define UNITY_VERTEX_OUTPUT_STEREO
#define UNITY_SETUP_INSTANCE_ID(v)
#define UNITY_TRANSFER_INSTANCE_ID(v, o)
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o)
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i)
#define FRONT_FACE_TYPE bool
#define FRONT_FACE_SEMANTIC SV_IsFrontFace
#define IS_FRONT_VFACE(value, yes, no) ((value) ? (yes) : (no))
#define half3 float3
#define half4 float4
struct SurfaceData {
    half3 albedo; half3 specular; float metallic; float smoothness; half3 normalTS; half3 emission;
    float occlusion; float alpha; float clearCoatMask; float clearCoatSmoothness;
};
struct InputData {
    float3 positionWS; float4 positionCS; float3 normalWS; half3 viewDirectionWS;
    float4 shadowCoord; float fogCoord; half3 vertexLighting; half3 bakedGI;
    float2 normalizedScreenSpaceUV; half4 shadowMask;
};
float4x4 GetWorldToObjectMatrix() { return (float4x4)0; }
float3 TransformObjectToWorld(float3 v) { return v; }
float3 TransformWorldToObject(float3 v) { return v; }
float3 TransformObjectToWorldNormal(float3 v) { return v; }
float4 TransformWorldToHClip(float3 v) { return v.xyzz; }
float4 TransformWorldToShadowCoord(float3 v) { return v.xyzz; }
float3 GetCameraPositionWS() { return (float3)0; }
float3 GetWorldSpaceNormalizeViewDir(float3 v) { return v; }
float2 GetNormalizedScreenSpaceUV(float4 v) { return v.xy; }
float3 SampleSH(float3 n) { return n; }
float ComputeFogFactor(float z) { return z; }
float3 MixFog(float3 color, float fog) { return color * fog; }
half4 UniversalFragmentPBR(InputData lit, SurfaceData s) {
    return half4(s.albedo + s.emission + lit.normalWS, s.alpha);
}
)";

// The HLSL of the pass with its includes; `stage` is its entry point.
std::string pass_of(const fs::path& folder, const std::string& name, const std::string& stage) {
    const std::string shader = bytes_of(folder / (name + ".shader"));
    const size_t begin = shader.find("HLSLPROGRAM") + 11;
    std::string pass = shader.substr(begin, shader.find("ENDHLSL") - begin);
    for (size_t at = pass.find("#include"); at != pass.npos; at = pass.find("#include", at)) {
        const size_t end = pass.find('\n', at);
        const bool own = pass.substr(at, end - at).find(name + ".hlsl") != pass.npos;
        pass.replace(at, end - at, own ? bytes_of(folder / (name + ".hlsl")) : "");
    }
    return unity_names + ("#define " + stage + " main\n") + pass;
}

TEST_F(UnityExportTest, EveryShaderCompiles) {
    size_t count = 0;
    for (const fs::path& graph : sample_graphs()) {
        if (graph.parent_path().filename() == "nodes") continue;
        const auto files = export_graph("unity", graph);
        if (files.empty()) continue;  // it has other outputs
        ++count;
        const std::string name = graph.stem().string();
        EXPECT_EQ(hlsl_errors(pass_of(out(), name, "frag"), Stage::fragment), "") << graph;
        EXPECT_EQ(hlsl_errors(pass_of(out(), name, "vert"), Stage::vertex), "") << graph;
        fs::remove_all(out());
    }
    EXPECT_GT(count, 60U);
}

TEST_F(UnityExportTest, InputsArePropertiesAndValuesOfTheMaterial) {
    export_graph("unity", WRINKLE_SOURCE_DIR "/graphs/materials/chipped_paint.json");
    const std::string shader = bytes_of(out() / "chipped_paint.shader");
    const auto has = [&](const std::string& text) { return shader.find(text) != shader.npos; };
    EXPECT_TRUE(has("chipped_paint_input_wear (\"Wear\", Range(0, 1)) = 0.37\n"));
    EXPECT_TRUE(has("chipped_paint_input_paint (\"Color\", Color) = (0.45, 0.02, 0.02, 1)\n"));
    EXPECT_TRUE(has("chipped_paint_input_tiling (\"Tiling\", Vector) = (2, 1, 0, 1)\n"));
    const std::string material = bytes_of(out() / "chipped_paint.mat");
    EXPECT_NE(material.find("- chipped_paint_input_wear: 0.37\n"), material.npos);
}

TEST_F(UnityExportTest, TexturesHaveImportSettingsAndStableIds) {
    const fs::path graph = WRINKLE_SOURCE_DIR "/graphs/woven_strap.json";
    export_graph("unity", graph);
    const std::string meta = bytes_of(out() / "textures/weave_normal.exr.meta");
    EXPECT_NE(meta.find("sRGBTexture: 0\n"), meta.npos);
    EXPECT_NE(meta.find("wrapU: 0\n"), meta.npos);
    const std::string guid = meta.substr(meta.find("guid: ") + 6, 32);
    const std::string material = bytes_of(out() / "woven_strap.mat");
    EXPECT_NE(material.find("guid: " + guid + ","), material.npos);
    export_graph("unity", graph);
    EXPECT_EQ(bytes_of(out() / "textures/weave_normal.exr.meta"), meta);
}

}  // namespace
}  // namespace wrinkle::test
