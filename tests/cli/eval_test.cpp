// Tests of wrinkle eval against values that are known without the program.
#include <cmath>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

class EvalTest : public CliTest {
protected:
    // Returns the first point that `wrinkle eval` prints.
    json::Value point(const std::vector<std::string>& args) const {
        const Ran ran = run(args);
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.err, "");
        const json::Value points = parsed(ran.out).find("points");
        return points.size() > 0 ? points.at(0) : json::Value();
    }

    void expect_normal(const json::Value& normal, double x, double y, double z) const {
        ASSERT_EQ(normal.size(), 3u);
        EXPECT_NEAR(normal.at(0).as_number(), x, 1e-6);
        EXPECT_NEAR(normal.at(1).as_number(), y, 1e-6);
        EXPECT_NEAR(normal.at(2).as_number(), z, 1e-6);
    }
};

TEST_F(EvalTest, TiltsAPlane) {
    put("g.json", tilt_graph("0.75"));
    // (-0.75, 0, 1) has length 1.25.
    expect_normal(point({"eval", "g.json", "--at", R"({"normal": [0, 0, 1]})"}).find("normal"),
                  -0.6, 0, 0.8);
}

TEST_F(EvalTest, FacingIsAssumedAndMayBeSaid) {
    put("g.json", tilt_graph("0"));
    const std::string at = R"({"normal": [0, 0, 2], "facing": -1})";
    expect_normal(point({"eval", "g.json", "--at", at}).find("normal"), 0, 0, -1);
}

TEST_F(EvalTest, TakesAnArrayAFileAndStandardInput) {
    put("g.json", ramp_graph("2"));
    const std::string points = R"([{"uv0": [0.25, 0]}, {"uv0": [-3, 0]}])";
    put("points.json", points);
    const std::string wanted = "{\"points\": [\n  {\"value\": 0.5},\n  {\"value\": -6}\n]}\n";
    EXPECT_EQ(run({"eval", "g.json", "--at", points}).out, wanted);
    EXPECT_EQ(run({"eval", "g.json", "--at", "@points.json"}).out, wanted);
    EXPECT_EQ(run({"eval", "g.json", "--at", "-"}, points).out, wanted);
    EXPECT_EQ(run({"eval", "-", "--at", points}, ramp_graph("2")).out, wanted);
    EXPECT_EQ(run({"eval", "g.json", "--at", "[]"}).out, "{\"points\": []}\n");
}

TEST_F(EvalTest, PrintsEachPrecisionToItsLastDigit) {
    put("g.json", ramp_graph("0.1"));
    const std::string at = R"({"uv0": [3, 0]})";
    EXPECT_TRUE(says(run({"eval", "g.json", "--at", at}).out, "{\"value\": 0.3}"));
    EXPECT_TRUE(says(run({"eval", "g.json", "--at", at, "--precision", "double"}).out,
                     "{\"value\": 0.30000000000000004}"));
}

TEST_F(EvalTest, NamesWhatAPointLacks) {
    put("g.json", ramp_graph());
    const Ran ran = run({"eval", "g.json", "--at", R"([{"uv0": [1, 0]}, {"uv1": [1, 0]}])"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(says(ran.err, "--at:1:19: error: point 1 lacks 'uv0'"));
}

TEST_F(EvalTest, NamesADifferentialThatAPointLacks) {
    put("g.json", R"({"wrinkle": 1, "nodes": {
        "split": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
        "bump": {"type": "gradient_from_height", "in": {"height": {"from": "split.x"}}},
        "end": {"type": "resolve", "in": {"gradient": {"from": "bump.gradient"}}}},
        "outputs": {"normal": {"from": "end.normal"}}})");
    const std::string base = R"("position": [0, 0, 0], "normal": [0, 0, 1], "uv0": [0, 0],
        "dx": {"position": [0.001, 0, 0], "uv0": [0.001, 0]}, )";
    const Ran ran = run({"eval", "g.json", "--at", "{" + base + R"("dy": {"uv0": [0, 0]}})"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "lacks 'dy.position'"));
    // Height x over the plane: slope 1, an angle of 45 degrees.
    const std::string whole = "{" + base + R"("dy": {"position": [0, 0.001, 0], "uv0": [0, 0]}})";
    expect_normal(point({"eval", "g.json", "--at", whole}).find("normal"), -std::sqrt(0.5), 0,
                  std::sqrt(0.5));
}

TEST_F(EvalTest, DerivesAPointOfAMesh) {
    put("g.json", tilt_graph("0.75"));
    expect_normal(point({"eval", "g.json", "--mesh", "plane", "--uv", "0.3,0.7"}).find("normal"),
                  -0.6, 0, 0.8);
    put("ramp.json", ramp_graph("2"));
    EXPECT_TRUE(says(run({"eval", "ramp.json", "--mesh", "plane", "--uv", "0.25,0.5"}).out,
                     "{\"value\": 0.5}"));
    const Ran outside = run({"eval", "ramp.json", "--mesh", "plane", "--uv", "3,0.5"});
    EXPECT_EQ(outside.code, 1);
    EXPECT_EQ(outside.out, "");
}

