// Tests of wrinkle merge, settle and check with a real Git.
#include "difference/random_edits.h"
#include "git/repository.h"

namespace wrinkle::test {
namespace {

// A material with a bump of `amount` and the color `color`.
std::string painted_bump(const std::string& amount, const std::string& color,
                         const std::string& more = "") {
    return R"({ "wrinkle": 1, "nodes": {
        "wave": { "type": "separate_vec2", "in": { "vector": { "from": "surface.uv0" } } },
        "bump": { "type": "gradient_from_height", "in": { "height": { "from": "wave.x" } } },
        "softer": { "type": "gradient_scale", "in": { "gradient": { "from": "bump.gradient" },
            "amount": )" +
           amount + R"( } },
        "normal": { "type": "resolve", "in": { "gradient": { "from": "softer.gradient" } } },
        "paint": { "type": "vec3_mix", "in": { "a": )" +
           color + R"( } })" + more + R"( },
    "outputs": { "normal": { "from": "normal.normal" }, "color": { "from": "paint.vector" } } }
)";
}

using GitMergeTest = GitTest;

// One merge of many files: each is a random pair of edits with a known result.
TEST_F(GitMergeTest, RandomEditsAreMergedByTheDriver) {
    constexpr unsigned first = 10'001, count = 20;
    std::vector<EditPair> pairs;
    for (unsigned i = 0; i < count; ++i)
        pairs.push_back(random_edits(first + i));
    const auto name = [](size_t i) { return "g" + std::to_string(i) + ".json"; };
    const auto put_all = [&](Model EditPair::*side) {
        for (size_t i = 0; i < pairs.size(); ++i)
            put(name(i), model_text(pairs[i].*side));
    };
    put_all(&EditPair::base);
    commit("base");
    checkout({"-b", "theirs"});
    put_all(&EditPair::theirs);
    commit("theirs");
    checkout({"main"});
    put_all(&EditPair::ours);
    commit("ours");
    EXPECT_EQ(git({"merge", "-q", "theirs"}).code, 1);
    const std::string unmerged = git({"diff", "--name-only", "--diff-filter=U"}).out;
    for (size_t i = 0; i < pairs.size(); ++i) {
        EXPECT_EQ(model_of(get(name(i))), model_of(model_text(pairs[i].expected))) << first + i;
        EXPECT_EQ(says(unmerged, name(i) + "\n"), !pairs[i].conflicts.empty()) << first + i;
        const json::Value list = exists(name(i) + ".conflicts")
                                     ? parsed(get(name(i) + ".conflicts")).find("conflicts")
                                     : json::Value();
        EXPECT_EQ(list.size(), pairs[i].conflicts.size()) << first + i;
    }
}

class GitConflictTest : public GitTest {
protected:
    // Commits three versions of g.json and merges; returns Git's result.
    Ran merge(const std::string& base, const std::string& ours, const std::string& theirs) {
        put("g.json", base);
        commit("base");
        checkout({"-b", "theirs"});
        put("g.json", theirs);
        commit("theirs");
        checkout({"main"});
        put("g.json", ours);
        commit("ours");
        return git({"merge", "theirs"});
    }
};

TEST_F(GitConflictTest, EditsOfOneLineAreMerged) {
    // Line-based merges conflict here: a canonical node with two inputs is one line.
    EXPECT_EQ(merge(painted_bump("1", "[1, 0, 0]"), painted_bump("0.25", "[1, 0, 0]"),
                    painted_bump("1", "[0, 1, 0]"))
                  .code,
              0);
    const json::Value nodes = parsed(get("g.json")).find("nodes");
    EXPECT_EQ(nodes.find("softer").find("in").find("amount").spelling(), "0.25");
    EXPECT_EQ(nodes.find("paint").find("in").find("a").at(1).as_number(), 1);
    EXPECT_EQ(wrinkle({"check", "g.json"}).code, 0);
}

TEST_F(GitConflictTest, CheckExplainsConflictsUntilTheyAreSettled) {
    const std::string base = painted_bump("1", "[1, 0, 0]");
    const Ran ran =
        merge(base, painted_bump("0.25", "[1, 0, 0]"), painted_bump("0.75", "[0, 1, 0]"));
    EXPECT_EQ(ran.code, 1);
    const std::string sentence = "node softer.amount: 0.25 in ours, 0.75 in theirs; it was 1";
    EXPECT_TRUE(says(ran.err, "g.json: conflict: " + sentence)) << ran.err;
    EXPECT_TRUE(says(git({"status", "--short"}).out, "UU g.json"));
    const Ran check = wrinkle({"check", "g.json"});
    EXPECT_EQ(check.code, 1);
    EXPECT_TRUE(says(check.err, ": error: node 'softer': conflict of a merge: " + sentence +
                                    " (wrinkle settle g.json softer --ours or --theirs"))
        << check.err;
    EXPECT_TRUE(check.err.starts_with("g.json:6:")) << check.err;
    EXPECT_TRUE(says(wrinkle({"check", "g.json", "--diagnostics", "json"}).err,
                     "\"rule\": \"merge-conflict\""));
    EXPECT_EQ(wrinkle({"settle", "g.json"}).code, 1);
    EXPECT_EQ(wrinkle({"settle", "g.json"}).out, sentence + "\n");
    EXPECT_EQ(wrinkle({"settle", "g.json", "paint", "--ours"}).code, 1);
    EXPECT_EQ(wrinkle({"settle", "g.json", "softer.amount", "--theirs"}).code, 0);
    EXPECT_TRUE(says(get("g.json"), "0.75"));
    EXPECT_FALSE(exists("g.json.conflicts"));
    EXPECT_EQ(wrinkle({"check", "g.json"}).code, 0);
    EXPECT_EQ(wrinkle({"settle", "g.json"}).out, "no open conflicts\n");
}

TEST_F(GitConflictTest, ANewErrorIsAConflict) {
    // One side removes the type that the other side's value is for.
    const std::string base = painted_bump("1", "[1, 0, 0]", R"(, "free": { "type": "add" })");
    const Ran ran =
        merge(base, painted_bump("1", "[1, 0, 0]", R"(, "free": { "type": "sine" })"),
              painted_bump("1", "[1, 0, 0]", R"(, "free": { "type": "add", "in": { "b": 3 } })"));
    EXPECT_EQ(ran.code, 1) << get("g.json");
    EXPECT_TRUE(says(ran.err, "node free: ")) << ran.err;
    EXPECT_TRUE(says(ran.err, "neither side had this error"));
    EXPECT_EQ(wrinkle({"settle", "g.json", "--theirs"}).code, 1);
    put("g.json", base);
    EXPECT_EQ(wrinkle({"settle", "g.json", "--current"}).code, 0);
    EXPECT_EQ(wrinkle({"check", "g.json"}).code, 0);
}

TEST_F(GitConflictTest, BothAddTheFile) {
    put("first", "x");
    commit("base");
    checkout({"-b", "theirs"});
    put("g.json", painted_bump("1", "[1, 0, 0]"));
    commit("theirs");
    checkout({"main"});
    put("g.json", painted_bump("1", "[0, 1, 0]"));
    commit("ours");
    const Ran ran = git({"merge", "theirs"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "node paint: added by both with other content")) << ran.err;
    EXPECT_EQ(parsed(get("g.json.conflicts")).find("conflicts").size(), 1U);
}

// Two merges of the same branches, with different resolutions, are merged: Git merges the common
// ancestors first. A conflict of these must not decide the second merge.
TEST_F(GitConflictTest, CrissCrossMergesKeepBothResolutions) {
    const auto version = [&](const char* amount) { return painted_bump(amount, "[1, 0, 0]"); };
    EXPECT_EQ(merge(version("1"), version("2"), version("3")).code, 1);
    put("g.json", version("2"));
    fs::remove(folder / "g.json.conflicts");
    commit("ours wins");
    checkout({"theirs"});
    EXPECT_EQ(git({"merge", "main^1"}).code, 1);
    put("g.json", version("3"));
    fs::remove(folder / "g.json.conflicts");
    commit("theirs wins");
    const Ran ran = git({"merge", "main"});
    EXPECT_EQ(ran.code, 1) << get("g.json");
    EXPECT_TRUE(says(ran.err, "node softer.amount: 3 in ours, 2 in theirs")) << ran.err;
    EXPECT_EQ(parsed(get("g.json.conflicts")).find("conflicts").size(), 1U);
}

TEST_F(GitConflictTest, DamagedGraphsAreMergedByLines) {
    const std::string base = painted_bump("1", "[1, 0, 0]");
    const Ran ran = merge(base, base + "\n", base.substr(1));
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "a side is not a valid graph: merged by lines")) << ran.err;
    EXPECT_TRUE(says(git({"status", "--short"}).out, "UU g.json"));
}

TEST_F(GitConflictTest, BytesThatAreNotTextAreLeft) {
    const Ran ran = merge("a\n", "b\n\xff\n", "c\n");
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "g.json cannot be merged: a side is not UTF-8 text")) << ran.err;
    EXPECT_EQ(get("g.json"), "b\n\xff\n");
}

TEST_F(GitConflictTest, OtherFilesAreMergedByLines) {
    const std::string lines = "1\n2\n3\n4\n5\n6\n7\n8\n";
    EXPECT_EQ(merge(lines, "0\n" + lines, lines + "9\n").code, 0);
    EXPECT_EQ(get("g.json"), "0\n" + lines + "9\n");
}

}  // namespace
}  // namespace wrinkle::test
