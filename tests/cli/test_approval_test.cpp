// Tests of approval: reports, --accept, --review, --update, shards and files without a case.
#include <set>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

class ApprovalTest : public CliTest {
protected:
    // Three cases of one graph that all changed, and a new one of another.
    void SetUp() override {
        CliTest::SetUp();
        put("t/a.json", tilt_graph("0.75"));
        put("t/a.test.json", R"({
  "points": [{ "normal": [0, 0, 1] }, { "normal": [0, 1, 0] }],
  "glsl": true,
  "render": { "mesh": "plane", "size": "24x24", "view": "normal" }
}
)");
        ASSERT_EQ(run({"test", "t", "--update"}).code, 0);
        put("t/a.json", tilt_graph("0.25"));
        put("t/b.json", tilt_graph("0.5"));
        put("t/b.test.json", R"({"glsl": true})");
    }

    Ran test(std::vector<std::string> words = {}, const std::string& input = "") const {
        words.insert(words.begin(), "test");
        return run(words, input, {"CI="});
    }

    // Bytes of all baselines.
    std::string baselines() const {
        std::string all = get("t/a.test.json");
        for (const char* name : {"t/golden/a.glsl", "t/golden/a.png", "t/golden/b.glsl"})
            all += exists(name) ? get(name) : "none";
        return all;
    }
};

TEST_F(ApprovalTest, ARunWritesOnlyItsReport) {
    const std::string before = baselines();
    const Ran ran = test({"t"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.out, "NEW t/b/glsl: t/golden/b.glsl does not exist yet"));
    EXPECT_TRUE(says(ran.out, "report: .wrinkle/test/index.html"));
    EXPECT_TRUE(ran.out.ends_with("0 passed, 4 failed, 1 new\n")) << ran.out;
    EXPECT_EQ(baselines(), before);
    EXPECT_EQ(get(".wrinkle/.gitignore"), "*\n");
    for (const char* name : {"index.html", "results.json", "expected/t-a.png", "actual/t-a.png"})
        EXPECT_TRUE(exists(".wrinkle/test/" + std::string(name))) << name;
}

TEST_F(ApprovalTest, AcceptedResultsPass) {
    test({"t"});
    const Ran accepted = test({"--accept", "all"});
    EXPECT_EQ(accepted.code, 0) << accepted.err;
    EXPECT_EQ(accepted.out, "t/golden/a.glsl\nt/golden/a.png\nt/a.test.json\nt/golden/b.glsl\n");
    EXPECT_EQ(test({"t"}).out, "5 passed, 0 failed\n");
    EXPECT_FALSE(exists(".wrinkle/test/index.html"));
    EXPECT_FALSE(exists(".wrinkle/test/actual"));
}

TEST_F(ApprovalTest, AcceptTakesOnlyTheNamed) {
    test({"t"});
    EXPECT_EQ(test({"--accept", "new"}).out, "t/golden/b.glsl\n");
    EXPECT_EQ(test({"--accept", "t/a/points/1", "t/a/glsl"}).out,
              "t/golden/a.glsl\nt/a.test.json\n");
    const Ran rest = test({"t"});
    EXPECT_TRUE(says(rest.out, "FAIL t/a/points/0: "));
    EXPECT_TRUE(says(rest.out, "FAIL t/a/render: "));
    EXPECT_TRUE(rest.out.ends_with("3 passed, 2 failed\n")) << rest.out;
    EXPECT_EQ(test({"--accept", "t"}).code, 0);
    EXPECT_EQ(test({"t"}).code, 0);
}

TEST_F(ApprovalTest, NamesOfNothingAreErrorsAndNothingIsWritten) {
    test({"t"});
    const std::string before = baselines();
    for (const char* name : {"t/a/point", "a", "deleted", "t/a/glsl/x", "T"}) {
        const Ran ran = test({"--accept", "new", name});
        EXPECT_EQ(ran.code, 1) << name;
        EXPECT_TRUE(says(ran.err, "--accept " + std::string(name)));
    }
    EXPECT_EQ(baselines(), before);
}

