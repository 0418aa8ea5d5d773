// Tests of wrinkle import as a process: the graph that it writes evaluates to the values in the
// images, and bad inputs are errors with a remedy.
#include <cmath>

#include "cli/support.h"
#include "image/load.h"

namespace wrinkle::test {
namespace {

using Names = std::vector<std::string>;

class Import : public CliTest {
protected:
    // A file of one color of 8 bits.
    void put_image(const std::string& name, const std::vector<int>& texel) const {
        Image image = make_image(4, 4, static_cast<uint32_t>(texel.size()));
        for (size_t i = 0; i < image.data.size(); ++i)
            image.data[i] = static_cast<float>(texel[i % texel.size()]) / 255;
        save(image, name, PixelType::u8);
    }
    // A wave along both axes; `green_down` inverts green. Its slopes per texel are the normal's.
    void put_normal(const std::string& name, bool green_down) const {
        Image image = make_image(64, 64, 3);
        for (uint32_t y = 0; y < 64; ++y)
            for (uint32_t x = 0; x < 64; ++x) {
                const double angle = 2 * 3.14159265358979 * (x + 2.0 * y) / 64;
                const double du = 0.3 * std::cos(angle), dv = 0.6 * std::cos(angle);
                const double length = std::sqrt(1 + du * du + dv * dv);
                const double n[] = {-du / length, (green_down ? dv : -dv) / length, 1 / length};
                for (size_t c = 0; c < 3; ++c)
                    image.texel(x, y)[c] = static_cast<float>((1 + n[c]) / 2);
            }
        save(image, name, PixelType::u16);
    }
    void save(const Image& image, const std::string& name, PixelType type) const {
        fs::create_directories((folder / name).parent_path());
        Diagnostics problems;
        WriterOptions options;
        options.type = type;
        EXPECT_TRUE(save_image(image, folder / name, options, problems)) << to_text(problems);
    }

    // Imports without messages.
    void imported(const Names& words) const {
        const Ran ran = import(words);
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.err, "");
        EXPECT_EQ(ran.out, "");
    }
    Ran import(const Names& words) const {
        Names all = {"import"};
        all.insert(all.end(), words.begin(), words.end());
        return run(all);
    }
    // Output values of a graph at a texel of the 64 x 64 images.
    json::Value values(const std::string& graph, double x = 5, double y = 9,
                       const Names& more = {}) const {
        const std::string at = R"({"normal": [0, 0, 1], "tangent": [1, 0, 0, 1], "uv0": [)" +
                               std::to_string((x + 0.5) / 64) + ", " +
                               std::to_string((y + 0.5) / 64) +
                               R"(], "position": [0, 0, 0], "dx": {"position": [1, 0, 0], "uv0": )"
                               R"([1e-4, 0]}, "dy": {"position": [0, 1, 0], "uv0": [0, 1e-4]}})";
        Names all = {"eval", graph, "--at", at};
        all.insert(all.end(), more.begin(), more.end());
        const Ran ran = run(all);
        EXPECT_EQ(ran.code, 0) << ran.err;
        return parsed(ran.out).find("points").at(0);
    }
    static void expect_value(const json::Value& point, const char* output, double expected) {
        ASSERT_TRUE(point.has(output)) << output;
        EXPECT_NEAR(point.find(output).as_number(), expected, 1e-5) << output;
    }
};

double linear_of(int value) {
    const double t = value / 255.0;
    return t <= 0.04045 ? t / 12.92 : std::pow((t + 0.055) / 1.055, 2.4);
}

TEST_F(Import, ValuesAreThoseOfTheImages) {
    put_image("set/brick_Color.png", {200, 100, 50});
    put_image("set/brick_Roughness.png", {80});
    put_image("set/brick_Metalness.png", {30});
    put_image("set/brick_AmbientOcclusion.png", {220});
    put_image("set/brick_Opacity.png", {190});
    put_image("set/brick_Emission.png", {10, 20, 30});
    put_image("set/brick_Displacement.png", {255});
    imported({"set", "-o", "set/g.json"});
    const json::Value point = values("set/g.json");
    const int color[] = {200, 100, 50}, emission[] = {10, 20, 30};
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(point.find("color").at(i).as_number(), linear_of(color[i]), 1e-4);
        EXPECT_NEAR(point.find("emission").at(i).as_number(), linear_of(emission[i]), 1e-4);
    }
    expect_value(point, "roughness", 80 / 255.0);
    expect_value(point, "metalness", 30 / 255.0);
    expect_value(point, "occlusion", 220 / 255.0);
    expect_value(point, "opacity", 190 / 255.0);
    expect_value(point, "height", 0.5 * 0.02);  // white over the middle, of one repeat of length 1
    EXPECT_EQ(run({"check", "set/g.json"}).err, "");
    EXPECT_EQ(run({"format", "--check", "set/g.json"}).code, 0);
}

