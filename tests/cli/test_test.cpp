// Tests of wrinkle test: success, failure, messages, and the changes of --update.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

using TestTest = CliTest;

constexpr const char* tilted = R"({
  "points": [{ "normal": [0, 0, 1] }],
  "expect": [{ "normal": [-0.6, 0, 0.8] }]
}
)";
// Rotated by 1 degree: (-sin, 0, cos) of atan(0.75) + 1 degree.
constexpr const char* one_degree_off = R"({
  "points": [{ "normal": [0, 0, 1] }],
  "expect": [{ "normal": [-0.6138705, 0, 0.7894067] }]
}
)";

TEST_F(TestTest, PassesWhatAgrees) {
    put("a.json", tilt_graph());
    put("a.test.json", tilted);
    const Ran ran = run({"test", "a.test.json"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out, "1 passed, 0 failed\n");
}

TEST_F(TestTest, FailsWithAllThatIsToBeKnown) {
    put("a.json", tilt_graph());
    put("a.test.json", one_degree_off);
    const Ran ran = run({"test", "."});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.out, "FAIL a/points/0: output 'normal' (end.normal)"));
    EXPECT_TRUE(says(ran.out, "expected [-0.6138705, 0, 0.7894067], got [-0.6"));
    EXPECT_TRUE(says(ran.out, "1 degrees apart, 0.05 degrees allowed"));
    EXPECT_TRUE(says(ran.out, "(./a.test.json:2)"));
    EXPECT_TRUE(ran.out.ends_with("0 passed, 1 failed\n"));
}

TEST_F(TestTest, FailedCasesAreDiagnosticsInJson) {
    put("a.json", tilt_graph());
    std::string text = one_degree_off;
    put("a.test.json", text.insert(1, "\"glsl\": true,"));
    put("golden/a.glsl", "other");
    put("b.json", tilt_graph());
    put("b.test.json", tilted);
    const Ran ran = run({"test", "a.test.json", "b.test.json", "--diagnostics", "json"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(ran.out.ends_with("1 passed, 2 failed\n")) << ran.out;
    const json::Value list = parsed(ran.err).find("diagnostics");
    ASSERT_EQ(list.size(), 2U) << ran.err;
    for (size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(list.at(i).find("file").as_string(), "a.test.json");
        EXPECT_EQ(list.at(i).find("severity").as_string(), "error");
    }
    EXPECT_EQ(list.at(0).find("pointer").as_string(), "/points/0");
    EXPECT_EQ(list.at(0).find("line").as_number(), 2);
    EXPECT_TRUE(says(std::string(list.at(0).find("message").as_string()), "output 'normal'"));
    EXPECT_EQ(list.at(1).find("pointer").as_string(), "/glsl");
    put("c.json", tilt_graph());
    put("c.test.json", R"({"render": {}})");
    const Ran dark = run({"test", "c.test.json", "--diagnostics", "json"}, "", without_gl());
    EXPECT_EQ(dark.code, 3);
    EXPECT_EQ(parsed(dark.err).find("diagnostics").size(), 1U) << dark.err;
}

TEST_F(TestTest, TolerancesAreThoseOfTheFile) {
    put("a.json", tilt_graph());
    std::string text = one_degree_off;
    put("a.test.json", text.insert(1, "\"tolerance_deg\": 1.1,"));
    EXPECT_EQ(run({"test", "a.test.json"}).code, 0);
    put("b.json", ramp_graph("2"));
    const std::string cases = R"("points": [{"uv0": [1, 0]}], "expect": [{"value": 2.01}]})";
    put("b.test.json", "{\"tolerance\": 0.02, " + cases);
    EXPECT_EQ(run({"test", "b.test.json"}).code, 0);
    put("b.test.json", "{" + cases);
    EXPECT_EQ(run({"test", "b.test.json"}).code, 1);
}

TEST_F(TestTest, SearchesFoldersBelow) {
    put("x/a.json", tilt_graph());
    put("x/a.test.json", tilted);
    put("x/y/b.json", tilt_graph());
    put("x/y/b.test.json", one_degree_off);
    const Ran ran = run({"test", "x"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(ran.out.ends_with("1 passed, 1 failed\n")) << ran.out;
    fs::create_directories(folder / "empty");
    EXPECT_EQ(run({"test", "empty"}).code, 1);
    EXPECT_EQ(run({"test", "missing"}).code, 1);
}

TEST_F(TestTest, SetChangesAValueFirst) {
    put("a.json", tilt_graph("0"));
    std::string text = tilted;
    put("a.test.json", text.insert(1, R"("set": ["tilt.volume=[0.75, 0, 0]"],)"));
    const Ran ran = run({"test", "a.test.json"});
    EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
}

TEST_F(TestTest, UpdateRewritesOnlyWhatDiffers) {
    put("b.json", ramp_graph("2"));
    const std::string before = R"({ "tolerance": 0.001,
  "points": [{"uv0": [1.0, 0]}, {"uv0": [2, 0]}],   "expect": [{ "value": 2.0 }, { "value": 7 }]
})";
    const std::string after = R"({ "tolerance": 0.001,
  "points": [{"uv0": [1.0, 0]}, {"uv0": [2, 0]}],   "expect": [
    { "value": 2.0 },
    {"value": 4}
  ]
})";
    put("b.test.json", before);
    EXPECT_EQ(run({"test", "b.test.json"}).code, 1);
    EXPECT_EQ(run({"test", "b.test.json", "--update"}).code, 0);
    EXPECT_EQ(get("b.test.json"), after);
    EXPECT_EQ(run({"test", "b.test.json"}).code, 0);
}

