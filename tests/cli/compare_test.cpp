// Tests of wrinkle compare as a process: numbers, maps, limits and exit codes. The measures are
// tested in tests/report.
#include <cmath>

#include "cli/support.h"
#include "image/load.h"

namespace wrinkle::test {
namespace {

using Names = std::vector<std::string>;

const std::string vectors = WRINKLE_SOURCE_DIR "/tests/report/flip/";

class CompareTest : public CliTest {
protected:
    Ran compare(const Names& words, int code = 0) const {
        Names all = {"compare"};
        all.insert(all.end(), words.begin(), words.end());
        const Ran ran = run(all);
        EXPECT_EQ(ran.code, code) << testing::PrintToString(words) << ran.out << ran.err;
        return ran;
    }

    // Writes one row of pixels as 8 bits.
    void put_row(const std::string& name, const std::vector<int>& values) const {
        std::string bytes = "P6\n" + std::to_string(values.size() / 3) + " 1\n255\n";
        for (const int value : values)
            bytes += static_cast<char>(value);
        put(name, bytes);
    }

    void put_floats(const std::string& name, const std::vector<float>& values) const {
        std::string bytes = "PF\n" + std::to_string(values.size() / 3) + " 1\n-1.0\n";
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
        put(name, bytes);
    }

    Image image(const std::string& name) const {
        Diagnostics diagnostics;
        const auto loaded = load_image(folder / name, diagnostics);
        EXPECT_TRUE(loaded) << to_text(diagnostics);
        return loaded.value_or(make_image(1, 1, 3));
    }
};

TEST_F(CompareTest, PrintsTheNumbersOfFlip) {
    const Ran ran = compare({vectors + "torus_reference.png", vectors + "torus_shift_1px.png",
                             "--over", "0.1", "-o", "map.png"},
                            1);
    EXPECT_TRUE(says(ran.out, "flip: 256 x 256 pixels, 67.0206 pixels per degree"));
    EXPECT_TRUE(says(ran.out, "mean 0.04057"));
    EXPECT_TRUE(says(ran.out, "weighted median 0.1096"));
    EXPECT_TRUE(says(ran.out, "max 0.5449"));
    EXPECT_TRUE(says(ran.out, " at 9,130 from the top left"));
    EXPECT_TRUE(says(ran.out, "above 0.1  85"));
    EXPECT_TRUE(says(ran.out, "map.png: 0 to 1\n"));
    EXPECT_TRUE(says(ran.out, " pixels are above 0\n"));
    EXPECT_EQ(ran.err, "");
    const Image map = image("map.png");
    EXPECT_EQ(map.channels, 3U);
    EXPECT_EQ(std::lround(map.texel(0, 255)[2] * 255), 4);  // the first color of magma
    EXPECT_GT(map.texel(9, 125)[0], 0.6F);
}

TEST_F(CompareTest, EqualImagesAreTheSame) {
    for (const char* metric : {"flip", "degrees", "rms"}) {
        const std::string name = vectors + "normals_reference.png";
        const Ran ran = compare({name, name, "--metric", metric, "-o", "map.png"});
        EXPECT_TRUE(says(ran.out, "mean 0"));
        EXPECT_TRUE(ran.out.ends_with("\nsame\n")) << ran.out;
        EXPECT_TRUE(exists("map.png"));
    }
}

TEST_F(CompareTest, LimitsDecide) {
    put_row("a.ppm", {100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100});
    put_row("b.ppm", {104, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100});
    const Names images = {"a.ppm", "b.ppm", "--metric", "rms"};  // pixels 2, 0, 0, 0; mean 1
    const auto with = [&](const Names& more, int code) {
        Names words = images;
        words.insert(words.end(), more.begin(), more.end());
        return compare(words, code).out;
    };
    EXPECT_TRUE(says(with({}, 1), "mean 1 8-bit steps"));
    EXPECT_TRUE(with({"--max-mean", "1"}, 0).ends_with("same\n"));
    EXPECT_TRUE(
        says(with({"--max-mean", "0.999"}, 1), "different: the mean 1 is above --max-mean 0.999"));
    EXPECT_TRUE(with({"--max-pixel", "2"}, 0).ends_with("same\n"));
    EXPECT_TRUE(says(with({"--max-pixel", "1.5"}, 1), "pixel 0,0 with 2 is above --max-pixel 1.5"));
    EXPECT_TRUE(with({"--over", "1.5", "--max-over", "1"}, 0).ends_with("same\n"));
    EXPECT_TRUE(says(with({"--over", "1.5", "--max-over", "0"}, 1),
                     "1 pixels above 1.5 are more than --max-over 0"));
    EXPECT_TRUE(says(with({"--over", "1.5"}, 1), "above 1.5  1 pixels, 25 %"));
    EXPECT_TRUE(says(with({"--max-mean", "0", "--max-pixel", "0"}, 1), "; pixel 0,0 with 2"));
}

TEST_F(CompareTest, NormalsAreComparedInDegrees) {
    put_floats("up.pfm", {0.5F, 0.5F, 1});
    const auto tilted = static_cast<float>(0.5 + 0.5 * std::sin(M_PI / 6));
    put_floats("tilted.pfm", {tilted, 0.5F, static_cast<float>(0.5 + 0.5 * std::cos(M_PI / 6))});
    const Ran ran = compare(
        {"up.pfm", "tilted.pfm", "--metric", "degrees", "-o", "map.png", "--max-mean", "30.001"});
    EXPECT_TRUE(says(ran.out, "mean 30 degrees"));
    EXPECT_TRUE(says(ran.out, "map.png: 0 to 30 degrees"));
    EXPECT_TRUE(says(compare({"up.pfm", "tilted.pfm", "--metric", "degrees", "-o", "map.png",
                              "--scale", "60", "--max-mean", "29.999"},
                             1)
                         .out,
                     "map.png: 0 to 60 degrees"));
}

TEST_F(CompareTest, EightAndSixteenBitsAreCompared) {
    ASSERT_EQ(run({"convert", vectors + "normals_reference.png", "--from", "normal_gl", "--to",
                   "normal", "-o", "16.png", "--type", "u16"})
                  .code,
              0);
    ASSERT_EQ(run({"convert", "16.png", "--from", "normal_gl", "--to", "normal", "-o", "8.png",
                   "--type", "u8"})
                  .code,
              0);
    compare({"16.png", "8.png", "--metric", "degrees", "--max-mean", "0.3"});
    compare({"16.png", "8.png", "--metric", "degrees", "--max-mean", "0.01"}, 1);
}

TEST_F(CompareTest, FloatsAreComparedAtExposures) {
    const Names images = {vectors + "hdr_reference.pfm", vectors + "hdr_test.pfm"};
    Names words = images;
    words.insert(words.end(), {"-o", "map.exr", "--exposure-map", "exposures.png"});
    const Ran ran = compare(words, 1);
    EXPECT_TRUE(says(ran.out, "aces, 15 exposures from -10.7417 to 3.5962"));
    EXPECT_TRUE(says(ran.out, "mean 0.0459"));
    EXPECT_TRUE(says(ran.out, "exposures.png: -10.7417 to 3.5962"));
    const Image map = image("map.exr");
    EXPECT_EQ(map.source, PixelType::float32);
    EXPECT_NEAR(map.texel(70, 64 - 1 - 18)[0], 0.4172009, 5e-5);
    words = images;
    words.insert(words.end(), {"--tone", "hable", "--exposures", "0,1,2"});
    EXPECT_TRUE(says(compare(words, 1).out, "hable, 2 exposures from 0 to 1 EV"));
}

TEST_F(CompareTest, JsonHasTheNumbersAndTheVerdict) {
    const Ran ran = compare({vectors + "grey64.png", vectors + "grey64_dot.png", "--json", "--over",
                             "0.1", "--max-pixel", "0.3", "-o", "map.png"},
                            1);
    const json::Value root = parsed(ran.out);
    EXPECT_EQ(root.find("metric").as_string(), "flip");
    EXPECT_NEAR(root.find("mean").as_number(), 0.001050037, 2e-6);
    EXPECT_NEAR(root.find("max").as_number(), 0.3786781, 1.1e-4);
    EXPECT_EQ(root.find("max_at").at(0).as_number(), 20);
    EXPECT_EQ(root.find("max_at").at(1).as_number(), 30);
    EXPECT_EQ(root.find("over").find("count").as_number(), 13);
    EXPECT_EQ(root.find("percentiles").find("50").as_number(), 0);
    EXPECT_EQ(root.find("map").find("file").as_string(), "map.png");
    EXPECT_FALSE(root.find("same").as_boolean());
    EXPECT_EQ(root.find("exceeded").size(), 1U);
    EXPECT_TRUE(parsed(compare({vectors + "grey64.png", vectors + "grey64.png", "--json"}).out)
                    .find("same")
                    .as_boolean());
}

TEST_F(CompareTest, ImagesThatCannotBeComparedAreErrors) {
    put_row("one.ppm", {0, 0, 0});
    put_row("two.ppm", {0, 0, 0, 0, 0, 0});
    put("gray.pgm", "P5\n1 1\n255\nx");
    put("text.png", "no image");
    put_floats("nan.pfm", {0, NAN, 0});
    put_floats("infinite.pfm", {0, 0, INFINITY});
    put_floats("black.pfm", {0, 0, 0});
    EXPECT_TRUE(says(compare({"one.ppm", "two.ppm"}, 1).err,
                     "two.ppm: error: has 2 x 1 pixels, one.ppm has 1 x 1"));
    EXPECT_TRUE(says(compare({"one.ppm", "missing.png"}, 1).err, "missing.png"));
    EXPECT_TRUE(says(compare({"text.png", "one.ppm"}, 1).err, "text.png"));
    for (const char* name : {"nan.pfm", "infinite.pfm"}) {
        for (const Names& words : {Names{name, "black.pfm"}, Names{"black.pfm", name}}) {
            const Ran ran = compare(words, 1);
            EXPECT_TRUE(says(ran.err, name));
            EXPECT_TRUE(says(ran.err, "error: "));
            EXPECT_TRUE(says(ran.err, "1 values that are NaN or infinite"));
            EXPECT_EQ(ran.out, "");
        }
    }
    EXPECT_TRUE(says(compare({"gray.pgm", "one.ppm", "--metric", "degrees"}, 1).err,
                     "gray.pgm: error: is a gray image"));
    EXPECT_EQ(files().size(), 7U);
}

TEST_F(CompareTest, WrongUsageIsTwo) {
    put_row("a.ppm", {0, 0, 0});
    for (const Names& more :
         {Names{"--metric", "psnr"}, Names{"--ppd", "0"}, Names{"--ppd", "nan"},
          Names{"--max-mean", "-1"}, Names{"--max-mean", "nan"}, Names{"--max-over", "3"},
          Names{"--tone", "aces"}, Names{"--exposures", "0,1,2"}, Names{"--scale", "0"},
          Names{"-o", "map.xyz"}, Names{"-o", "-"}, Names{"-o", "a.ppm"}}) {
        Names words = {"a.ppm", "a.ppm"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(compare(words, 2).out, "");
    }
    put_floats("a.pfm", {0, 0, 0});
    for (const char* exposures : {"0,1", "0,1,0", "0,1,33", "0,1,1.5", "nan,1,2", "0,1000,2"})
        EXPECT_TRUE(
            says(compare({"a.pfm", "a.pfm", "--exposures", exposures}, 2).err, "START,STOP,COUNT"));
    compare({"a.pfm", "a.pfm", "--metric", "rms", "--tone", "aces"}, 2);
}

TEST_F(CompareTest, AMapThatCannotBeWrittenIsThree) {
    put_row("a.ppm", {0, 0, 0});
    EXPECT_TRUE(says(compare({"a.ppm", "a.ppm", "-o", "none/map.png"}, 3).err, "none/"));
}

}  // namespace
}  // namespace wrinkle::test