TEST_F(Import, ColorsOfFloatFilesAreLinear) {
    Image image = make_image(4, 4, 3);
    std::fill(image.data.begin(), image.data.end(), 0.25F);
    save(image, "a_color.exr", PixelType::half);
    imported({"a_color.exr", "-o", "g.json"});
    EXPECT_NEAR(values("g.json").find("color").at(0).as_number(), 0.25, 1e-6);
}

TEST_F(Import, PackedChannelsGoToTheirOutputs) {
    struct Row {
        const char* name;
        double occlusion, roughness,
            metalness;  // the image has red 10, green 60, blue 110, alpha 200; -1: none
    };
    const Row rows[] = {{"a_ORM.png", 10, 60, 110},
                        {"a_arm_1k.png", 10, 60, 110},
                        {"a_RMA.png", 110, 10, 60},
                        {"a_MRA.png", 110, 60, 10},
                        {"a_metallicRoughness.png", -1, 60, 110},
                        {"a_MaskMap.png", 60, 55, 10},
                        {"a_MetallicSmoothness.png", -1, 55, 10}};
    for (const Row& row : rows) {
        put_image(row.name, {10, 60, 110, 200});
        imported({row.name, "-o", "g.json"});
        const json::Value point = values("g.json");
        expect_value(point, "roughness", row.roughness / 255);
        expect_value(point, "metalness", row.metalness / 255);
        EXPECT_EQ(point.has("occlusion"), row.occlusion >= 0) << row.name;
        if (row.occlusion >= 0) expect_value(point, "occlusion", row.occlusion / 255);
    }
}

TEST_F(Import, GlossIsOneLessRoughnessAndTheInputScalesIt) {
    put_image("a_gloss.png", {155});
    imported({"a_gloss.png", "-o", "g.json"});
    expect_value(values("g.json"), "roughness", 100 / 255.0);
    expect_value(values("g.json", 0, 0, {"--set", "input.roughness=2"}), "roughness", 200 / 255.0);
    expect_value(values("g.json", 0, 0, {"--set", "input.roughness=9"}), "roughness", 1);
}

// The same bump in both directions of green gives one normal: that of the slopes of the wave.
TEST_F(Import, NormalsAreThoseOfTheBumpInBothDirectionsOfGreen) {
    put_normal("up/a_normal.png", false);
    put_normal("down/a_normal.png", true);
    put_normal("named/a_normal_dx.png", true);
    imported({"up", "-o", "up/g.json"});
    imported({"named", "-o", "named/g.json"});
    const Ran down = import({"down", "-o", "down/g.json"});
    EXPECT_EQ(down.code, 0);
    EXPECT_TRUE(says(down.err,
                     "down/a_normal.png: warning: is read with green down, by its "
                     "slopes (--green gl (up) or dx (down) states it)"));
    for (const char* name : {"up", "down", "named"}) {
        const std::string graph = std::string(name) + "/g.json";
        const double cosine = std::cos(2 * 3.14159265358979 * (5 + 2 * 9) / 64);
        const double length = std::hypot(0.3 * cosine, 0.6 * cosine, 1);
        const json::Value normal = values(graph).find("normal");
        EXPECT_NEAR(normal.at(0).as_number(), -0.3 * cosine / length, 1e-4) << name;
        EXPECT_NEAR(normal.at(1).as_number(), -0.6 * cosine / length, 1e-4) << name;
        EXPECT_NEAR(values(graph, 5, 9, {"--set", "input.bump=0"}).find("normal").at(2).as_number(),
                    1, 1e-6);
    }
    imported({"down", "-o", "asked.json", "--green", "dx"});
    EXPECT_EQ(import({"down", "-o", "wrong.json", "--green", "up"}).code, 2);
}

TEST_F(Import, TilingRepeatsTheTextures) {
    put_normal("a_normal_gl.png", false);
    imported({"a_normal_gl.png", "-o", "g.json"});
    const json::Value once = values("g.json", 10.5, 18.5).find("normal");
    const json::Value twice =
        values("g.json", 5, 9, {"--set", "input.tiling=[2,2]"}).find("normal");
    EXPECT_NEAR(once.at(0).as_number(), twice.at(0).as_number(), 1e-5);
    EXPECT_GT(std::abs(once.at(0).as_number() - values("g.json").find("normal").at(0).as_number()),
              0.05);
}

