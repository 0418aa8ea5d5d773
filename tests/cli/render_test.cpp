// Tests of wrinkle render against sizes and contents that are known without it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

class RenderTest : public CliTest {
protected:
    // Returns the size in the header of a PNG file.
    static std::pair<uint32_t, uint32_t> png_size(const std::string& bytes) {
        if (bytes.size() < 24 || bytes.compare(1, 3, "PNG") != 0) return {0, 0};
        const auto number = [&](size_t at) {
            uint32_t value = 0;
            for (size_t i = at; i < at + 4; ++i)
                value = value << 8 | static_cast<uint8_t>(bytes[i]);
            return value;
        };
        return {number(16), number(20)};
    }

    // Returns the angles that the difference view prints.
    static std::pair<double, double> angles(const std::string& text) {
        double mean = -1, max = -1;
        const size_t at = text.find("mean");
        const std::string numbers = at == text.npos ? "" : text.substr(at);
        EXPECT_EQ(std::sscanf(numbers.c_str(), "mean %lf degrees, max %lf", &mean, &max), 2);
        return {mean, max};
    }
};

TEST_F(RenderTest, WritesAPictureOfTheSize) {
    put("g.json", tilt_graph());
    const Ran ran = run({"render", "g.json", "-o", "g.png", "--size", "40x30"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out + ran.err, "");
    EXPECT_EQ(png_size(get("g.png")), std::pair(40u, 30u));
    EXPECT_EQ(files(), (std::vector<std::string>{"g.json", "g.png"}));
}

TEST_F(RenderTest, LeavesAnEqualPictureUntouched) {
    put("g.json", tilt_graph());
    ASSERT_EQ(run({"render", "g.json", "-o", "g.png", "--size", "16x16"}).code, 0);
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(5);
    fs::last_write_time(folder / "g.png", old);
    const auto before = fs::last_write_time(folder / "g.png");
    ASSERT_EQ(run({"render", "g.json", "-o", "g.png", "--size", "16x16"}).code, 0);
    EXPECT_EQ(fs::last_write_time(folder / "g.png"), before);
}

// The editor sets Mesa's software driver to optimise shaders less (gpu/context.h).
TEST_F(RenderTest, QuickProgramsDrawTheSamePicture) {
    const std::string graph = WRINKLE_SOURCE_DIR "/graphs/woven_strap.json";
    for (const char* name : {"nopt", ""}) {
        const Ran ran =
            run({"render", graph, "-o", std::string("g") + name + ".png", "--size", "200x150"}, "",
                {std::string("GALLIVM_PERF=") + name,
                 "MESA_SHADER_CACHE_DIR=" + (folder / ("cache" + std::string(name))).string()});
        ASSERT_EQ(ran.code, 0) << ran.err;
    }
    EXPECT_EQ(get("gnopt.png"), get("g.png"));
}

TEST_F(RenderTest, MeasuresTheDifference) {
    put("g.json", tilt_graph("0.75"));
    const std::vector<std::string> args = {"render", "g.json", "-o",    "g.png",  "--size",
                                           "24x24",  "--mesh", "plane", "--view", "difference"};
    const auto [mean, max] = angles(run(args).out);
    const double tilt = std::atan(0.75) * 180 / M_PI;  // the complete plane has one tilt
    EXPECT_NEAR(mean, tilt, 0.01);
    EXPECT_NEAR(max, tilt, 0.01);
    put("g.json", tilt_graph("0"));
    EXPECT_NEAR(angles(run(args).out).second, 0, 0.05);
}

TEST_F(RenderTest, SweepsIntoNumberedFiles) {
    put("g.json", tilt_graph());
    put("ramp.json", R"({"wrinkle": 1, "nodes": {
        "s": {"type": "multiply", "in": {"a": 1, "b": 0.5}}},
        "outputs": {"roughness": {"from": "s.result"}}})");
    const Ran ran =
        run({"render", "ramp.json", "-o", "r.png", "--size", "16", "--set", "s.b=0.1:0.9:3"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(exists("r.000.png") && exists("r.001.png") && exists("r.002.png"));
    EXPECT_FALSE(exists("r.png"));
    EXPECT_NE(get("r.000.png"), get("r.002.png"));
    EXPECT_EQ(png_size(get("r.000.png")), std::pair(16u, 16u)) << "one number is a square";
}

TEST_F(RenderTest, WritesToStandardOutput) {
    put("g.json", tilt_graph());
    const Ran ran = run({"render", "-", "-o", "-", "--size", "20x10"}, tilt_graph());
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(png_size(ran.out), std::pair(20u, 10u));
}

TEST_F(RenderTest, MovesTheMeshByTheDisplacement) {
    const auto picture = [&](const std::string& height, bool displace) {
        put("g.json", R"({"wrinkle": 1, "nodes": {
            "h": {"type": "height_add", "in": {"a": )" +
                          height + R"(}}},
            "outputs": {"displacement": {"from": "h.height"}}})");
        std::vector<std::string> args = {"render", "g.json", "-o",    "g.png",  "--size",
                                         "32x32",  "--mesh", "plane", "--view", "normal"};
        if (displace) args.emplace_back("--displace");
        const Ran ran = run(args);
        EXPECT_EQ(ran.code, 0) << ran.err;
        return get("g.png");
    };
    EXPECT_EQ(picture("0", true), picture("0", false));
    EXPECT_EQ(picture("0.5", false), picture("0", false));
    EXPECT_NE(picture("0.5", true), picture("0", true));
}

TEST_F(RenderTest, RefusesADisplacementThatTheGraphDoesNotHave) {
    put("g.json", tilt_graph());
    const Ran ran = run({"render", "g.json", "-o", "g.png", "--size", "8x8", "--displace"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "no output 'displacement'"));
    EXPECT_FALSE(exists("g.png"));
}

TEST_F(RenderTest, RefusesAViewThatTheGraphDoesNotHave) {
    put("g.json", tilt_graph());
    const Ran height =
        run({"render", "g.json", "-o", "g.png", "--size", "8x8", "--view", "height"});
    EXPECT_EQ(height.code, 1);
    EXPECT_TRUE(says(height.err, "no output 'height'"));
    const Ran against = run({"render", "g.json", "-o", "g.png", "--size", "8x8", "--view",
                             "difference", "--against", "other"});
    EXPECT_EQ(against.code, 1);
    EXPECT_TRUE(says(against.err, "'other'"));
    const Ran view =
        run({"render", "g.json", "-o", "g.png", "--size", "8x8", "--view", "sideways"});
    EXPECT_EQ(view.code, 1);
    EXPECT_TRUE(says(view.err, "no output 'sideways'"));
    EXPECT_FALSE(exists("g.png"));
}

TEST_F(RenderTest, RefusesToCompareWithWhatIsNoNormal) {
    put("g.json", R"({"wrinkle": 1,
        "nodes": {"b": {"type": "gradient_from_volume", "in": {"volume": [1, 0, 0]}},
                  "r": {"type": "resolve", "in": {"gradient": {"from": "b.gradient"}}},
                  "t": {"type": "gradient_tilt", "in": {"gradient": {"from": "b.gradient"}}}},
        "outputs": {"normal": {"from": "r.normal"}, "raw": {"from": "b.gradient"},
                    "same": {"from": "r.normal"}, "tilt": {"from": "t.tilt"}}})");
    const auto against = [&](const std::string& output) {
        return run({"render", "g.json", "-o", "g.png", "--size", "8x8", "--view", "difference",
                    "--against", output});
    };
    const Ran raw = against("raw");
    EXPECT_EQ(raw.code, 1);
    EXPECT_TRUE(says(raw.err, "'raw' holds a gradient"));
    EXPECT_TRUE(says(raw.err, "'resolve'"));
    EXPECT_TRUE(says(against("tilt").err, "'tilt' holds a float"));
    EXPECT_FALSE(exists("g.png"));
    EXPECT_EQ(against("same").code, 0);
}

