// Tests of wrinkle explain-log: maps the lines of a driver's log to nodes.
#include <cstdlib>

#include "base/text.h"
#include "cli/support.h"

namespace wrinkle::test {
namespace {

using Names = std::vector<std::string>;

class ExplainLogTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        put("g.json", graph);
    }

    // Returns the number, from 1, of the line that contains `words`.
    static size_t line_with(const std::string& text, const std::string& words) {
        const auto lines = split(text, '\n');
        for (size_t i = 0; i < lines.size(); ++i)
            if (lines[i].find(words) != lines[i].npos) return i + 1;
        ADD_FAILURE() << words << " is not in " << text;
        return 0;
    }

    Ran explain(const std::string& log, const Names& more = {}) const {
        Names args{"explain-log", "g.json", "-"};
        args.insert(args.end(), more.begin(), more.end());
        return run(args, log);
    }

    const std::string graph = ramp_graph();  // `scaled` is in its line 5
};

TEST_F(ExplainLogTest, NamesTheNodeOfALine) {
    const std::string line =
        std::to_string(line_with(run({"compile", "g.json"}).out, "s.uv0.x * 2.0"));
    const Ran ran = explain("0:" + line + "(20): error: `s' undeclared\n");
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(ran.out.starts_with("g.json:5:5: error: node 'scaled': `s' undeclared (line " +
                                    line + ": "))
        << ran.out;
    EXPECT_TRUE(says(ran.out, "s.uv0.x * 2.0"));
    EXPECT_EQ(ran.err, "");
    put("log", "0(" + line + ") : warning C7050: odd\n");
    const Ran filed = run({"explain-log", "g.json", "log"});
    EXPECT_TRUE(says(filed.out, "g.json:5:5: warning: node 'scaled': warning C7050: odd"));
}

TEST_F(ExplainLogTest, PassesOnWhatNamesNoLine) {
    const Ran ran = explain("compilation failed\n\n0:1(1): error: no\n0:900(1): error: far\nlast");
    EXPECT_EQ(ran.code, 0);
    const auto lines = split(ran.out, '\n');
    ASSERT_EQ(lines.size(), 6u) << ran.out;
    EXPECT_EQ(lines[0], "compilation failed");
    EXPECT_EQ(lines[1], "");
    EXPECT_TRUE(lines[2].starts_with("g.json: error: no (line 1: //")) << lines[2];
    EXPECT_EQ(lines[3], "g.json: error: far (line 900, which is not of this text)");
    EXPECT_EQ(lines[4], "last");
    EXPECT_EQ(explain("").out, "");
}

// An engine inserts the generated source into its own shader.
TEST_F(ExplainLogTest, ATextMayBeginSomewhereInAShader) {
    const size_t line = line_with(run({"compile", "g.json"}).out, "s.uv0.x * 2.0");
    const Ran ran =
        explain("0:" + std::to_string(line + 99) + "(1): error: no", {"--begins-at", "100"});
    EXPECT_TRUE(says(ran.out, "node 'scaled'"));
    EXPECT_TRUE(says(ran.out, "(line " + std::to_string(line + 99) + ": "));
    EXPECT_TRUE(says(explain("0:99(1): error: no", {"--begins-at", "100"}).out,
                     "line 99, which is not of this text"));
}

TEST_F(ExplainLogTest, JsonHoldsThePlaces) {
    const std::string line =
        std::to_string(line_with(run({"compile", "g.json"}).out, "s.uv0.x * 2.0"));
    const Ran ran =
        explain("failed\nERROR: 0:" + line + ": 's' : undeclared\n", {"--diagnostics", "json"});
    EXPECT_EQ(ran.code, 0);
    const json::Value list = parsed(ran.out).find("diagnostics");
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list.at(0).find("node").as_string(), "scaled");
    EXPECT_EQ(list.at(0).find("line").as_number(), 5);
    EXPECT_EQ(list.at(0).find("message").as_string(), "'s' : undeclared");
}

// Covers every language that has lines, with the log of the compiler that rejects the source.
TEST_F(ExplainLogTest, KnowsTheLinesOfEveryLanguage) {
    for (const std::string target : {"glsl330", "glsl450", "essl300", "hlsl", "msl", "wgsl"}) {
        const Names options{"--target", target, "--form", "shader", "--params", "uniform"};
        Names args{"compile", "g.json"};
        args.insert(args.end(), options.begin(), options.end());
        const std::string text = run(args).out;
        const size_t used = line_with(text, "// scaled");
        const Ran ran = explain("x.frag:" + std::to_string(used) + ":1: error: no", options);
        EXPECT_TRUE(says(ran.out, "node 'scaled'")) << target;
    }
    EXPECT_EQ(explain("0:1(1): no", {"--target", "spirv"}).code, 2);
}

TEST_F(ExplainLogTest, AsACompilerSpellsIt) {
    ASSERT_EQ(run({"compile", "g.json", "--form", "shader", "-o", "g"}).code, 0);
    std::string text = get("g.frag");
    const size_t at = text.find("s.uv0.x * 2.0");
    ASSERT_NE(at, text.npos);
    put("g.frag", text.replace(at, 7, "s.uv7.x"));
    const std::string command =
        "cd '" + folder.string() + "' && glslangValidator g.frag > log 2>&1";
    if (std::system("glslangValidator -v > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "glslangValidator is not installed (Debian package glslang-tools)";
    EXPECT_NE(std::system(command.c_str()), 0);
    const Ran ran = run({"explain-log", "g.json", "log", "--form", "shader"});
    EXPECT_TRUE(says(ran.out, "g.json:5:5: error: node 'scaled': 'uv7' : no such field"))
        << get("log");
}

TEST_F(ExplainLogTest, RefusesWhatItCannotRead) {
    put("bad.json", "{");
    put("log", "0:1(1): error: no");
    EXPECT_EQ(run({"explain-log", "bad.json", "log"}).code, 1);
    EXPECT_EQ(run({"explain-log", "g.json", "none"}).code, 1);
    for (const Names& more :
         {Names{"-", "-"}, Names{"g.json"}, Names{"g.json", "log", "--target", "x"},
          Names{"g.json", "log", "--begins-at", "0"},
          Names{"g.json", "log", "--set", "scaled.b=0:1:3"}}) {
        Names args{"explain-log"};
        args.insert(args.end(), more.begin(), more.end());
        const Ran ran = run(args);
        EXPECT_EQ(ran.code, 2) << testing::PrintToString(more);
        EXPECT_EQ(ran.out, "");
    }
}

}  // namespace
}  // namespace wrinkle::test
