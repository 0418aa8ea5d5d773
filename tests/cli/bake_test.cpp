// Tests of wrinkle bake: output files, their contents, and the errors of invalid input.
#include <cmath>
#include <cstdio>

#include "cli/bake_support.h"
#include "support/angle.h"

namespace wrinkle::test {
namespace {

// An OBJ file of a quad of two triangles with these uvs.
std::string square(const std::string& uvs) {
    return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + uvs + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
}
const std::string whole_uvs = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

TEST_F(BakeTest, OneMapIsAFileOfTheUsualSize) {
    const Ran ran = bake("sphere", "out/normal.png");
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out + ran.err, "");
    EXPECT_EQ(files(), (Names{"out", "out/normal.png"}));
    const Image image = picture("out/normal.png");
    EXPECT_EQ(image.width, 1024U);
    EXPECT_EQ(image.height, 1024U);
    EXPECT_EQ(image.channels, 3U);
    EXPECT_EQ(image.source, PixelType::u8);
}

TEST_F(BakeTest, SeveralMapsAreAFolder) {
    const Ran ran = bake("torus", "maps",
                         {"--map", "normal,height,slopes", "--pack", "rh: r=roughness g=height",
                          "--size", "64x32", "--scale", "8"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(files(), (Names{"maps", "maps/height.png", "maps/normal.png", "maps/rh.png",
                              "maps/slopes.exr"}));
    const Image height = picture("maps/height.png"), packed = picture("maps/rh.png");
    EXPECT_EQ(height.width, 64U);
    EXPECT_EQ(height.height, 32U);
    EXPECT_EQ(height.channels, 1U);
    EXPECT_EQ(packed.texel(9, 9)[1], height.texel(9, 9)[0]);
    ASSERT_EQ(bake("torus", "deep",
                   {"--map", "normal,height", "--type", "u16", "--format", "tif", "--size", "16",
                    "--tile", "16", "--compression", "lzw"})
                  .code,
              0);
    EXPECT_EQ(picture("deep/normal.tif").source, PixelType::u16);
}

// The baked texels equal the results of `wrinkle eval` at texel centres, in object space.
TEST_F(BakeTest, TexelsAreWhatEvalSays) {
    ASSERT_EQ(bake("teapot", "maps",
                   {"--map", "normal,roughness", "--space", "object", "--type", "float", "--size",
                    "128", "--dilate", "0", "--samples", "1"})
                  .code,
              0);
    const Image normal = picture("maps/normal.exr"), roughness = picture("maps/roughness.exr");
    size_t compared = 0;
    for (uint32_t y = 1; y < 128; y += 17)
        for (uint32_t x = 3; x < 128; x += 31) {
            char uv[40];  // exact: the size is a power of two
            std::snprintf(uv, sizeof uv, "%.10f,%.10f", (x + 0.5) / 128, (y + 0.5) / 128);
            const Ran ran = run({"eval", graph, "--mesh", "teapot", "--uv", uv, "--size", "128"});
            const float* texel = normal.texel(x, y);
            if (ran.code == 1) {  // no triangle at this uv
                EXPECT_EQ(texel[2], 0.5F) << uv;
                continue;
            }
            ++compared;
            const json::Value point = parsed(ran.out).find("points").at(0);
            for (size_t i = 0; i < 3; ++i)
                EXPECT_NEAR(2 * texel[i] - 1, point.find("normal").at(i).as_number(), 3e-7) << uv;
            EXPECT_EQ(roughness.texel(x, y)[0],
                      static_cast<float>(point.find("roughness").as_number()));
        }
    EXPECT_GT(compared, 20U);
}

// A graph that reads a baked map has the normals of the graph that was baked.
TEST_F(BakeTest, AGraphThatReadsTheMapHasTheSameNormals) {
    for (const Names& more : {Names{}, Names{"--dx"}, Names{"--no-tangents"}}) {
        Names wide = more;
        wide.insert(wide.end(), {"--type", "u16", "--size", "512"});
        ASSERT_EQ(bake("torus", "map.png", wide).code, 0);
        const bool down = !more.empty() && more[0] == "--dx";
        const Names frame = !more.empty() && !down ? more : Names{};
        put("reader.json", R"({"wrinkle": 1, "nodes": {
          "map": {"type": "tangent_normal_map", "in": {"image": {"file": "map.png",
            "encoding": ")" + std::string(down ? "normal_dx" : "normal_gl") +
                               R"(", "filter": "nearest"}}},
          "end": {"type": "resolve", "in": {"gradient": {"from": "map.gradient"}}}},
          "outputs": {"normal": {"from": "end.normal"}}})");
        Names object = frame;
        object.insert(object.end(), {"--space", "object", "--type", "float", "--size", "512"});
        ASSERT_EQ(bake("torus", "expected.exr", object).code, 0);
        object.insert(object.begin(), {"bake", "reader.json", "--mesh", "torus", "-o", "got.exr"});
        const Ran ran = run(object);
        ASSERT_EQ(ran.code, 0) << ran.err;
        const Image expected = picture("expected.exr"), got = picture("got.exr");
        double most = 0;
        for (size_t i = 0; i < expected.data.size(); i += 3) {
            const auto decoded = [&](const Image& image) {
                return std::array<double, 3>{2.0 * image.data[i] - 1, 2.0 * image.data[i + 1] - 1,
                                             2.0 * image.data[i + 2] - 1};
            };
            most = std::max(most, angle_deg(decoded(expected), decoded(got)));
        }
        EXPECT_LT(most, 0.1) << testing::PrintToString(more);
    }
}

TEST_F(BakeTest, SweepsAndUdimTilesAreNumbered) {
    put("square.obj", square("vt 0.5 0.2\nvt 1.5 0.2\nvt 1.5 0.7\nvt 0.5 0.7\n"));
    put("g.json", tilt_graph());
    graph = "g.json";
    const Ran ran =
        bake("square.obj", "n.png", {"--udim", "--size", "16", "--set", "tilt.volume=[1, 0, 0]"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(exists("n.1001.png") && exists("n.1002.png") && !exists("n.png"));
    // Each image has its half; dilation does not leave its UDIM tile.
    const Image left = picture("n.1001.png"), right = picture("n.1002.png");
    for (uint32_t x = 0; x < 16; ++x) {
        EXPECT_EQ(left.texel(x, 5)[0], left.texel(15, 5)[0]);
        EXPECT_EQ(right.texel(x, 5)[0], left.texel(15, 5)[0]);
    }
    ASSERT_EQ(bake("sphere", "r.png",
                   {"--size", "8", "--map", "normal", "--set",
                    "end.gradient={\"from\": \"tilt.gradient\"}"})
                  .code,
              1);
    put("ramp.json", ramp_graph());
    graph = "ramp.json";
    const Ran swept =
        bake("plane", "v.exr", {"--size", "8", "--map", "value", "--set", "scaled.b=1:3:3"});
    ASSERT_EQ(swept.code, 0) << swept.err;
    const float first = picture("v.000.exr").texel(3, 3)[0];
    EXPECT_EQ(picture("v.002.exr").texel(3, 3)[0], 3 * first);
    EXPECT_TRUE(exists("v.001.exr"));
}

TEST_F(BakeTest, TellsOfUvsThatOverlapAreMirroredOrLieOutside) {
    put("g.json", tilt_graph());
    graph = "g.json";
    const auto said = [&](const std::string& uvs, const Names& more = {}) {
        put("m.obj", square(uvs));
        Names all = more;
        all.insert(all.end(), {"--size", "32"});
        const Ran ran = bake("m.obj", "m.png", all);
        EXPECT_EQ(ran.code, 0) << ran.err;
        return ran.err;
    };
    EXPECT_EQ(said(whole_uvs), "");
    const std::string mirrored = said("vt 1 0\nvt 0 0\nvt 0 1\nvt 1 1\n");
    EXPECT_TRUE(says(mirrored, "m.obj: warning: 2 of 2 triangles are mirrored in uv"));
    const std::string overlapping = said("vt 0 0\nvt 1 0\nvt 1 1\nvt 1 0\n");
    EXPECT_TRUE(says(overlapping, "texels are covered by more than one triangle; at uv "));
    EXPECT_TRUE(says(overlapping, "triangle 1 is hidden by one before it"));
    EXPECT_TRUE(
        says(said("vt 0 0\nvt 1 0\nvt 1 1\nvt 0 0\n"), "1 of 2 triangles have no area in uv"));
    const std::string outside = "vt 2 0\nvt 3 0\nvt 0 1\nvt 0 0\n";
    put("far.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 5 5 5\nvt 0 0\nvt 1 0\nvt 1 1\nvt 3 1\nvt 4 1\nvt 4 2\n"
        "f 1/1 2/2 3/3\nf 1/4 2/5 4/6\n");
    const Ran far = bake("far.obj", "m.png", {"--size", "32"});
    EXPECT_TRUE(says(far.err, "1 of 2 triangles lie outside of the uv square"));
    EXPECT_TRUE(says(far.err, "--udim"));
}

TEST_F(BakeTest, WarnsOfMapsThatDependOnTheView) {
    put("view.json", R"({"wrinkle": 1, "nodes": {"rim": {"type": "fresnel"},
        "uv": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
        "tint": {"type": "ramp", "in": {"factor": {"from": "rim.value"}}}},
        "outputs": {"color": {"from": "tint.color"}, "roughness": {"from": "rim.value"},
                    "metalness": {"from": "uv.x"}}})");
    const auto warned = [&](std::vector<std::string> more) {
        std::vector<std::string> args = {"bake", "view.json", "--mesh", "sphere", "--size", "16"};
        args.insert(args.end(), more.begin(), more.end());
        const Ran ran = run(args);
        EXPECT_EQ(ran.code, 0) << ran.err;
        return ran.err;
    };
    const std::string seen = " (each texel is baked as seen along its normal)\n";
    EXPECT_EQ(warned({"--map", "color,metalness,roughness", "-o", "maps"}),
              "view.json: warning: view-dependent maps: 'color', 'roughness'" + seen);
    EXPECT_EQ(warned({"--map", "metalness", "-o", "m.png"}), "");
    EXPECT_EQ(warned({"--pack", "orm: r=metalness g=roughness", "--set", "rim.ior=1.2:2:3", "-o",
                      "p.png"}),
              "view.json: warning: view-dependent maps: 'orm'" + seen);
    // Fresnel's formula along the normal: ((1.5 - 1) / 2.5)^2.
    EXPECT_NEAR(picture("maps/roughness.png").texel(8, 8)[0], 0.04, 0.003);
}

TEST_F(BakeTest, RefusesMeshesThatCannotBeBaked) {
    put("bare.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    put("point.obj", square("vt 0.5 0.5\nvt 0.5 0.5\nvt 0.5 0.5\nvt 0.5 0.5\n"));
    put("away.obj", square("vt 5 5\nvt 7 5\nvt 7 6\nvt 5 6\n"));
    put("g.json", R"({"wrinkle": 1, "nodes": {"c": {"type": "combine_vec3"}},
                      "outputs": {"tint": {"from": "surface.color0"}}})");
    const auto refused = [&](const std::string& mesh, const Names& more = {}) {
        const Ran ran = bake(mesh, "m.png", more);
        EXPECT_EQ(ran.code, 1) << mesh;
        EXPECT_FALSE(exists("m.png"));
        return ran.err;
    };
    EXPECT_TRUE(says(refused("bare.obj"), "bare.obj: error: the mesh has no uvs (set 0)"));
    EXPECT_TRUE(says(refused("point.obj"), "no triangle has an area in uv"));
    EXPECT_TRUE(says(refused("away.obj"), "no triangle lies in the uv square"));
    EXPECT_TRUE(says(refused("missing.obj"), "missing.obj"));
    graph = "g.json";
    EXPECT_TRUE(says(refused("away.obj", {"--map", "tint", "--udim"}), "the mesh lacks 'color0'"));
    EXPECT_TRUE(says(refused("sphere", {"--map", "normal"}), "makes no map 'normal'"));
}

TEST_F(BakeTest, WrongUsageIsSaidBeforeAnyWork) {
    const auto wrong = [&](const Names& more, const std::string& out = "m.png") {
        const Ran ran = bake("sphere", out, more);
        EXPECT_EQ(ran.code, 2) << testing::PrintToString(more);
        EXPECT_EQ(files(), Names{});
        return ran.err;
    };
    EXPECT_TRUE(says(wrong({"--gl", "--dx"}), "two ways of green"));
    EXPECT_TRUE(says(wrong({"--size", "0"}), "--size 0 is not a size"));
    wrong({"--size", "12x"});
    wrong({"--samples", "3"});
    wrong({"--dilate", "5000"});
    EXPECT_TRUE(says(wrong({"--shard", "3/2"}), "2/8, the second of eight"));
    EXPECT_TRUE(says(wrong({"--scale", "0"}), "greater than 0"));
    EXPECT_TRUE(says(wrong({"--pack", "r"}), "names no channels"));
    EXPECT_TRUE(says(wrong({"--map", "normal,normal"}), "two maps would be called 'normal'"));
    EXPECT_TRUE(says(wrong({"--map", "/etc/x"}), "cannot be the name of a map's file"));
    wrong({"--map", "normal,"});
    EXPECT_TRUE(says(wrong({"-MF", "x.d"}), "go with -MD"));
    EXPECT_TRUE(says(wrong({"--type", "half"}), "cannot hold values of type half"));
    EXPECT_TRUE(says(wrong({}, "m.bmp"), "m.bmp does not end in the extension of an image format"));
    const std::string folder_name = wrong({"--map", "normal"}, "maps");
    EXPECT_TRUE(says(folder_name, "maps has no extension to choose the format by"));
    EXPECT_TRUE(says(folder_name, "maps.png")) << "the file of one map";
    wrong({"--tile", "64"});
    EXPECT_EQ(run({"bake", graph, "-o", "m.png"}).code, 2);
    EXPECT_EQ(run({"bake", "--merge", "a", "--mesh", "cube", "-o", "m.png"}).code, 2);
}

// Only texels that an island's border crosses are supersampled; every other texel has the value at
// its centre, so baking a map that only reads an image of the same size reproduces the image.
TEST_F(BakeTest, SamplesChangeTheBordersOfIslandsAlone) {
    const Image source = picture(WRINKLE_SOURCE_DIR "/graphs/textures/rivets_normal.png");
    fs::copy_file(WRINKLE_SOURCE_DIR "/graphs/textures/rivets_normal.png", folder / "r.png");
    put("g.json", R"({"wrinkle": 1, "nodes": {
        "m": {"type": "tangent_normal_map", "in": {"image": "r.png"}},
        "e": {"type": "resolve", "in": {"gradient": {"from": "m.gradient"}}},
        "one": {"type": "add", "in": {"a": 1, "b": 0}}},
        "outputs": {"normal": {"from": "e.normal"}, "covered": {"from": "one.result"}}})");
    graph = "g.json";
    const std::string size = std::to_string(source.width) + "x" + std::to_string(source.height);
    const auto baked = [&](const std::string& samples) {
        const Ran ran = bake(
            "teapot", "s" + samples,
            {"--map", "normal,covered", "--size", size, "--dilate", "0", "--samples", samples});
        EXPECT_EQ(ran.code, 0) << ran.err;
        return picture("s" + samples + "/normal.png");
    };
    const Image once = baked("1"), mean = baked("4"), covered = picture("s1/covered.png");
    const auto difference = [&](const Image& a, const Image& b, uint32_t x, uint32_t y) {
        float most = 0;
        for (uint32_t c = 0; c < 3; ++c)
            most = std::fmax(most, std::fabs(a.texel(x, y)[c] - b.texel(x, y)[c]) * 255);
        return most;
    };
    size_t inside = 0, changed = 0;
    for (uint32_t y = 1; y + 1 < source.height; ++y)
        for (uint32_t x = 1; x + 1 < source.width; ++x) {
            if (covered.texel(x, y)[0] == 0) continue;
            EXPECT_LT(difference(once, source, x, y), 1.01) << x << " " << y;
            bool around = true;
            for (uint32_t k = 0; k < 9; ++k)
                around = around && covered.texel(x + k % 3 - 1, y + k / 3 - 1)[0] == 1;
            inside += around;
            EXPECT_TRUE(!around || difference(once, mean, x, y) == 0) << x << " " << y;
            changed += difference(once, mean, x, y) > 1.01;
        }
    EXPECT_GT(inside, 10000U);
    EXPECT_GT(changed, 10U) << "at borders the mean is another number";
}