TEST_F(TestTest, UpdateAddsWhatIsExpected) {
    put("b.json", ramp_graph("2"));
    put("b.test.json", "{\n  \"points\": [{\"uv0\": [1, 0]}]\n}\n");
    const Ran without = run({"test", "b.test.json"}, "", {"CI="});
    EXPECT_EQ(without.code, 0);
    EXPECT_TRUE(says(without.out, "NEW b/points/0: expects nothing yet (b.test.json:2)"));
    EXPECT_TRUE(without.out.ends_with("0 passed, 0 failed, 1 new\n"));
    for (const Ran& ci : {run({"test", "b.test.json", "--ci"}, "", {"CI="}),
                          run({"test", "b.test.json"}, "", {"CI=true"})})
        EXPECT_EQ(ci.code, 1) << ci.out;
    EXPECT_EQ(run({"test", "b.test.json", "--update"}).code, 0);
    EXPECT_EQ(get("b.test.json"),
              "{\n  \"points\": [{\"uv0\": [1, 0]}],\n  \"expect\": [\n    {\"value\": 2}\n  "
              "]\n}\n");
    EXPECT_EQ(run({"test", "b.test.json"}).code, 0);
}

TEST_F(TestTest, ComparesTexts) {
    put("a.json", tilt_graph("0.75"));
    put("a.test.json", "{\"glsl\": true}");
    const Ran missing = run({"test", "a.test.json", "--ci"});
    EXPECT_EQ(missing.code, 1);
    EXPECT_TRUE(says(missing.out, "golden/a.glsl"));
    EXPECT_EQ(run({"test", "a.test.json", "--update"}).code, 0);
    EXPECT_EQ(get("golden/a.glsl"), run({"compile", "a.json"}).out);
    EXPECT_EQ(run({"test", "a.test.json"}).code, 0);
    put("a.json", tilt_graph("0.25"));
    const Ran changed = run({"test", "a.test.json", "--report", "out"});
    EXPECT_EQ(changed.code, 1);
    EXPECT_TRUE(says(changed.out, "line "));
    EXPECT_TRUE(says(changed.out, "0.75"));
    const json::Value check = parsed(get("out/results.json")).find("checks").at(0);
    EXPECT_EQ(check.find("actual_text").as_string(), run({"compile", "a.json"}).out);
    EXPECT_EQ(check.find("expected_text").as_string(), get("golden/a.glsl"));
}

TEST_F(TestTest, ComparesImages) {
    put("a.json", tilt_graph("0.75"));
    put("a.test.json", R"({"render": {"mesh": "plane", "size": "24x24", "view": "normal"}})");
    EXPECT_EQ(run({"test", "a.test.json", "--update"}).code, 0);
    EXPECT_EQ(run({"test", "a.test.json"}).out, "1 passed, 0 failed\n");
    put("a.json", tilt_graph("0.25"));
    const Ran changed = run({"test", "a.test.json", "--report", "out"});
    EXPECT_EQ(changed.code, 1);
    EXPECT_TRUE(says(changed.out, "the image differs by"));
    for (const char* folder : {"expected", "actual", "map"})
        EXPECT_TRUE(exists("out/" + std::string(folder) + "/a.png"));
}

