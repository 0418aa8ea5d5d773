// Tests of the conventions that all commands share.
#include <regex>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

using ConventionsTest = CliTest;
using Names = std::vector<std::string>;

const Names commands = {"check",  "compile",  "eval",       "render",     "convert",
                        "lint",   "test",     "format",     "upgrade",    "inputs",
                        "nodes",  "plugins",  "new-plugin", "completion", "explain-log",
                        "bake",   "import",   "compare",    "diff",       "merge",
                        "settle", "textconv", "git-setup",  "watch",      "export"};

TEST_F(ConventionsTest, HelpListsEveryCommand) {
    const Ran ran = run({"--help"});
    EXPECT_EQ(ran.code, 0);
    EXPECT_EQ(ran.err, "");
    for (const std::string& command : commands) {
        EXPECT_TRUE(says(ran.out, "  " + command));
        const Ran one = run({command, "--help"});
        EXPECT_EQ(one.code, 0) << command;
        EXPECT_NE(one.out, "");
        EXPECT_EQ(one.err, "");
    }
}

TEST_F(ConventionsTest, VersionHasBuildAndLicence) {
    const Ran ran = run({"--version"});
    EXPECT_EQ(ran.code, 0);
    const std::regex lines(
        "wrinkle [0-9]+\\.[0-9]+\\.[0-9]+\n"
        "Built by [A-Za-z]+ [0-9.]+, [A-Za-z]+, [a-z0-9_]+\n"
        "MIT License\\. .*licences\\.md\\.\n");
    EXPECT_TRUE(std::regex_match(ran.out, lines)) << ran.out;
}

TEST_F(ConventionsTest, TargetsAreListedByEveryCommandThatReadsGraphs) {
    const Ran list = run({"compile", "--list-targets"});
    EXPECT_EQ(list.code, 0) << list.err;
    EXPECT_TRUE(says(list.out, "glsl"));
    for (const char* command : {"check", "eval", "render", "test", "nodes"})
        EXPECT_EQ(run({command, "--list-targets"}).out, list.out) << command;
}

TEST_F(ConventionsTest, OneBadFileOfSeveralLeavesAllAsTheyAre) {
    const std::string loose = "{\"nodes\": {}, \"wrinkle\": 1}";
    put("a.json", loose);
    put("b.json", "{");
    EXPECT_EQ(run({"format", "a.json", "b.json"}).code, 1);
    EXPECT_EQ(get("a.json"), loose);
}

TEST_F(ConventionsTest, WrongUsageIsTwo) {
    for (const Names& args :
         {Names{}, Names{"bake-a-cake"}, Names{"check"}, Names{"check", "--nonsense", "g.json"},
          Names{"check", "g.json", "--diagnostics", "xml"}, Names{"test"}, Names{"format"},
          Names{"nodes", "--json", "--markdown"}}) {
        const Ran ran = run(args, "x");
        EXPECT_EQ(ran.code, 2) << testing::PrintToString(args);
        EXPECT_EQ(ran.out, "");
        EXPECT_NE(ran.err, "");
    }
}

TEST_F(ConventionsTest, StandardInputIsReadOnlyWhenAsked) {
    put("g.json", tilt_graph());
    const std::string at = R"({"normal": [0, 0, 1]})";
    for (const Names& args :
         {Names{"check", "g.json"}, Names{"compile", "g.json"}, Names{"eval", "g.json", "--at", at},
          Names{"format", "--check", "g.json"},
          Names{"render", "g.json", "-o", "g.png", "--size", "8x8"}, Names{"nodes"},
          Names{"plugins"}}) {
        const Ran ran = run(args, "not for you");
        EXPECT_EQ(ran.read, 0) << args[0];
    }
    EXPECT_GT(run({"check", "-"}, tilt_graph()).read, 0);
}

TEST_F(ConventionsTest, DiagnosticsAsJson) {
    put("bad.json", "{\"wrinkle\": 1, \"nodes\": {\"x\": {\"type\": \"nothing\"}}}");
    for (const Names& args :
         {Names{"check", "bad.json"}, Names{"compile", "bad.json"},
          Names{"eval", "bad.json", "--at", "{}"}, Names{"render", "bad.json", "-o", "x.png"}}) {
        Names with = args;
        with.insert(with.end(), {"--diagnostics", "json"});
        const Ran ran = run(with);
        EXPECT_EQ(ran.code, 1);
        const json::Value list = parsed(ran.err).find("diagnostics");
        ASSERT_GE(list.size(), 1u) << args[0];
        EXPECT_EQ(list.at(0).find("file").as_string(), "bad.json");
        EXPECT_EQ(list.at(0).find("line").as_number(), 1);
        EXPECT_EQ(list.at(0).find("node").as_string(), "x");
        EXPECT_EQ(list.at(0).find("severity").as_string(), "error");
        EXPECT_EQ(list.at(0).find("rule").as_string(), "unknown-node-type");
    }
    put("good.json", tilt_graph());
    const Ran fine = run({"check", "good.json", "--diagnostics", "json"});
    EXPECT_EQ(fine.code, 0);
    EXPECT_EQ(parsed(fine.err).find("diagnostics").size(), 0u);
}

