// Tests of wrinkle bake: choice of the baked UDIM tiles, and the file names of tiles.
#include "cli/bake_support.h"
#include "mesh/files.h"

namespace wrinkle::test {
namespace {

// A quad over one UDIM tile; `corner` is its lower corner in glTF coordinates (v downwards).
std::string gltf_square(glm::vec2 corner) {
    GltfText file;
    const auto attribute = [&](const std::string& name, int accessor) {
        file.attributes += (file.attributes.empty() ? "" : ", ") + ("\"" + name + "\": ") +
                           std::to_string(accessor);
    };
    attribute("POSITION", file.add({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3"));
    const float u = corner.x, v = corner.y;
    attribute("TEXCOORD_0", file.add({u, v + 1, u + 1, v + 1, u + 1, v, u, v}, "VEC2"));
    file.primitive = ", \"indices\": " + std::to_string(file.add_indices({0, 1, 2, 0, 2, 3}));
    return file.text();
}

class BakeTilesTest : public BakeTest {
protected:
    void SetUp() override {
        BakeTest::SetUp();
        put("g.json", ramp_graph());
        graph = "g.json";
    }

    void obj(const std::string& name, const std::string& uvs) {
        put(name, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + uvs + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
    }

    Ran bake_value(const std::string& mesh, const std::string& out, Names more = {}) {
        more.insert(more.end(), {"--map", "value", "--type", "float", "--size", "8"});
        return bake(mesh, out, more);
    }
};

TEST_F(BakeTilesTest, ALayoutInOneOtherSquareIsBakedWithItsOwnUvs) {
    put("first.gltf", gltf_square({0, 0}));
    put("below.gltf", gltf_square({0, 1}));  // v from -1 to 0 after the flip
    put("left.gltf", gltf_square({-4, 1}));
    for (const char* name : {"first", "below", "left"}) {
        const Ran ran = bake_value(std::string(name) + ".gltf", std::string(name) + ".exr");
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.err, "");
    }
    EXPECT_TRUE(same_files("first.exr", "below.exr"));
    // The graph's ramp is 2 * uv0.x.
    const Image first = picture("first.exr"), left = picture("left.exr");
    for (uint32_t x = 0; x < 8; ++x) {
        EXPECT_FLOAT_EQ(first.texel(x, 3)[0], 2 * (x + 0.5F) / 8);
        EXPECT_FLOAT_EQ(left.texel(x, 3)[0], 2 * ((x + 0.5F) / 8 - 4));
    }
}

TEST_F(BakeTilesTest, TilesOfAGltfGoByItsOwnV) {
    put("up.gltf", gltf_square({2, 1}));
    put("down.gltf", gltf_square({2, -1}));
    for (const char* name : {"up", "down"}) {
        const Ran ran =
            bake_value(std::string(name) + ".gltf", std::string(name) + ".exr", {"--udim"});
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_TRUE(exists(std::string(name) + ".1013.exr"));
    }
    EXPECT_TRUE(same_files("up.1013.exr", "down.1013.exr"));
}

TEST_F(BakeTilesTest, SeveralSquaresAreReachedAsTheHintSays) {
    obj("two.obj", "vt 0 -1\nvt 1 -1\nvt 1 -3\nvt 0 -3\n");
    const Ran refused = bake_value("two.obj", "two.exr");
    EXPECT_EQ(refused.code, 1);
    EXPECT_TRUE(says(refused.err, "no triangle lies in the uv square"));
    EXPECT_TRUE(says(refused.err, "--udim"));
    const Ran ran = bake_value("two.obj", "two.exr", {"--udim"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(exists("two.1021.exr") && exists("two.1031.exr") && !exists("two.1011.exr"));
}

TEST_F(BakeTilesTest, SquaresWithoutANumberAreCutOffOrRefused) {
    obj("left.obj", "vt -3 0\nvt -1 0\nvt -1 1\nvt -3 1\n");
    for (const Names& more : {Names{}, Names{"--udim"}}) {
        const Ran ran = bake_value("left.obj", "left.exr", more);
        EXPECT_EQ(ran.code, 1);
        EXPECT_TRUE(says(ran.err, "with u from 0 to 10 and v on one side of 0")) << ran.err;
        EXPECT_FALSE(says(ran.err, "--udim"));
    }
    obj("both.obj", "vt 0 -1\nvt 1 -1\nvt 1 2\nvt 0 2\n");
    const Ran ran = bake_value("both.obj", "both.exr", {"--udim"});
    EXPECT_EQ(ran.code, 0);
    EXPECT_TRUE(says(ran.err, "2 of 2 triangles reach into squares of uv that UDIM has no number"));
    EXPECT_TRUE(exists("both.1001.exr") && exists("both.1011.exr") && !exists("both.1021.exr"));
}

TEST_F(BakeTilesTest, LintDoesNotHoldALayoutToTile) {
    graph = WRINKLE_SOURCE_DIR "/graphs/noise_rock.json";
    ASSERT_EQ(bake("cylinder", "n.png", {"--size", "256", "--map", "roughness"}).code, 0);
    const Ran ran = run({"lint", "n.png"});
    EXPECT_EQ(ran.code, 0);
    EXPECT_TRUE(says(ran.out, "note: seam_v")) << "its two caps";
    EXPECT_EQ(run({"lint", "n.png", "--wrap", "repeat"}).code, 1);
    EXPECT_EQ(run({"lint", "n.png", "--wrap", "clamp"}).code, 0);
}

}  // namespace
}  // namespace wrinkle::test