TEST_F(TestTest, DrawsOnMeshFilesBesideTheGraph) {
    fs::create_directories(folder / "in/meshes");
    put("in/a.json", tilt_graph("0.75"));
    put("in/meshes/half.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nf 1 2 3\n");
    put("in/a.test.json",
        R"({"render": {"mesh": "meshes/half.obj", "size": "24x24", "view": "normal"}})");
    EXPECT_EQ(run({"test", "in/a.test.json", "--update"}).code, 0);
    EXPECT_EQ(run({"test", "in"}).out, "1 passed, 0 failed\n");
    put("in/meshes/half.obj", "v -1 -1 0\nv 1 -1 0\nv -1 1 0\nf 1 2 3\n");
    EXPECT_EQ(run({"test", "in"}).out.substr(0, 4), "FAIL");
}

TEST_F(TestTest, ImagesWithoutADriverAreTheEnvironmentsFault) {
    put("a.json", tilt_graph());
    put("a.test.json", R"({"render": {"size": "24x24"}})");
    const Ran ran = run({"test", "a.test.json"}, "", without_gl());
    EXPECT_EQ(ran.code, 3);
    EXPECT_TRUE(says(ran.err, "OpenGL"));
    EXPECT_TRUE(says(ran.out, "ERROR a/render: OpenGL"));
    EXPECT_TRUE(ran.out.ends_with("0 passed, 1 failed\n"));
}

TEST_F(TestTest, RefusesBadFiles) {
    put("a.json", tilt_graph());
    const std::vector<std::pair<std::string, std::string>> cases = {
        {R"({"point": []})", "did you mean 'points'?"},
        {R"({"points": [{"normal": [0, 0, 1]}], "expect": [{}, {}]})", "1 points"},
        {R"({"points": [{"normal": [0, 0, 1]}], "expect": [5]})", "an object"},
        {R"({"points": [{}], "expect": [{"normal": [0, 0, 1]}]})", "lacks 'normal'"},
        {R"({"glsl": 1})", "a.test.json:1:10"},
        {R"({"glsl": true, "tolerance": -1})", "negative"},
        {R"({"render": {"mesh": "kettle"}})", "'kettle'"},
        {R"({"render": {"mesh": 5}})", "mesh is a number"},
        {R"({"render": {"mesh": "../out.obj"}})", "outside the root"},
        {R"({"render": {"mesh": "none.obj"}})", "none.obj"},
        {R"({"render": {"mesh": "a.json"}})", "a.json"},
        {R"({"render": {"size": "9x"}})", "640x480"},
        {R"({"render": {"viewed": "uv"}})", "did you mean 'view'?"},
        {R"({"render": {"metric": "psnr"}})", "there is no 'psnr' (rms, flip, degrees)"},
        {R"({"render": {"max_over": -1}})", "max_over is negative"},
        {R"({"budget": {"alus": 3}})", "did you mean 'alu'?"},
        {R"({"budget": {"alu": "3"}})", "alu is a string (a number)"},
        {R"({"glsl": true, "set": ["tilt.volume=0:1:2"]})", "sweep"},
        {R"({"glsl": true, "set": ["nobody.volume=0"]})", "nobody"},
        {"{}", "there is no case"},
        {"[]", "an object"},
        {"{", "a.test.json:1:"},
    };
    for (const auto& [text, words] : cases) {
        put("a.test.json", text);
        const Ran ran = run({"test", "a.test.json"});
        EXPECT_EQ(ran.code, 1) << text;
        EXPECT_TRUE(says(ran.err, words)) << text;
        EXPECT_TRUE(ran.out.ends_with("0 passed, 1 failed\n")) << ran.out;
        EXPECT_EQ(get("a.test.json"), text);
    }
}

TEST_F(TestTest, AnOutputThatTheGraphLacksFails) {
    put("a.json", tilt_graph());
    put("a.test.json", R"({"points": [{"normal": [0, 0, 1]}], "expect": [{"norml": [0, 0, 1]}]})");
    const Ran ran = run({"test", "a.test.json"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.out, "the graph has no such output; did you mean 'normal'?"));
}

}  // namespace
}  // namespace wrinkle::test
