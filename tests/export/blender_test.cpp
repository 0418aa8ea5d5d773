// Tests of the node group of an export to Blender. That its nodes have the values of the graph is
// tested in Blender (tests/hosts/proof/blender_test.py).
#include <cstdlib>

#include "export/support.h"
#include "image/load.h"

namespace wrinkle::test {
namespace {
namespace fs = std::filesystem;

class BlenderExportTest : public ExportTest {
protected:
    // Exports a graph with the inputs `tint` and `wear`; returns its script.
    std::string script_of(const std::string& nodes, const std::string& outputs) {
        const std::string graph = R"({"wrinkle": 1, "inputs": {
            "tint": {"type": "color", "default": [0.5, 0.25, 0], "label": "Tint \")\n]import os"},
            "wear": {"type": "float", "default": 0.5, "slider": [0, 2]}},
            "nodes": {)" + nodes + R"(}, "outputs": {)" +
                                  outputs + "}}";
        export_graph("blender", folder.put("rock.json", graph));
        return fs::exists(out() / "rock.py") ? bytes_of(out() / "rock.py") : "";
    }
    bool is_python() const {
        return std::system(("python3 -m py_compile " + (out() / "rock.py").string()).c_str()) == 0;
    }
    void put_image(const std::string& file) {
        const Image image = make_image(4, 4, 3, PixelType::u8);
        EXPECT_TRUE(save_image(image, folder.path() / file, {}, diagnostics));
    }
};

TEST_F(BlenderExportTest, ArithmeticIsAGroupWithTheInputsOfTheGraph) {
    const std::string script =
        script_of(R"("darker": {"type": "vec3_scale", "in":
                      {"vector": {"from": "input.tint"}, "factor": {"from": "input.wear"}}})",
                  R"("color": {"from": "darker.vector"}, "roughness": {"from": "input.wear"})");
    for (const char* part :
         {R"(    ("Tint \")\n]import os", "NodeSocketColor", (0.5, 0.25, 0, 1), None),
    ("wear", "NodeSocketFloat", 0.5, (0, 2)),
)",
          R"(    ("ShaderNodeVectorMath", "MULTIPLY", "darker", [[0, 0], [0, 1]]),
)",
          R"(    ("color", "NodeSocketColor", [1, 0]),
    ("roughness", "NodeSocketFloat", [0, 1]),
)",
          R"((("Base Color",), {"output": "color"}),)"})
        EXPECT_NE(script.find(part), std::string::npos) << part << "in\n" << script;
    EXPECT_TRUE(is_python());
    EXPECT_FALSE(fs::exists(out() / "textures"));
}

TEST_F(BlenderExportTest, OutputsWithDerivativesAreBakedWithTheirInputs) {
    const std::string script = script_of(
        R"("noise": {"type": "fbm"},
           "worn": {"type": "multiply", "in": {"a": {"from": "noise.value"},
                                               "b": {"from": "input.wear"}}},
           "other": {"type": "multiply", "in": {"a": {"from": "input.wear"}, "b": 0.5}})",
        R"("color": {"from": "input.tint"}, "roughness": {"from": "worn.result"},
           "metalness": {"from": "other.result"})");
    EXPECT_TRUE(fs::exists(out() / "textures/rock_roughness.png"));
    EXPECT_NE(script.find("\"NodeSocketColor\", (0.5, 0.25, 0, 1)"), std::string::npos);
    EXPECT_EQ(script.find("(\"wear\""), std::string::npos) << "the map does not follow it";
    EXPECT_NE(script.find("((\"Metallic\",), 0.25)"), std::string::npos) << script;
}

TEST_F(BlenderExportTest, ImagesAndMapsOfOneNameAreTwoFiles) {
    put_image("rock_roughness.png");
    const std::string script = script_of(
        R"("image": {"type": "image", "in": {"image": "rock_roughness.png"}},
           "noise": {"type": "fbm"})",
        R"("color": {"from": "image.color"}, "roughness": {"from": "noise.value"})");
    EXPECT_TRUE(fs::exists(out() / "textures/rock_roughness.png"));
    EXPECT_TRUE(fs::exists(out() / "textures/rock_roughness_baked.png"));
    EXPECT_NE(script.find(R"({"image": "textures/rock_roughness.png", "space": "sRGB", )"
                          R"("interpolation": "Linear", "extension": "REPEAT"})"),
              std::string::npos)
        << script;
}

TEST_F(BlenderExportTest, MirroredImagesAreBaked) {
    put_image("mirrored.png");
    const std::string script = script_of(
        R"("image": {"type": "image", "in":
                     {"image": {"file": "mirrored.png", "wrap": "mirror"}}})",
        R"("color": {"from": "image.color"})");
    EXPECT_NE(script.find("GROUP_NODES = [\n]"), std::string::npos) << script;
}

}  // namespace
}  // namespace wrinkle::test
