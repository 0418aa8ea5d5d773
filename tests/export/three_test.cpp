// Tests of the export to three.js without a browser; tests/hosts draws it in Chromium.
#include <regex>

#include "export/support.h"
#include "support/samples.h"

namespace wrinkle::test {
namespace {
namespace fs = std::filesystem;

class ThreeExportTest : public ExportTest {
protected:
    std::string module_of(const std::string& graph) {
        const fs::path file = WRINKLE_SOURCE_DIR "/graphs/" + graph + ".json";
        EXPECT_FALSE(export_graph("three", file).empty()) << to_text(diagnostics);
        return bytes_of(out() / (file.stem().string() + ".js"));
    }
    static bool has(const std::string& text, const std::string& part) {
        return text.find(part) != text.npos;
    }
};

TEST_F(ThreeExportTest, EveryFieldOfTheTemplatesIsFilled) {
    const std::regex field("@[A-Z_]+@");
    for (const std::string graph : {"materials/hammered_gold", "woven_strap", "base_and_detail"}) {
        module_of(graph);
        for (const auto& entry : fs::directory_iterator(out()))
            if (entry.is_regular_file() && entry.path().extension() != ".glb") {
                EXPECT_FALSE(std::regex_search(bytes_of(entry.path()), field)) << entry.path();
            }
    }
}

TEST_F(ThreeExportTest, InputsAreUniformsOfTheirType) {
    const std::string module = module_of("materials/chipped_paint");
    EXPECT_TRUE(has(module, R"("wear": {value: 0.37})"));
    EXPECT_TRUE(has(module, R"("paint": {value: new THREE.Color(0.45, 0.02, 0.02)})"));
    EXPECT_TRUE(has(module, R"("tiling": {value: new THREE.Vector2(2, 1)})"));
    EXPECT_TRUE(has(module, R"("name": "wear")"));
    EXPECT_TRUE(has(module, "class ChippedPaintMaterial extends THREE.MeshPhysicalMaterial"));
}

TEST_F(ThreeExportTest, PartsOfTheShaderAreSwitchedOnByOutputs) {
    EXPECT_FALSE(has(module_of("woven_strap"), "clearcoat: 1"));
    const std::string oak = module_of("materials/varnished_oak");
    EXPECT_TRUE(has(oak, "clearcoat: 1"));
    EXPECT_TRUE(has(oak, "material.clearcoatF0"));
    EXPECT_TRUE(has(oak, "clearcoatNormal = wrinkle.coat_normal;"));
}

TEST_F(ThreeExportTest, DisplacementIsAFunctionOfTheVertexStage) {
    const std::string module = module_of("materials/hammered_gold");
    EXPECT_TRUE(has(module,
                    "transformed += normalize(objectNormal) * "
                    "wrinkle_hammered_gold_vertex(s);"));
    const std::string webgpu = bytes_of(out() / "hammered_gold.webgpu.js");
    EXPECT_TRUE(has(webgpu, "return wrinkle_hammered_gold_vertex(s"));
    EXPECT_TRUE(has(webgpu, "normalGeometry.normalize().mul(displace({"));
    EXPECT_FALSE(has(module_of("woven_strap"), "transformed +="));
    EXPECT_FALSE(has(bytes_of(out() / "woven_strap.webgpu.js"), "displace"));
}

TEST_F(ThreeExportTest, ImagesHaveTheirColorSpaceAndWrap) {
    const std::string module = module_of("woven_strap");
    EXPECT_TRUE(has(module, R"({uniform: "woven_strap_cloth_image", )"
                            R"(file: "textures/weave_normal.exr", float: true, srgb: false, )"
                            R"(wrap: THREE.RepeatWrapping, nearest: false})"));
    EXPECT_TRUE(has(module, "EXRLoader"));
    EXPECT_TRUE(fs::exists(out() / "textures/weave_normal.exr"));
}

TEST_F(ThreeExportTest, TheModuleForWebGpuReadsEachOutputOfOneCall) {
    module_of("materials/varnished_oak");
    const std::string module = bytes_of(out() / "varnished_oak.webgpu.js");
    EXPECT_TRUE(has(module, "class VarnishedOakMaterial extends THREE.MeshPhysicalNodeMaterial"));
    EXPECT_TRUE(has(module, "wrinkle_result = wrinkle_varnished_oak(s"));
    EXPECT_TRUE(has(module, "{ return wrinkle_result.coat_normal + vec3f(done); }"));
    EXPECT_TRUE(has(module, "this.colorNode = vec4(coated({color: output_color({done})"));
    module_of("woven_strap");
    const std::string strap = bytes_of(out() / "woven_strap.webgpu.js");
    EXPECT_TRUE(has(strap, "woven_strap_cloth_image_sampler: sampler(images."));
    EXPECT_FALSE(has(strap, "coated"));
}

}  // namespace
}  // namespace wrinkle::test
