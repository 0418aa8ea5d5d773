// Tests of the export to Unreal Engine: its function compiles with glslang's HLSL front end, its
// script with Python, and its maps have the conventions of DirectX.
#include <cstdlib>

#include "export/support.h"
#include "glslang/validate.h"
#include "image/load.h"
#include "support/samples.h"

namespace wrinkle::test {
namespace {
namespace fs = std::filesystem;

class UnrealExportTest : public ExportTest {
protected:
    std::string script() const { return bytes_of(out() / "rock.py"); }
    Image map(const std::string& suffix) {
        const auto image = load_image(out() / ("textures/T_rock_" + suffix + ".png"), diagnostics);
        EXPECT_TRUE(image) << to_text(diagnostics);
        return image.value_or(Image());
    }
};

TEST_F(UnrealExportTest, EveryFunctionCompiles) {
    for (const fs::path& graph : sample_graphs()) {
        if (graph.parent_path().filename() != "materials") continue;
        ASSERT_FALSE(export_graph("unreal", graph).empty()) << to_text(diagnostics);
        const std::string text = bytes_of(out() / (graph.stem().string() + ".ush"));
        const std::string main = "\nfloat4 main() : SV_Target { return (float4)0; }\n";
        EXPECT_EQ(hlsl_errors(text.substr(text.find('\n')) + main, Stage::fragment), "") << graph;
    }
}

// A height of 0.02 over a side of 2, up in the image: m = (0, -0.01, 1), so green down is 0.505.
TEST_F(UnrealExportTest, NormalsHaveGreenDown) {
    export_channels("unreal", R"("normal": {"from": "h.height"})",
                    R"("uv": {"type": "uv_transform"},
                       "s": {"type": "separate_vec2", "in": {"vector": {"from": "uv.uv"}}},
                       "h": {"type": "height_remap", "in": {"height": {"from": "s.y"}}},)");
    const Image normal = map("N");
    EXPECT_EQ(normal.source, PixelType::u16);
    EXPECT_NEAR(normal.texel(8, 8)[1], 0.505, 1e-4);
}

TEST_F(UnrealExportTest, TheScriptIsPython) {
    ASSERT_FALSE(export_channels("unreal", R"("color": [0.5, 0, 0], "opacity": 1)").empty());
    EXPECT_NE(script().find(R"(("constant", (0.5, 0, 0,), [("", PROPERTY.MP_BASE_COLOR)]))"),
              std::string::npos)
        << script();
    const std::string command = "python3 -m py_compile " + (out() / "rock.py").string();
    EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace wrinkle::test
