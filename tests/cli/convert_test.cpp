// Tests of wrinkle convert and wrinkle lint as processes. The oracle of slopes is OpenImageIO's
// maketx, which always clamps; its result for a map that repeats is the middle of nine copies.
#include <cmath>
#include <cstdlib>

#include "cli/support.h"
#include "image/load.h"
#include "image/mips.h"

namespace wrinkle::test {
namespace {

using Names = std::vector<std::string>;

class Convert : public CliTest {
protected:
    // Writes `times` x `times` copies of a bump that does not repeat, as floats.
    void put_height(const std::string& name, int width, int height, int times = 1) const {
        std::string bytes = "Pf\n" + std::to_string(width * times) + " " +
                            std::to_string(height * times) + "\n-1.0\n";
        for (int y = 0; y < height * times; ++y)
            for (int x = 0; x < width * times; ++x) {
                const int i = x % width, j = y % height;
                const auto value = static_cast<float>(std::sin(0.25 * i + 0.15 * j) +
                                                      0.02 * j * std::cos(0.2 * j - 0.1 * i));
                bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
            }
        put(name, bytes);
    }

    void shell(const std::string& command) const {
        const std::string all = "cd '" + folder.string() + "' && (" + command + ") >log 2>&1";
        EXPECT_EQ(std::system(all.c_str()), 0) << command << ": " << get("log");
    }

    void converted(const Names& words) const {
        Names all = {"convert"};
        all.insert(all.end(), words.begin(), words.end());
        const Ran ran = run(all);
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.err, "");
    }

