// Tests of back faces of double-sided glTF meshes: the preview draws them as `wrinkle render` does
// and reports it.
#include "graph/edit.h"
#include "with_preview.h"

namespace wrinkle::editor {
namespace {

const char* const tilted = R"({
  "wrinkle": 1,
  "nodes": {
    "u": { "type": "separate_vec2", "in": { "vector": { "from": "surface.uv0" } } },
    "bump": { "type": "gradient_from_height", "in": { "height": { "from": "u.x" } } },
    "normal": { "type": "resolve", "in": { "gradient": { "from": "bump.gradient" } } }
  },
  "outputs": { "normal": { "from": "normal.normal" } }
}
)";

// A triangle in the plane z = 0, facing away from the camera.
std::string triangle(const std::string& double_sided) {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "materials": [{"doubleSided": )" +
           double_sided +
           R"(}],
        "meshes": [{"primitives": [{"material": 0,
                                    "attributes": {"POSITION": 0, "TEXCOORD_0": 1}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36},
                        {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
        "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64,)"
           R"(AACAvwAAgL8AAAAAAACAvwAAgD8AAAAAAACAPwAAgL8AAAAAAAAAAAAAAAAAAAAAAACAPwAAgD8AAAAA"}]})";
}

class DoubleSided : public WithPreview {
protected:
    std::vector<uint8_t> drawn_on(const std::string& mesh) {
        state.view.preview_view.view = gpu::View::normal;
        state.view.preview_view.mesh = mesh;
        see();
        const PreviewImage& picture = see();  // with the back-face rule of the mesh
        EXPECT_NE(picture.texture, 0U) << to_text(picture.problems);
        return pixels_of(picture.texture);
    }
    bool is_said() const {
        return to_text(state.built.problems).find("doubleSided") != std::string::npos;
    }
};

TEST_F(DoubleSided, MeshesAreDrawnByTheRuleFlipWhereTheGraphChoosesNone) {
    begin(tilted);
    const std::string both = folder.write("both.gltf", triangle("true"));
    const std::string one = folder.write("one.gltf", triangle("false"));
    const auto mirror = drawn_on(one);
    EXPECT_FALSE(is_said());
    const auto flip = drawn_on(both);
    EXPECT_TRUE(is_said());
    EXPECT_NE(flip, mirror);
    EXPECT_EQ(drawn_on(one), mirror);
    EXPECT_FALSE(is_said());
    edit(set_back_faces(state.document(), BackFaces::flip));
    EXPECT_EQ(drawn_on(one), flip);
    EXPECT_EQ(drawn_on(both), flip);
    EXPECT_FALSE(is_said());
    edit(set_back_faces(state.document(), BackFaces::mirror));
    EXPECT_EQ(drawn_on(both), mirror);
    EXPECT_FALSE(is_said());
}

}  // namespace
}  // namespace wrinkle::editor