TEST_F(BakeTest, IntegersThatCannotHoldAMapAreToldOf) {
    const Ran ran = bake("sphere", "h.png", {"--map", "height", "--size", "32"});
    EXPECT_EQ(ran.code, 0);
    EXPECT_TRUE(says(ran.err, "numbers that integers do not"));
    EXPECT_EQ(bake("sphere", "h.exr", {"--map", "height", "--size", "32"}).err, "");
}

TEST_F(BakeTest, AFullDiskLeavesWhatWasThere) {
    put("maps/normal.png", "mine");
    file_size = 4096;
    const Ran ran = bake("sphere", "maps", {"--map", "normal,roughness", "--size", "256"});
    EXPECT_EQ(ran.code, 3);
    EXPECT_TRUE(says(ran.err, "cannot be written"));
    EXPECT_EQ(files(), (Names{"maps", "maps/normal.png"}));
    EXPECT_EQ(get("maps/normal.png"), "mine");
    const Ran part = bake("sphere", "part", {"--size", "256", "--shard", "1/2"});
    EXPECT_EQ(part.code, 3);
    EXPECT_TRUE(
        says(part.err,
             "part/0-0.rows: error: rows of the map 'normal' cannot be written: File too large"));
}

}  // namespace
}  // namespace wrinkle::test