TEST_F(ApprovalTest, ResultsThatAreOutOfDateAreRefused) {
    test({"t"});
    const std::string before = baselines();
    put("t/a.json", tilt_graph("0.3"));
    const Ran ran = test({"--accept", "changed"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(
        says(ran.err, "t/a/points/0: its files changed after the run; run the tests again"));
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(baselines(), before);
}

TEST_F(ApprovalTest, AnEntryThatWasEditedAfterTheRunIsRefused) {
    test({"t"});
    std::string text = get("t/a.test.json");
    const size_t number = text.find("-0.6");
    ASSERT_NE(number, text.npos) << text;
    put("t/a.test.json", text.replace(number, 4, "-0.5"));
    const Ran ran = test({"--accept", "t/a/points/0"});
    EXPECT_TRUE(says(ran.err, "its entry of 'expect' changed after the run"));
    EXPECT_EQ(get("t/a.test.json"), text);
}

TEST_F(ApprovalTest, ReviewAsksForEach) {
    test({"t"});
    const Ran ran = test({"--review"}, "d\ns\na\nr\nR\n");
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(says(ran.out, "5 to review"));
    EXPECT_TRUE(says(ran.out, "2 of 5  t/a/points/1"));
    EXPECT_TRUE(says(ran.out, "wrote t/a.test.json"));
    // Skipped: still pending. Rejected: found again by the next run.
    const Ran left = test({"--review"}, "q\n");
    EXPECT_TRUE(says(left.out, "1 to review"));
    EXPECT_TRUE(says(left.out, "t/a/points/0"));
    EXPECT_TRUE(test({"t"}).out.ends_with("1 passed, 3 failed, 1 new\n"));
    EXPECT_TRUE(says(test({"t", "--review"}, "A\n").out, "wrote t/golden/b.glsl"));
    EXPECT_EQ(test({"t"}).code, 0);
}

TEST_F(ApprovalTest, AnInterruptedReviewLosesNothing) {
    test({"t"});
    EXPECT_EQ(test({"--review"}, "a\n").code, 0);
    EXPECT_TRUE(says(test({"--review"}).out, "4 to review"));
}

TEST_F(ApprovalTest, GoldenFilesWithoutACaseFail) {
    test({"t", "--update"});
    put("t/golden/old.png", "image");
    put("t/golden/notes.txt", "mine");
    const Ran ran = test({"t"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.out, "DELETED t/golden/old.png: no case reads this golden file"));
    EXPECT_TRUE(ran.out.ends_with("5 passed, 0 failed, 1 deleted\n")) << ran.out;
    EXPECT_EQ(test({"t/a.test.json"}).code, 0);
    EXPECT_EQ(test({"t", "--update"}).code, 1);
    EXPECT_TRUE(exists("t/golden/old.png"));
    EXPECT_EQ(test({"--accept", "deleted"}).out, "t/golden/old.png: removed\n");
    EXPECT_FALSE(exists("t/golden/old.png"));
    EXPECT_TRUE(exists("t/golden/notes.txt"));
    EXPECT_EQ(test({"t"}).code, 0);
}

TEST_F(ApprovalTest, ARenamedCaseIsNewAndDeleted) {
    put("t/b.test.json", R"({"cases": [{"name": "old", "glsl": true}]})");
    test({"t", "--update"});
    put("t/b.test.json", R"({"cases": [{"name": "other", "glsl": true}]})");
    const Ran ran = test({"t"});
    EXPECT_TRUE(says(ran.out, "NEW t/b.other/glsl"));
    EXPECT_TRUE(says(ran.out, "DELETED t/golden/b.old.glsl"));
}

TEST_F(ApprovalTest, ShardsAreOneRun) {
    for (int i = 0; i < 20; ++i) {
        const std::string name = "t/more" + std::to_string(i);
        put(name + ".json", tilt_graph("0.5"));
        put(name + ".test.json", R"({"glsl": true})");
    }
    put("t/golden/unread.glsl", "text");
    const Ran all = test({"t", "--report", "all"});
    for (const char* part : {"1/3", "2/3", "3/3"})
        EXPECT_NE(test({"t", "--shard", part, "--report", std::string("part") + part[0]}).out,
                  all.out);
    const Ran merged = test({"--merge", "part1", "part2", "part3", "--report", "merged"});
    EXPECT_EQ(merged.code, 1);
    const auto checks = [&](const std::string& report) {
        std::set<std::string> ids;
        const json::Value list = parsed(get(report + "/results.json")).find("checks");
        for (const json::Member& check : list.children())
            EXPECT_TRUE(ids.insert(std::string(check.value.find("test").as_string()) + "/" +
                                   std::string(check.value.find("name").as_string()) + " " +
                                   std::string(check.value.find("status").as_string()))
                            .second);
        return ids;
    };
    EXPECT_EQ(checks("merged"), checks("all"));
    EXPECT_EQ(checks("all").size(), 26U);
    EXPECT_TRUE(merged.out.ends_with("0 passed, 4 failed, 21 new, 1 deleted\n")) << merged.out;
    EXPECT_TRUE(exists("merged/actual/t-a.png"));
    EXPECT_EQ(test({"--report", "merged", "--accept", "all"}).code, 0);
    EXPECT_EQ(test({"t"}).code, 0);
}

TEST_F(ApprovalTest, WrongUsageIsTwo) {
    test({"t"});
    using Words = std::vector<std::string>;
    for (const Words& words :
         {Words{"t", "--shard", "0/2"}, Words{"t", "--shard", "3/2"}, Words{"t", "--shard", "1"},
          Words{"t", "--update", "--review"}, Words{"--accept", "all", "--update"},
          Words{"t", "--ci", "--update"}, Words{"--merge", "a"}, Words{"t", "-j", "-1"}})
        EXPECT_EQ(test(words).code, 2) << testing::PrintToString(words);
    fs::remove_all(folder / ".wrinkle");
    const Ran none = test({"--accept", "all"});
    EXPECT_EQ(none.code, 2);
    EXPECT_TRUE(says(none.err, "run `wrinkle test PATH` first"));
}

TEST_F(ApprovalTest, HostileReportsAreRefused) {
    test({"t"});
    const std::string good = get(".wrinkle/test/results.json");
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        EXPECT_NE(text.find(from), text.npos) << from;
        return text.replace(text.find(from), from.size(), to);
    };
    put("secret.png", "secret");
    const std::string before = baselines();
    for (const std::string& text :
         {std::string("{}"), std::string("["), std::string(),
          with("\"version\": 1", "\"version\": 2"), with("actual/t-a.png", "../../secret.png"),
          with("actual/t-a.png", "/etc/passwd"), with("\"status\": \"failed\"", "\"status\": 3"),
          with("\"line\": 2", "\"line\": -1")}) {
        put(".wrinkle/test/results.json", text);
        EXPECT_EQ(test({"--accept", "t/a/render"}).code, 1) << text.substr(0, 80);
        EXPECT_EQ(baselines(), before);
    }
}

TEST_F(ApprovalTest, AReportThatCannotBeWrittenLetsTheCasesRun) {
    put("file", "");
    const Ran ran = test({"t", "--report", "file/below"});
    EXPECT_EQ(ran.code, 3);
    EXPECT_TRUE(says(ran.err, "file/below"));
    EXPECT_TRUE(ran.out.ends_with("0 passed, 4 failed, 1 new\n")) << ran.out;
}

TEST_F(ApprovalTest, CiSystemsGetTheirFormats) {
    const Ran ran =
        test({"t", "--junit", "j/r.xml", "--tap", "r.tap", "--github", "--report", "out"});
    EXPECT_EQ(ran.code, 3) << "the folder j is missing";
    fs::create_directories(folder / "j");
    const auto attachment = [&](const std::string& base) {
        EXPECT_EQ(test({"t", "--junit", "j/r.xml", "--report", "out", "--attachments", base}).code,
                  1);
        const std::string xml = get("j/r.xml");
        const size_t begin = xml.find("[[ATTACHMENT|");
        return begin == xml.npos ? "" : xml.substr(begin + 13, xml.find("]]", begin) - begin - 13);
    };
    EXPECT_EQ(attachment("project"), "out/joined/t-a.png");
    EXPECT_EQ(attachment("xml"), "../out/joined/t-a.png");
    EXPECT_EQ(attachment("absolute"), folder / "out/joined/t-a.png");
    EXPECT_EQ(attachment("none"), "");
    EXPECT_TRUE(exists("out/joined/t-a.png"));
    EXPECT_TRUE(says(get("j/r.xml"), "tests=\"5\" failures=\"4\" errors=\"0\" skipped=\"1\""));
    EXPECT_TRUE(says(test({"t", "--ci", "--tap", "r.tap", "--github"}).out,
                     "::error file=t/a.test.json,line=2"));
    EXPECT_TRUE(says(get("r.tap"), "not ok 5 - t/b/glsl"));
}

TEST_F(ApprovalTest, AnnotationsNameFilesFromTheRootOfTheRepository) {
    fs::create_directories(folder / ".git");
    folder /= "t";
    EXPECT_TRUE(says(test({".", "--github"}).out, "::error file=t/a.test.json,line=2"));
}

TEST_F(ApprovalTest, CachedImagesAreThoseThatWouldBeDrawn) {
    const std::vector<std::string> words = {"t/a.test.json", "--cache", "cache"};
    const Ran first = test(words), second = test(words);
    EXPECT_EQ(first.out, second.out);
    EXPECT_EQ(first.out, test({"t/a.test.json"}).out);
    ASSERT_EQ(test({"t", "--update", "--cache", "cache"}).code, 0);
    put("t/a.json", tilt_graph("0.75"));
    EXPECT_TRUE(says(test(words).out, "FAIL t/a/render"));
    put("t/a.json", tilt_graph("0.25"));
    EXPECT_EQ(test(words).code, 0);
    // Damaged entries are drawn again.
    for (const auto& entry : fs::recursive_directory_iterator(folder / "cache"))
        if (entry.is_regular_file()) fs::resize_file(entry.path(), entry.file_size() / 2);
    EXPECT_EQ(test(words).code, 0);
}

TEST_F(ApprovalTest, ThreadsGiveTheSameOutput) {
    EXPECT_EQ(test({"t", "-j", "1"}).out, test({"t", "-j", "3"}).out);
}

TEST_F(ApprovalTest, ImagesAreHeldToEachLimit) {
    test({"t", "--update"});
    put("t/a.json", tilt_graph("0.26"));  // 0.54 degrees
    const auto with = [&](const std::string& limits) {
        put("t/a.test.json",
            R"({"render": {"mesh": "plane", "size": "24x24", "view": "normal", )" + limits + "}}");
        return test({"t/a.test.json"});
    };
    EXPECT_EQ(with(R"("tolerance": 1)").code, 0);
    EXPECT_EQ(with(R"("metric": "degrees", "tolerance": 0.8)").code, 0);
    EXPECT_TRUE(
        says(with(R"("metric": "degrees", "tolerance": 0.3)").out, " degrees, 0.3 allowed"));
    EXPECT_EQ(with(R"("metric": "degrees", "tolerance": 0.8, "max_pixel": 0.9)").code, 0);
    EXPECT_EQ(with(R"("metric": "degrees", "tolerance": 0.8, "max_pixel": 0.3)").code, 1);
    EXPECT_TRUE(
        says(with(R"("tolerance": 1, "over": 0.1, "max_over": 0)").out, " pixels, 0 allowed"));
    EXPECT_EQ(with(R"("tolerance": 1, "over": 20, "max_over": 0)").code, 0);
    EXPECT_EQ(with(R"("metric": "flip", "tolerance": 0.5)").code, 0);
    EXPECT_TRUE(says(with(R"("metric": "flip", "tolerance": 0)").out, " FLIP, 0 allowed"));
}

TEST_F(ApprovalTest, BudgetsAreLimitsOfTheCost) {
    const auto with = [&](const std::string& budget) {
        put("t/b.test.json", R"({"budget": {)" + budget + "}}");
        return test({"t/b.test.json"});
    };
    EXPECT_EQ(with(R"("alu": 1000, "texture_reads": 0, "text_bytes": 5000)").out,
              "1 passed, 0 failed\n");
    const Ran slow = with(R"("alu": 1, "texture_reads": 0, "text_bytes": 9)");
    EXPECT_EQ(slow.code, 1);
    EXPECT_TRUE(says(slow.out, "FAIL t/b/budget: alu is "));
    EXPECT_TRUE(says(slow.out, ", 1 allowed, most of it in "));
    EXPECT_TRUE(says(slow.out, "; text_bytes is "));
    EXPECT_EQ(slow.out.find("texture_reads"), slow.out.npos);
    EXPECT_EQ(test({"--accept", "all"}).code, 1);
}

}  // namespace
}  // namespace wrinkle::test
