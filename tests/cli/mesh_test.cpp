// Tests of mesh files on the command line: render, eval, and the errors of invalid files.
#include <algorithm>
#include <cmath>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

// The square from (0, 0) to (1, 1) in z = 0 with uv = position.
const std::string square_obj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "f 1/1 2/2 3/3 4/4\n";
const std::string square_gltf =
    R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "buffers": [{"byteLength": 36, "uri": "FILE"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}]})";

std::string gltf_of(const std::string& file) {
    std::string text = square_gltf;
    return text.replace(text.find("FILE"), 4, file);
}

// (0, 0, 0), (1, 0, 0), (0, 1, 0)
std::string triangle_bytes() {
    std::string bytes(36, '\0');
    bytes.replace(12, 4, std::string("\0\0\x80\x3F", 4));
    return bytes.replace(28, 4, std::string("\0\0\x80\x3F", 4));
}

const std::string place_graph = R"({"wrinkle": 1, "nodes": {
    "p": {"type": "add", "in": {"a": 1, "b": 2}}},
    "outputs": {"at": {"from": "surface.position"}, "along": {"from": "surface.tangent"},
                "uv": {"from": "surface.uv0"}}})";

class MeshFileTest : public CliTest {};

TEST_F(MeshFileTest, EvalTakesAPointOfAFile) {
    put("square.obj", square_obj);
    put("g.json", place_graph);
    const Ran ran = run({"eval", "g.json", "--mesh", "square.obj", "--uv", "0.25,0.75"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const json::Value point = parsed(ran.out).find("points").at(0);
    EXPECT_NEAR(point.find("at").at(0).as_number(), 0.25, 1e-6);
    EXPECT_NEAR(point.find("at").at(1).as_number(), 0.75, 1e-6);
    EXPECT_NEAR(point.find("along").at(0).as_number(), 1, 1e-6);
    EXPECT_EQ(point.find("along").at(3).as_number(), 1);
}

TEST_F(MeshFileTest, RenderDrawsAFileAsItDrawsTheShape) {
    put("g.json", tilt_graph("0.75"));
    put("square.obj", square_obj);
    const Ran ran = run({"render", "g.json", "-o", "g.png", "--size", "24x24", "--mesh",
                         "square.obj", "--view", "difference"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const double tilt = std::atan(0.75) * 180 / M_PI;
    double mean = 0;
    const size_t at = ran.out.find("mean ");
    ASSERT_NE(at, ran.out.npos) << ran.out;
    EXPECT_EQ(std::sscanf(ran.out.c_str() + at, "mean %lf", &mean), 1);
    EXPECT_NEAR(mean, tilt, 0.01);
}

TEST_F(MeshFileTest, ReadsExternalFilesBelowItsFolderOrTheRoot) {
    put("g.json", tilt_graph());
    put("models/near.gltf", gltf_of("near.bin"));
    put("models/far.gltf", gltf_of("../far.bin"));
    put("models/near.bin", triangle_bytes());
    put("far.bin", triangle_bytes());
    const std::vector<std::string> args = {"render", "g.json", "-o",    "g.png",
                                           "--size", "8x8",    "--mesh"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), args.begin(), args.end());
        return run(more);
    };
    EXPECT_EQ(with({"models/near.gltf"}).code, 0) << with({"models/near.gltf"}).err;
    EXPECT_EQ(with({"models/far.gltf", "--root", "."}).code, 0);
    fs::remove(folder / "g.png");
    const Ran outside = with({"models/far.gltf"});
    EXPECT_EQ(outside.code, 1);
    EXPECT_TRUE(says(outside.err, "models/far.gltf: error: "));
    EXPECT_TRUE(says(outside.err, "'far.bin', which is outside"));
    EXPECT_TRUE(says(outside.err, "--root"));
    EXPECT_FALSE(exists("g.png"));
}

TEST_F(MeshFileTest, BadFilesAreInputErrorsAndNothingIsWritten) {
    put("g.json", tilt_graph());
    put("nan.obj", "v 0 0 nan\n");
    put("index.obj", "v 0 0 0\nf 1 2 3\n");
    put("empty.obj", "");
    put("cut.glb", std::string("glTF\x02\0\0\0\xFF\0\0\0\x20\0\0\0JSON", 20));
    put("cut.gltf", gltf_of("none.bin").substr(0, 100));
    put("lost.gltf", gltf_of("none.bin"));
    fs::create_directories(folder / "folder.obj");
    const auto before = files();
    for (const std::string name : {"nan.obj", "index.obj", "empty.obj", "cut.glb", "cut.gltf",
                                   "lost.gltf", "folder.obj", "missing.obj"})
        for (const auto& args : std::vector<std::vector<std::string>>{
                 {"render", "g.json", "-o", "g.png", "--size", "8x8", "--mesh", name},
                 {"eval", "g.json", "--mesh", name, "--uv", "0.5,0.5"}}) {
            const Ran ran = run(args);
            EXPECT_EQ(ran.code, 1) << args[0] << " " << name << ran.err;
            EXPECT_EQ(ran.out, "") << name;
            EXPECT_TRUE(says(ran.err, name)) << args[0];
            EXPECT_EQ(files(), before) << args[0] << " " << name;
        }
}

// A graph that requires an attribute that the mesh lacks is an error, not a black image.
TEST_F(MeshFileTest, WhatTheMeshLacksIsNamed) {
    put("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    put("g.json", R"({"wrinkle": 1, "nodes": {
        "split": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}}},
        "outputs": {"roughness": {"from": "split.x"}}})");
    const Ran ran =
        run({"render", "g.json", "-o", "g.png", "--size", "8x8", "--mesh", "./bare.obj"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "'uv0', which the mesh does not have"));
    EXPECT_FALSE(exists("g.png"));
    const Ran eval = run({"eval", "g.json", "--mesh", "bare.obj", "--uv", "0,0"});
    EXPECT_EQ(eval.code, 1);
    EXPECT_TRUE(says(eval.err, "no uvs"));
}

TEST_F(MeshFileTest, NamesAndPathsAreToldApart) {
    put("g.json", tilt_graph());
    put("teapot", square_obj);
    const Ran slip = run({"render", "g.json", "-o", "g.png", "--size", "8x8", "--mesh", "teapto"});
    EXPECT_EQ(slip.code, 2);
    EXPECT_TRUE(says(slip.err, "teapot"));
    EXPECT_EQ(run({"render", "g.json", "-o", "a.png", "--size", "32x32", "--mesh", "teapot"}).code,
              0);
    EXPECT_EQ(
        run({"render", "g.json", "-o", "b.png", "--size", "32x32", "--mesh", "./teapot"}).code, 0);
    EXPECT_NE(get("a.png"), get("b.png"));
}

class LightingOptionsTest : public CliTest {};

TEST_F(LightingOptionsTest, ChangeThePicture) {
    put("g.json", tilt_graph());
    // A flat Radiance image of 2 x 1 texels: red behind the object, green before it.
    put("env.hdr", std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n") +
                       std::string("\x80\x10\x10\x81\x10\x80\x10\x81", 8));
    const std::vector<std::vector<std::string>> ways = {
        {},
        {"--lighting", "phong"},
        {"--lighting", "phong", "--phong", "0.3,0.2,0,1"},
        {"--light", "overcast"},
        {"--light", "sun", "--background", "environment"},
        {"--turn", "90"},
        {"--exposure", "1"},
        {"--tone", "agx"},
        {"--camera", "60,40"},
        {"--camera", "60,40,0.5"},
        {"--background", "plain"},
        {"--environment", "env.hdr"},
        {"--environment", "env.hdr", "--background", "plain"}};
    std::vector<std::string> pictures;
    for (const auto& way : ways) {
        std::vector<std::string> args = {"render", "g.json", "-o", "g.png", "--size", "16x16"};
        args.insert(args.end(), way.begin(), way.end());
        const Ran ran = run(args);
        ASSERT_EQ(ran.code, 0) << testing::PrintToString(way) << ran.err;
        for (const std::string& other : pictures)
            EXPECT_NE(get("g.png"), other) << testing::PrintToString(way);
        pictures.push_back(get("g.png"));
    }
}

TEST_F(LightingOptionsTest, RefuseWrongUsageAndBadPictures) {
    put("g.json", tilt_graph());
    put("env.hdr", "no picture");
    const auto code = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"render", "g.json", "-o", "g.png", "--size", "8x8"});
        return run(more).code;
    };
    EXPECT_EQ(code({"--lighting", "lambert"}), 2);
    EXPECT_EQ(code({"--phong", "1,1,1,1"}), 2);
    EXPECT_EQ(code({"--lighting", "phong", "--phong", "1,1,1"}), 2);
    EXPECT_EQ(code({"--lighting", "phong", "--phong", "1,1,1,nan"}), 2);
    EXPECT_EQ(code({"--lighting", "phong", "--environment", "env.hdr"}), 2);
    EXPECT_EQ(code({"--view", "normal", "--environment", "env.hdr"}), 2);
    EXPECT_EQ(code({"--light", "sun", "--environment", "env.hdr"}), 2);
    EXPECT_EQ(code({"--environment", "env.hdr"}), 1);
    EXPECT_EQ(code({"--environment", "none.exr"}), 1);
    ASSERT_EQ(run({"render", "g.json", "-o", "eight.png", "--size", "8x4"}).code, 0);
    const Ran eight = run({"render", "g.json", "-o", "g.png", "--environment", "eight.png"});
    EXPECT_EQ(eight.code, 1);
    EXPECT_TRUE(says(eight.err, "holds u8 values, no radiance"));
    EXPECT_FALSE(exists("g.png"));
}