TEST_F(EvalTest, SweepsAValue) {
    put("g.json", ramp_graph("2"));
    const Ran ran =
        run({"eval", "g.json", "--at", R"({"uv0": [1, 0]})", "--set", "scaled.b=0:2:3"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const json::Value runs = parsed(ran.out).find("runs");
    ASSERT_EQ(runs.size(), 3u);
    for (size_t i = 0; i < 3; ++i) {
        const json::Value each = runs.at(i);
        EXPECT_EQ(each.find("set").find("scaled.b").as_number(), static_cast<double>(i));
        EXPECT_EQ(each.find("points").at(0).find("value").as_number(), static_cast<double>(i));
    }
}

TEST_F(EvalTest, WhatJsonCannotSayIsNull) {
    put("g.json", ramp_graph("3e38"));
    EXPECT_TRUE(says(run({"eval", "g.json", "--at", R"({"uv0": [9, 0]})"}).out, "\"value\": null"));
}

TEST_F(EvalTest, NormalsThatThePrecisionLosesAreNamed) {
    put("g.json", tilt_graph());
    const std::string fine = R"({"normal": [0, 0, 1]})";
    for (const std::string lost : {"1e20", "1e-30"}) {
        const std::string at = "[" + fine + R"(, {"normal": [0, 0, )" + lost + "]}]";
        const Ran ran = run({"eval", "g.json", "--at", at});
        EXPECT_EQ(ran.code, 0);
        EXPECT_TRUE(says(ran.err, "warning: point 1: the surface normal's length cannot be"));
        EXPECT_EQ(ran.err.find("point 0"), std::string::npos);
        const Ran exact = run({"eval", "g.json", "--at", at, "--precision", "double"});
        EXPECT_EQ(exact.err, "");
    }
}

TEST_F(EvalTest, ChangesThatAFrameFadesByAreNamed) {
    put("g.json", R"({"wrinkle": 1, "nodes": {
        "bump": {"type": "gradient_from_tangent_normal", "in": {"normal": [0.6, 0, 0.8],
                 "frame": "derived"}},
        "end": {"type": "resolve", "in": {"gradient": {"from": "bump.gradient"}}}},
        "outputs": {"normal": {"from": "end.normal"}}})");
    const auto said = [&](const std::string& size, const std::string& precision) {
        const std::string at = R"({"normal": [0, 0, 1], "position": [0, 0, 0], "uv0": [0, 0],
            "dx": {"position": [)" +
                               size + ", 0, 0], \"uv0\": [" + size + R"(, 0]},
            "dy": {"position": [0, )" +
                               size + ", 0], \"uv0\": [0, " + size + "]}}";
        const Ran ran = run({"eval", "g.json", "--at", at, "--precision", precision});
        EXPECT_EQ(ran.code, 0) << ran.err;
        return ran.err;
    };
    for (const std::string precision : {"float", "double"}) {
        EXPECT_EQ(said("1e-8", precision), "");
        EXPECT_TRUE(says(said("5e-10", precision), "point 0: the changes of position and uv0 are"));
    }
}

TEST_F(EvalTest, ReportsABadPoint) {
    put("g.json", ramp_graph());
    const std::vector<std::pair<std::string, std::string>> cases = {
        {R"({"uv": [1, 0]})", "did you mean 'uv"},
        {R"({"uv0": [1]})", "an array of 2 numbers"},
        {R"({"uv0": "x"})", "an array of 2 numbers"},
        {R"({"uv0": [1, NaN]})", "--at:1:"},
        {R"({"uv0": [1, 1e999]})", "--at:1:"},
        {R"({"uv0": [1e300, 0]})", "single precision"},
        {R"({"uv0": [1, 0], "uv0": [1, 0]})", "uv0"},
        {R"({"uv0": [1, 0], "dx": 3})", "dx is a number"},
        {R"({"normal": [0, 0, 0]})", "normal is zero"},
        {R"({"uv0": [1, 0], "dx": {"facing": 1}})", "facing"},
        {R"(7)", "a point is an object"},
        {R"({"uv0": [1, 0])", "--at:1:"},
        {"@missing.json", "missing.json"},
    };
    for (const auto& [at, words] : cases) {
        const Ran ran = run({"eval", "g.json", "--at", at});
        EXPECT_EQ(ran.code, 1) << at;
        EXPECT_EQ(ran.out, "") << at;
        EXPECT_TRUE(says(ran.err, words)) << at;
    }
}

TEST_F(EvalTest, RefusesWrongUsage) {
    put("g.json", ramp_graph());
    const std::vector<std::vector<std::string>> cases = {
        {"eval", "g.json"},
        {"eval", "g.json", "--mesh", "plane"},
        {"eval", "g.json", "--mesh", "plane", "--uv", "0.5"},
        {"eval", "g.json", "--mesh", "nothing", "--uv", "0,0"},
        {"eval", "g.json", "--at", "{}", "--mesh", "plane", "--uv", "0,0"},
        {"eval", "g.json", "--at", "{}", "--uv", "0,0"},
        {"eval", "-", "--at", "-"},
        {"eval", "g.json", "--at", "{}", "--precision", "half"},
        {"eval", "g.json", "--mesh", "plane", "--uv", "0,0", "--size", "0"},
    };
    for (const auto& args : cases) {
        const Ran ran = run(args, "x");
        EXPECT_EQ(ran.code, 2) << testing::PrintToString(args);
        EXPECT_EQ(ran.out, "");
        EXPECT_EQ(ran.read, 0);
        EXPECT_NE(ran.err, "");
    }
}

TEST_F(EvalTest, SweepsOverFiniteNumbersAlone) {
    put("g.json", ramp_graph());
    for (const std::string sweep : {"nan:1:3", "0:inf:3", "0:1:nan"}) {
        const Ran ran =
            run({"eval", "g.json", "--at", R"({"uv0": [1, 0]})", "--set", "scaled.b=" + sweep});
        EXPECT_EQ(ran.code, 1) << sweep << ran.out;
        EXPECT_TRUE(says(ran.err, sweep));
    }
}

}  // namespace
}  // namespace wrinkle::test