TEST_F(ConventionsTest, DiagnosticsForCodeScanningNameFilesOfTheRepository) {
    std::filesystem::create_directories(folder.parent_path() / ".git");
    put("a b.json", "{\"wrinkle\": 1, \"nodes\": {\"x\": {\"type\": \"nothing\"}}}");
    const Ran scanned = run({"check", "a b.json", "--diagnostics", "sarif"});
    EXPECT_EQ(scanned.code, 1);
    const json::Value result = parsed(scanned.err).find("runs").at(0).find("results").at(0);
    EXPECT_EQ(result.find("ruleId").as_string(), "unknown-node-type");
    const json::Value place = result.find("locations").at(0).find("physicalLocation");
    EXPECT_EQ(place.find("artifactLocation").find("uri").as_string(), "work/a%20b.json");
    const Ran annotated = run({"check", "a b.json", "--diagnostics", "github"});
    EXPECT_EQ(annotated.code, 1);
    EXPECT_TRUE(annotated.err.starts_with(
        "::error file=work/a b.json,line=1,col=26,title=unknown-node-type::node 'x': "))
        << annotated.err;
    put("good.json", tilt_graph());
    EXPECT_EQ(run({"check", "good.json", "--diagnostics", "github"}).err, "");
    const Ran fine = run({"check", "good.json", "--diagnostics", "sarif"});
    EXPECT_EQ(parsed(fine.err).find("runs").at(0).find("results").size(), 0U);
}

TEST_F(ConventionsTest, OptionsMayStandBeforeTheFile) {
    put("g.json", ramp_graph());
    const Ran ran = run({"eval", "--at", R"({"uv0": [1, 0]})", "--set", "scaled.b=3", "--set",
                         "scaled.a=5", "--plugin-path", ".", "g.json"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(says(ran.out, "{\"value\": 15}"));
}

TEST_F(ConventionsTest, RootIsAFence) {
    put("inner/value.json", R"({"wrinkle": 1, "nodes": {"m": {"type": "add"}},
        "outputs": {"value": {"from": "m.result"}}})");
    put("tops/g.json", R"({"wrinkle": 1, "nodes": {"s": {"type": "graph:../inner/value.json"}},
        "outputs": {"value": {"from": "s.value"}}})");
    EXPECT_EQ(run({"check", "tops/g.json"}).code, 1);
    const Ran ran = run({"check", "tops/g.json", "--root", "."});
    EXPECT_EQ(ran.code, 0) << ran.err;
}

TEST_F(ConventionsTest, FormatMakesCanonicalAndChecks) {
    const std::string loose = "{\"nodes\": {}, \"wrinkle\": 1}";
    put("g.json", loose);
    const Ran check = run({"format", "--check", "g.json"});
    EXPECT_EQ(check.code, 1);
    EXPECT_EQ(get("g.json"), loose);
    const Ran printed = run({"format", "-"}, loose);
    EXPECT_EQ(printed.code, 0);
    EXPECT_EQ(run({"format", "g.json"}).code, 0);
    EXPECT_EQ(get("g.json"), printed.out);
    EXPECT_EQ(run({"format", "--check", "g.json"}).code, 0);
    EXPECT_EQ(run({"upgrade", "--check", "g.json"}).code, 0);
}

TEST_F(ConventionsTest, NodesAreExplained) {
    EXPECT_TRUE(says(run({"nodes"}).out, "resolve"));
    EXPECT_TRUE(says(run({"nodes", "resolve"}).out, "gradient"));
    EXPECT_TRUE(says(run({"nodes", "Noise"}).err, "with that word: gradient_noise, "));
    EXPECT_TRUE(parsed(run({"nodes", "--json"}).out).has("nodes"));
    EXPECT_GT(parsed(run({"nodes", "--schema"}).out).size(), 0u);
    const Ran unknown = run({"nodes", "resolv"});
    EXPECT_EQ(unknown.code, 1);
    EXPECT_TRUE(says(unknown.err, "did you mean 'resolve'?"));
}

TEST_F(ConventionsTest, PluginsThatAreNoneAreNamed) {
    put("p.so", "not a library");
    const Ran listed = run({"plugins", "--plugin-path", "p.so"});
    EXPECT_EQ(listed.code, 1);
    EXPECT_TRUE(says(listed.out + listed.err, "p.so"));
    EXPECT_EQ(run({"plugins"}, "", {"WRINKLE_PLUGIN_PATH=/nonexistent/p.so"}).code, 1);
    EXPECT_EQ(run({"plugins"}).code, 0);
}

}  // namespace
}  // namespace wrinkle::test
