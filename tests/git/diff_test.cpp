// Tests of wrinkle diff, textconv and git-setup, with a real Git.
#include "git/repository.h"

namespace wrinkle::test {
namespace {

using GitDiffTest = GitTest;

TEST_F(GitDiffTest, GitShowsNodes) {
    put("g.json", ramp_graph("2"));
    commit("two");
    put("g.json", ramp_graph("3"));
    const Ran diff = git({"diff"});
    EXPECT_TRUE(says(diff.out, "\n-node scaled.b = 2\n+node scaled.b = 3\n")) << diff.out;
    commit("three");
    EXPECT_TRUE(says(git({"log", "-p", "-1"}).out, "\n+node scaled.b = 3\n"));
    EXPECT_TRUE(says(git({"show", "HEAD~1"}).out, "\n+node scaled.b = 2\n"));
    EXPECT_EQ(git({"difftool", "-y", "-t", "wrinkle", "HEAD~1"}).out,
              "  node scaled.b: 2 -> 3\ndifferent\n");
}

TEST_F(GitDiffTest, LayoutIsNotShown) {
    const std::string graph = ramp_graph();
    put("g.json", graph);
    commit("graph");
    put("g.json", graph.substr(0, graph.rfind('}')) + ", \"layout\": {\"scaled\": [1, 2]}}");
    EXPECT_FALSE(says(git({"diff"}).out, "@@"));
    const Ran diff = wrinkle({"diff", "HEAD:g.json", "g.json"});
    EXPECT_EQ(diff.code, 0);
    EXPECT_EQ(diff.out, "layout: 1 position added\nother layout, same material\n");
}

TEST_F(GitDiffTest, SetupIsIdempotentAndRemoved) {
    const std::string attributes = get(".gitattributes"), config = get(".git/config");
    EXPECT_EQ(wrinkle({"git-setup"}).code, 0);
    EXPECT_EQ(get(".gitattributes"), attributes);
    EXPECT_EQ(get(".git/config"), config);
    put(".gitattributes", "*.png binary\n" + attributes + "*.txt text\n");
    EXPECT_EQ(wrinkle({"git-setup", "materials/*.json"}).code, 0);
    EXPECT_EQ(git({"check-attr", "diff", "materials/a.json"}).out,
              "materials/a.json: diff: wrinkle\n");
    EXPECT_EQ(git({"check-attr", "diff", "a.json"}).out, "a.json: diff: unspecified\n");
    EXPECT_EQ(wrinkle({"git-setup", "--remove"}).code, 0);
    EXPECT_EQ(get(".gitattributes"), "*.png binary\n*.txt text\n");
    EXPECT_FALSE(says(get(".git/config"), "wrinkle"));
    EXPECT_EQ(wrinkle({"git-setup", "--remove"}).code, 0);
    EXPECT_EQ(wrinkle({"git-setup", "--show"}).code, 0);
    EXPECT_FALSE(says(get(".git/config"), "wrinkle"));
}

TEST_F(GitDiffTest, SetupWorksInASubfolderAndNeedsARepository) {
    put("sub/x", "x");
    const fs::path top = std::exchange(folder, folder / "sub");
    EXPECT_EQ(wrinkle({"git-setup", "--remove"}).code, 0);
    folder = top;
    EXPECT_FALSE(exists(".gitattributes"));
    fs::remove_all(folder / ".git");
    const Ran ran = run({"git-setup"}, "", {"GIT_CEILING_DIRECTORIES=/"});
    EXPECT_EQ(ran.code, 3);
    EXPECT_TRUE(says(ran.err, "not in a Git work tree")) << ran.err;
}

using DiffTest = CliTest;

TEST_F(DiffTest, VerdictsAndExitCodes) {
    put("a.json", ramp_graph("2"));
    put("b.json", ramp_graph("2.0"));
    put("c.json", ramp_graph("3"));
    EXPECT_EQ(run({"diff", "a.json", "a.json"}).out, "same\n");
    const Ran text = run({"diff", "a.json", "b.json"});
    EXPECT_EQ(text.out, "other text, same material\n");
    EXPECT_EQ(text.code, 0);
    EXPECT_EQ(run({"diff", "a.json", "c.json"}).code, 1);
    EXPECT_EQ(run({"diff", "a.json", "c.json", "--exit-zero"}).code, 0);
    const json::Value root = parsed(run({"diff", "a.json", "c.json", "--json"}).out);
    EXPECT_FALSE(root.find("same").as_boolean());
    const json::Value change = root.find("changes").at(0);
    EXPECT_EQ(change.find("section").as_string(), "nodes");
    EXPECT_EQ(change.find("id").as_string(), "scaled");
    EXPECT_EQ(change.find("port").as_string(), "b");
    EXPECT_EQ(change.find("before").as_number(), 2);
    EXPECT_EQ(change.find("after").as_number(), 3);
}

TEST_F(DiffTest, TroubleIsTwo) {
    put("a.json", ramp_graph());
    put("broken.json", "{");
    EXPECT_EQ(run({"diff", "a.json", "missing.json"}).code, 2);
    EXPECT_EQ(run({"diff", "a.json", "HEAD:a.json"}).code, 2);
    EXPECT_EQ(run({"diff", "a.json"}).code, 2);
    const Ran ran = run({"diff", "a.json", "broken.json"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(says(ran.err, "broken.json:1:2: error: "));
}

TEST_F(DiffTest, TextconvPrintsOtherFilesUnchanged) {
    put("a.json", ramp_graph());
    EXPECT_TRUE(run({"textconv", "a.json"}).out.starts_with("node scaled: type = \"multiply\"\n"))
        << run({"textconv", "a.json"}).out;
    for (const char* text : {"{", "", "[1]\n", "{\"name\": \"package\"}\n", "{\"wrinkle\": 1"}) {
        put("other.json", text);
        const Ran ran = run({"textconv", "other.json"});
        EXPECT_EQ(ran.code, 0);
        EXPECT_EQ(ran.out, text);
    }
    EXPECT_EQ(run({"textconv", "missing.json"}).code, 1);
}

}  // namespace
}  // namespace wrinkle::test