TEST_F(RenderTest, RefusesWrongUsage) {
    put("g.json", tilt_graph());
    const std::vector<std::vector<std::string>> cases = {
        {"render", "g.json"},
        {"render", "-o", "g.png"},
        {"render", "g.json", "-o", "g.txt"},
        {"render", "g.json", "-o", "g.png", "--size", "0x5"},
        {"render", "g.json", "-o", "g.png", "--size", "5x"},
        {"render", "g.json", "-o", "g.png", "--size", "99999x5"},
        {"render", "g.json", "-o", "g.png", "--mesh", "kettle"},
        {"render", "g.json", "-o", "g.png", "--camera", "30"},
        {"render", "g.json", "-o", "g.png", "--camera", "30,15,0"},
        {"render", "g.json", "-o", "g.png", "--exposure", "99"},
        {"render", "g.json", "-o", "g.png", "--tone", "filmic"},
        {"render", "g.json", "-o", "g.png", "--light", "moon"},
        {"render", "g.json", "-o", "g.png", "--against", "normal"},
        {"render", "g.json", "-o", "-", "--set", "tilt.volume=0:1:3"},
    };
    for (const auto& args : cases) {
        const Ran ran = run(args);
        EXPECT_EQ(ran.code, 2) << testing::PrintToString(args) << ran.err;
        EXPECT_EQ(files(), std::vector<std::string>{"g.json"});
    }
}

TEST_F(RenderTest, SaysThatAnOutputCannotBeWritten) {
    put("g.json", tilt_graph());
    const Ran ran = run({"render", "g.json", "-o", "nowhere/g.png", "--size", "8x8"});
    EXPECT_EQ(ran.code, 3);
    EXPECT_TRUE(says(ran.err, "nowhere/g.png"));
    EXPECT_EQ(files(), std::vector<std::string>{"g.json"});
}

TEST_F(RenderTest, MissingDriverIsOneSentence) {
    put("g.json", tilt_graph());
    const Ran ran = run({"render", "g.json", "-o", "g.png"}, "", without_gl());
    EXPECT_EQ(ran.code, 3);
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(says(ran.err, "OpenGL"));
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_EQ(files(), std::vector<std::string>{"g.json"});
}

TEST_F(RenderTest, AGraphWithErrorsNeedsNoDriverToSaySo) {
    put("g.json", "{");
    EXPECT_EQ(run({"render", "g.json", "-o", "g.png"}, "", without_gl()).code, 1);
}

TEST_F(RenderTest, OtherCommandsNeedNoDriver) {
    put("g.json", tilt_graph());
    EXPECT_EQ(run({"check", "g.json"}, "", without_gl()).code, 0);
    EXPECT_EQ(run({"compile", "g.json"}, "", without_gl()).code, 0);
    EXPECT_EQ(run({"eval", "g.json", "--at", R"({"normal": [0, 0, 1]})"}, "", without_gl()).code,
              0);
}

}  // namespace
}  // namespace wrinkle::test