// A plane of side 2 has 2 length units per uv unit: a texel of 0.01 of an image 4 wide repeats 50
// times.
TEST_F(Import, TheMeshGivesTheSizeOfATexel) {
    put_image("a_height.png", {255});
    imported({"--texel", "0.01,0.01", "a_height.png", "-o", "g.json", "--mesh", "plane"});
    EXPECT_TRUE(says(get("g.json"), "\"default\": [50, 50]"));
    imported({"a_height.png", "-o", "g.json", "--mesh", "plane"});
    EXPECT_TRUE(says(get("g.json"), "\"default\": 0.04,"));
    imported({"a_height.png", "-o", "g.json", "--height", "0.3"});
    EXPECT_TRUE(says(get("g.json"), "\"default\": 0.3,"));
    put("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Ran ran = import({"a_height.png", "-o", "new.json", "--mesh", "./bare.obj"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "./bare.obj: error: has no uv, so no size of a texel"));
    EXPECT_FALSE(exists("new.json"));
}

TEST_F(Import, EqualInputsGiveEqualBytesAndPathsAreRelativeToTheGraph) {
    put_image("assets/tex/a_color.png", {1, 2, 3});
    put_image("assets/tex/a_orm.png", {1, 2, 3});
    imported({"assets/tex", "-o", "assets/g.json"});
    imported({"assets/tex/a_orm.png", "assets/tex/a_color.png", "-o", "assets/h.json"});
    EXPECT_EQ(get("assets/g.json"), get("assets/h.json"));
    EXPECT_TRUE(says(get("assets/g.json"), "\"tex/a_color.png\""));
    EXPECT_EQ(files(), (Names{"assets", "assets/g.json", "assets/h.json", "assets/tex",
                              "assets/tex/a_color.png", "assets/tex/a_orm.png"}));
    const Ran printed = import({(folder / "assets/tex").string(), "-o", "-"});
    EXPECT_EQ(printed.code, 0) << printed.err;
    EXPECT_TRUE(says(printed.out, "\"assets/tex/a_color.png\""));
}

TEST_F(Import, ImagesOutsideTheRootAreRefused) {
    put_image("tex/a_color.png", {1, 2, 3});
    fs::create_directory(folder / "graphs");
    const Ran ran = import({"tex", "-o", "graphs/g.json"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "tex/a_color.png: error: is not below " +
                                  (folder / "graphs").string() + ", where the graph reads files"));
    EXPECT_FALSE(exists("graphs/g.json"));
    imported({"tex", "-o", "graphs/g.json", "--root", "."});
    EXPECT_TRUE(says(get("graphs/g.json"), "\"../tex/a_color.png\""));
    EXPECT_EQ(run({"check", "graphs/g.json", "--root", "."}).code, 0);
}

TEST_F(Import, NothingIsReplacedThatIsReadAndAFailureWritesNothing) {
    put_image("a_color.png", {1, 2, 3});
    const std::string bytes = get("a_color.png");
    const Ran ran = import({".", "-o", "a_color.png"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "would replace the input"));
    EXPECT_EQ(get("a_color.png"), bytes);
    put("g.json", "old");
    put("a_rough.png", "no image");
    EXPECT_EQ(import({".", "-o", "g.json"}).code, 1);
    EXPECT_EQ(get("g.json"), "old");
    fs::remove(folder / "a_rough.png");
    imported({".", "-o", "g.json"});
    EXPECT_NE(get("g.json"), "old");
    EXPECT_EQ(import({".", "-o", "missing/g.json", "--root", "."}).code, 3);
}

TEST_F(Import, BadInputsAreErrors) {
    fs::create_directory(folder / "empty");
    put_image("a_color.png", {1, 2, 3});
    const std::pair<Names, int> rows[] = {
        {{"empty", "-o", "g.json"}, 1},
        {{"missing", "-o", "g.json"}, 1},
        {{".", "-o", "empty"}, 2},
        {{".", "-o", "g.json", "--texel", "0"}, 2},
        {{".", "-o", "g.json", "--texel", "nan"}, 2},
        {{".", "-o", "g.json", "--texel", "1e300"}, 2},
        {{".", "-o", "g.json", "--texel", "1,2,3"}, 2},
        {{".", "-o", "g.json", "--height", "inf"}, 2},
        {{".", "-o", "g.json", "--mesh", "spher"}, 2},
        {{"."}, 2},
        {{"-o", "g.json"}, 2},
    };
    for (const auto& [words, code] : rows) {
        const Ran ran = import(words);
        EXPECT_EQ(ran.code, code) << testing::PrintToString(words) << ran.err;
        EXPECT_NE(ran.err, "");
        EXPECT_FALSE(exists("g.json"));
    }
    const Ran ran = import({"empty", "-o", "g.json", "--diagnostics", "json"});
    EXPECT_EQ(parsed(ran.err).find("diagnostics").at(0).find("message").as_string(),
              "holds no image");
}

TEST_F(Import, NamesWithOddCharactersAreReadAgain) {
    for (const std::string name :
         {"Öl & \"Wand\" (1)", "a'b\\c", " spaces ", "new\nline", "-x", "@x"}) {
        put_image(name + "/" + name + "_color.png", {200, 100, 50});
        imported({"./" + name, "-o", "./" + name + "/g.json"});
        EXPECT_NEAR(values("./" + name + "/g.json").find("color").at(0).as_number(), linear_of(200),
                    1e-4)
            << name;
    }
    put_image("bad\xFF/a\xFF_color.png", {200, 100, 50});
    const Ran ran = import({"bad\xFF", "-o", "bad\xFF/g.json"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "a\\xff_color.png: error: is not named in UTF-8"));
}

}  // namespace
}  // namespace wrinkle::test