    std::vector<float> values_of(const std::string& name) const {
        Diagnostics diagnostics;
        const auto image = load_image(folder / name, diagnostics);
        EXPECT_TRUE(image) << to_text(diagnostics);
        return image ? image->data : std::vector<float>();
    }
};

// Compares every mip level.
TEST_F(Convert, SlopesAreThoseOfMaketx) {
    put_height("h.pfm", 128, 64);
    shell("maketx --bumpslopes --format openexr -d float --compression none h.pfm -o theirs.exr");
    converted({"h.pfm", "-o", "ours.exr", "--from", "height", "--to", "slopes", "--type", "float",
               "--mips"});
    shell("idiff -a -fail 1e-6 -hardfail 1e-6 ours.exr theirs.exr");
    converted({"h.pfm", "-o", "wrong.exr", "--from", "height", "--to", "slopes", "--type", "float",
               "--mips", "--scale", "1.01"});
    EXPECT_NE(std::system(("idiff -q -a -fail 1e-6 '" + (folder / "wrong.exr").string() + "' '" +
                           (folder / "theirs.exr").string() + "' >/dev/null 2>&1")
                              .c_str()),
              0);
}

// maketx has t downwards, so its product has the opposite sign.
TEST_F(Convert, MomentsAreThoseOfMaketx) {
    put_height("h.pfm", 64, 32);
    shell(
        "maketx --bumpslopes --nomipmap --format openexr -d float h.pfm -o six.exr && "
        "oiiotool six.exr --ch b3_dhds2,b4_dhdt2,b5_dh2dsdt --mulc 1,1,-1 --chnames R,G,B "
        "-d float -o theirs.tif");
    converted(
        {"h.pfm", "-o", "ours.tif", "--from", "height", "--to", "moments", "--type", "float"});
    shell("idiff -fail 1e-6 -hardfail 1e-6 ours.tif theirs.tif");
}

// Mip levels made in bands are bit-identical to halving the complete image.
TEST_F(Convert, LevelsAreThoseOfTheWholePicture) {
    const std::vector<std::pair<int, int>> sizes = {{301, 197}, {7, 333}, {130, 7}, {1, 200}};
    for (const auto& [width, height] : sizes) {
        put_height("h.pfm", width, height);
        converted({"h.pfm", "-o", "a.exr", "--from", "height", "--to", "moments", "--type", "float",
                   "--mips"});
        Diagnostics diagnostics;
        auto first = load_image(folder / "a.exr", diagnostics);
        ASSERT_TRUE(first) << to_text(diagnostics);
        const MipChain chain = build_mips(std::move(*first));
        std::string command = "oiiotool";
        for (uint32_t level = 1; level < chain.count(); ++level)
            command += " a.exr --selectmip " + std::to_string(level) + " -o " +
                       std::to_string(level) + ".tif";
        shell(command);
        for (uint32_t level = 1; level < chain.count(); ++level)
            EXPECT_TRUE(values_of(std::to_string(level) + ".tif") == chain.levels[level].data)
                << width << " x " << height << " level " << level;
    }
}

TEST_F(Convert, ARepeatedMapHasTheMiddleOfNine) {
    put_height("one.pfm", 50, 37);
    put_height("nine.pfm", 50, 37, 3);
    shell(
        "maketx --bumpslopes --nomipmap --format openexr -d float nine.pfm -o nine.exr && "
        "oiiotool nine.exr --cut 50x37+50+37 -d float -o theirs.exr");
    converted({"one.pfm", "-o", "ours.exr", "--from", "height", "--to", "slopes", "--type", "float",
               "--wrap", "repeat", "--tile", "64"});
    shell(
        "oiiotool ours.exr -o ours.tif && oiiotool theirs.exr -o theirs.tif && "
        "idiff -fail 1e-6 -hardfail 1e-6 ours.tif theirs.tif");
}

// Each conversion from a height map is inverted by the conversion back.
TEST_F(Convert, ThereAndBack) {
    put_height("h.pfm", 60, 44);
    const std::vector<float> heights = values_of("h.pfm");
    const auto expect_back = [&](const std::string& file, double tolerance) {
        const std::vector<float> back = values_of(file);
        ASSERT_EQ(back.size(), heights.size());
        double mean = 0;
        for (size_t i = 0; i < back.size(); ++i)
            mean += (static_cast<double>(heights[i]) - back[i]) / static_cast<double>(back.size());
        double worst = 0;
        for (size_t i = 0; i < back.size(); ++i)
            worst = std::max(worst, std::abs(heights[i] - back[i] - mean));
        EXPECT_LT(worst, tolerance) << file;
    };
    for (const Names& way :
         {Names{"normal", "exr", "float", "normal_gl"}, Names{"normal", "png", "u16", "normal_gl"},
          Names{"derivative", "exr", "float", "derivative"},
          Names{"derivative", "png", "u16", "derivative"},
          Names{"derivative", "tif", "u16", "derivative"}}) {
        const std::string file = "way." + way[1];
        converted({"h.pfm", "-o", file, "--from", "height", "--to", way[0], "--type", way[2]});
        converted({file, "-o", "back.exr", "--from", way[3], "--to", "height", "--type", "float"});
        expect_back("back.exr", way[2] == "float" ? 0.005 : 0.02);
    }
    converted({"h.pfm", "-o", "h.png", "--from", "height", "--to", "height"});
    converted({"h.png", "-o", "back.exr", "--from", "height", "--to", "height", "--type", "float"});
    expect_back("back.exr", 1e-4);
}

TEST_F(Convert, GreenTurnsAndNormalsBecomeSlopes) {
    put_height("h.pfm", 40, 40);
    converted({"h.pfm", "-o", "gl.png", "--from", "height", "--to", "normal"});
    converted({"h.pfm", "-o", "dx.png", "--from", "height", "--to", "normal", "--green", "dx"});
    const std::vector<float> gl = values_of("gl.png"), dx = values_of("dx.png");
    for (size_t i = 0; i < gl.size(); i += 3) {
        EXPECT_EQ(gl[i], dx[i]);
        EXPECT_NEAR(gl[i + 1], 1 - dx[i + 1], 2e-5);
    }
    converted({"dx.png", "-o", "again.png", "--from", "normal_dx", "--to", "normal"});
    const std::vector<float> again = values_of("again.png");
    for (size_t i = 0; i < gl.size(); ++i)
        EXPECT_NEAR(gl[i], again[i], 2e-5);
}

TEST_F(Convert, WhatItTakesThePictureForIsSaid) {
    put_height("h.pfm", 40, 40);
    const Ran height = run({"convert", "h.pfm", "-o", "n.png", "--to", "normal"});
    EXPECT_EQ(height.code, 0);
    EXPECT_TRUE(says(height.err, "h.pfm: warning: is taken for a height map (--from says"));
    const Ran normal = run({"convert", "n.png", "-o", "d.exr", "--to", "derivative"});
    EXPECT_TRUE(says(normal.err, "is taken for a tangent-space normal map, green up"));
    put("color.ppm", "P6\n2 2\n255\n" + std::string("\xFF\1\1\1\xFF\1\1\xFF\xFF\x80\1\1", 12));
    const Ran color = run({"convert", "color.ppm", "-o", "x.exr", "--to", "derivative"});
    EXPECT_EQ(color.code, 1);
    EXPECT_TRUE(says(color.err, "looks like no map of a bump"));
    EXPECT_FALSE(exists("x.exr"));
}

TEST_F(Convert, BadInputLeavesWhatWasThere) {
    put_height("h.pfm", 40, 40);
    put("out.exr", "old");
    put("cut.pfm", get("h.pfm").substr(0, 3000));
    put("bomb.pfm", "Pf\n100000 100000\n-1.0\nx");
    struct Bad {
        Names words;
        int code;
        std::string says;
    };
    const Names usual = {"-o", "out.exr", "--to", "slopes", "--from", "height"};
    const Bad cases[] = {
        {{"cut.pfm"}, 1, "damaged or truncated"},
        {{"bomb.pfm"}, 1, "over the limit"},
        {{"none.pfm"}, 1, "No such file"},
        {{"-"}, 2, "no streams"},
        {{"h.pfm", "--texel", "0"}, 2, "sizes above 0"},
        {{"h.pfm", "--tile", "20"}, 2, "multiple of 16"},
        {{"h.pfm", "--type", "u8"}, 3, "cannot hold values of type u8"},
        {{"h.pfm", "--compression", "lzw"}, 3, "no compression 'lzw'"},
    };
    for (const Bad& bad : cases) {
        Names words = {"convert"};
        words.insert(words.end(), bad.words.begin(), bad.words.end());
        words.insert(words.end(), usual.begin(), usual.end());
        const Ran ran = run(words);
        EXPECT_EQ(ran.code, bad.code) << bad.says;
        EXPECT_TRUE(says(ran.err, bad.says));
        EXPECT_EQ(get("out.exr"), "old");
    }
    EXPECT_EQ(
        run({"convert", "h.pfm", "-o", "no/out.exr", "--to", "normal", "--from", "height"}).code,
        3);
    EXPECT_EQ(files().size(), 4u) << "something is left";
}

TEST_F(Convert, EqualBytesEachTimeAndUntouchedThen) {
    put_height("h.pfm", 130, 70);
    const Names words = {"h.pfm", "-o", "a.exr", "--from", "height", "--to", "slopes", "--mips"};
    converted(words);
    const std::string bytes = get("a.exr");
    const auto past = fs::last_write_time(folder / "a.exr") - std::chrono::hours(1);
    fs::last_write_time(folder / "a.exr", past);
    converted(words);
    EXPECT_EQ(fs::last_write_time(folder / "a.exr"), past);
    shell("taskset -c 0 " + program + " convert h.pfm -o b.exr --from height --to slopes --mips");
    EXPECT_TRUE(get("b.exr") == bytes);
}

TEST_F(Convert, LintHasAVerdictItsNumbersAndAnExitCode) {
    put_height("h.pfm", 40, 40);
    converted({"h.pfm", "-o", "gl.png", "--from", "height", "--to", "normal"});
    const Ran seam = run({"lint", "gl.png"});
    EXPECT_EQ(seam.code, 1);
    EXPECT_TRUE(says(seam.out, "gl.png: normal_gl: a tangent-space normal map, green up"));
    EXPECT_TRUE(says(seam.out, "defect: seam_u: across u the border steps by"));
    EXPECT_EQ(run({"lint", "gl.png", "--wrap", "clamp"}).code, 0);
    EXPECT_EQ(run({"lint", "gl.png", "--wrap", "clamp", "--expect", "normal_gl"}).code, 0);
    const Ran dx = run({"lint", "gl.png", "--wrap", "clamp", "--expect", "normal_dx", "--json"});
    EXPECT_EQ(dx.code, 1);
    const json::Value root = parsed(dx.out);
    const json::Value image = root.find("images").at(0);
    EXPECT_EQ(image.find("look").as_string(), "normal_gl");
    const json::Value findings = image.find("findings");
    EXPECT_EQ(findings.at(findings.size() - 1).find("name").as_string(), "unexpected");
    EXPECT_TRUE(image.find("evidence").has("curl_gl"));
    const Ran missing = run({"lint", "none.png", "gl.png", "--wrap", "clamp"});
    EXPECT_EQ(missing.code, 1);
    EXPECT_TRUE(says(missing.out, "gl.png: normal_gl"));
    EXPECT_TRUE(says(missing.err, "none.png"));
}

}  // namespace
}  // namespace wrinkle::test
