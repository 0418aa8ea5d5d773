// Results as JSON: a written report is read back, and hostile files are refused without a crash.
#include "report/results_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "report/hostile_results.h"
#include "support/files.h"

namespace wrinkle::test {
namespace {

using namespace report;

class ResultsJson : public testing::Test {
protected:
    std::optional<Results> read(std::string_view text) {
        problems = Diagnostics();
        return read_results(folder.put("results.json", text), problems);
    }
    // Reads a report with one check that has these members.
    std::optional<Results> read_check(const std::string& members) {
        return read(R"({"version": 1, "checks": [{)" + members + "}]}");
    }

    TemporaryFolder folder;
    Diagnostics problems;
};

TEST_F(ResultsJson, ReadsBackWhatWasWritten) {
    Results results = hostile_results();
    results.driver = "llvmpipe";
    results.command = "wrinkle test graphs";
    results.seconds = 1.5;
    for (Check& check : results.checks) {
        check.pointer = "/points/1";
        check.graph = "graphs/rings.json";
        check.inputs = "00ff";
        check.baseline = "golden/rings.png";
        check.expected_text = "a\nb";
        check.actual_text = "a\nc";
        check.nodes_of_lines = {"", "weave"};
        check.map_image = "map.png";
        check.joined_image = "joined.png";
        check.map_measure = "flip";
        check.map_scale = 0.25;
        check.width = check.height = 128;
    }
    const std::string text = to_json(results);
    const auto read_back = read(text);
    ASSERT_TRUE(read_back) << to_text(problems);
    const std::string again = to_json(*read_back);  // bytes that are not UTF-8 are replaced
    EXPECT_TRUE(to_json(*read(again)) == again);
    EXPECT_TRUE(read_back->checks[1].message.starts_with("differs: <a href=\"x\">'&amp;' ]]>"));
    ASSERT_EQ(read_back->checks.size(), results.checks.size());
    const Check& check = read_back->checks[1];
    EXPECT_EQ(check.id(), "graphs/rings.old/points/1");
    EXPECT_EQ(check.status, Status::failed);
    EXPECT_EQ(check.kind, CheckKind::point);
    EXPECT_EQ(check.line, 7U);
    ASSERT_EQ(check.measured.size(), 2U);
    EXPECT_EQ(check.measured[0].value, 90);
    EXPECT_EQ(check.measured[0].unit, "degrees");
    EXPECT_EQ(check.nodes_of_lines, (std::vector<std::string>{"", "weave"}));
    EXPECT_EQ(read_back->count(Status::failed), results.count(Status::failed));
}

TEST_F(ResultsJson, NumbersThatAreNotFiniteAreNull) {
    Results results;
    Check& check = results.checks.emplace_back();
    check.measured = {{"alu", "", "", "", std::numeric_limits<double>::quiet_NaN(), 1, ""}};
    const std::string text = to_json(results);
    EXPECT_NE(text.find("\"value\": null"), text.npos) << text;
    const auto read_back = read(text);
    ASSERT_TRUE(read_back) << to_text(problems);
    EXPECT_TRUE(std::isnan(read_back->checks[0].measured[0].value));
    EXPECT_FALSE(read_back->checks[0].measured[0].within());
}

TEST_F(ResultsJson, RefusesTextsThatAreNoReport) {
    for (const char* text : {"",
                             "{",
                             "[]",
                             "1",
                             "null",
                             "\"version\"",
                             "{}",
                             R"({"version": 2})",
                             R"({"version": "1"})",
                             R"({"version": null})",
                             R"({"version": [1]})",
                             R"({"version": 1, "checks": {}})",
                             R"({"version": 1, "checks": [1]})",
                             R"({"version": 1, "checks": [[]]})",
                             R"({"version": 1, "seconds": "1"})",
                             R"({"version": 1, "seconds": NaN})",
                             R"({"version": 1, "seconds": 1e999})",
                             R"({"version": 1, "problems": [1]})",
                             R"({"version": 1, "problems": "x"})",
                             "{\"version\": 1, \"driver\": \"\xFF\"}",
                             R"({"version": 1, "version": 1})"}) {
        EXPECT_FALSE(read(text)) << text;
        EXPECT_TRUE(problems.has_errors()) << text;
    }
    std::string deep = R"({"version": 1, "checks": )";
    deep.append(100'000, '[');
    EXPECT_FALSE(read(deep));
    EXPECT_FALSE(read_results(folder.path() / "missing.json", problems));
    EXPECT_FALSE(read_results(folder.path(), problems));
}

TEST_F(ResultsJson, RefusesMembersOfAnotherKind) {
    for (const char* members :
         {R"("test": 1)", R"("status": "fine")", R"("status": 1)", R"("kind": "points")",
          R"("line": -1)", R"("line": 1.5)", R"("line": 4294967296)", R"("line": "1")",
          R"("line": null)", R"("measured": {})", R"("measured": [{"value": "x"}])",
          R"("measured": [3])", R"("nodes_of_lines": [1])", R"("width": -0.5)",
          R"("seconds": true)"}) {
        EXPECT_FALSE(read_check(members)) << members;
        ASSERT_TRUE(problems.has_errors()) << members;
        EXPECT_GT(problems.list()[0].where.line, 0U) << members;
    }
}

TEST_F(ResultsJson, RefusesImagesOutsideItsFolder) {
    for (const char* image :
         {"/etc/passwd", "../x.png", "a/../../x.png", "..", "a/..", "a/../b.png"})
        for (const char* member : {"expected_image", "actual_image", "map_image", "joined_image"}) {
            EXPECT_FALSE(read_check("\"" + std::string(member) + "\": \"" + image + "\"")) << image;
            EXPECT_EQ(problems.list()[0].rule, RuleId::outside_root);
        }
    EXPECT_TRUE(read_check(R"("actual_image": "a/b..png")")) << to_text(problems);
}

TEST_F(ResultsJson, MissingMembersHaveDefaultsAndUnknownOnesAreIgnored) {
    const auto results = read(R"({"version": 1, "later": {}, "checks": [{"more": [1]}]})");
    ASSERT_TRUE(results) << to_text(problems);
    EXPECT_EQ(results->checks[0].status, Status::passed);
    EXPECT_EQ(results->checks[0].measured.size(), 0U);
}

}  // namespace
}  // namespace wrinkle::test