// A triangle that the camera sees from behind; its bump is a tilt along x.
TEST_F(MeshFileTest, ADoubleSidedGltfIsDrawnByTheRuleFlip) {
    const auto with = [&](const std::string& name, const std::string& material) {
        std::string text = gltf_of("back.bin");
        text.insert(text.find("\"attributes\""), "\"material\": 0, ");
        text.insert(text.size() - 1, ", \"materials\": [" + material + "]");
        put(name, text);
    };
    std::string clockwise = triangle_bytes();
    std::swap_ranges(clockwise.begin() + 12, clockwise.begin() + 24, clockwise.begin() + 24);
    put("back.bin", clockwise);
    with("both.gltf", R"({"doubleSided": true})");
    with("one.gltf", R"({"doubleSided": false})");
    const std::string graph = tilt_graph("0.75");
    put("free.json", graph);
    for (const std::string rule : {"mirror", "flip"})
        put(rule + ".json", R"({"back_faces": ")" + rule + "\", " + graph.substr(1));
    const auto drawn = [&](const std::string& file, const std::string& mesh, bool warned) {
        const Ran ran = run({"render", file + ".json", "-o", "p.png", "--mesh", mesh + ".gltf",
                             "--view", "normal", "--size", "32x32", "--background", "plain"});
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.err.find("doubleSided") != std::string::npos, warned) << file << ran.err;
        return get("p.png");
    };
    const std::string flip = drawn("flip", "both", false), mirror = drawn("mirror", "both", false);
    EXPECT_NE(flip, mirror);
    EXPECT_EQ(drawn("free", "both", true), flip);
    EXPECT_EQ(drawn("free", "one", false), mirror);
}

}  // namespace
}  // namespace wrinkle::test
