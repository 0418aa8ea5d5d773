// Tests of JUnit XML, TAP and annotations: structure, counts and escapes.
#include "report/ci_formats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace wrinkle::report {
namespace {

class CiFormatsTest : public testing::Test {
protected:
    Check& add(const std::string& test, const std::string& name, Status status) {
        Check& check = results.checks.emplace_back();
        check.test = test;
        check.name = name;
        check.file = test + ".test.json";
        check.line = 3;
        check.column = 5;
        check.status = status;
        if (status != Status::passed) check.message = "differs";
        return check;
    }

    Results results;
    CiOptions options;
};

TEST_F(CiFormatsTest, JunitHasASuiteForEachCase) {
    add("graphs/a", "glsl", Status::passed).seconds = 0.25;
    add("graphs/a", "points/0", Status::failed);
    add("graphs/b", "render", Status::error);
    add("graphs/b", "glsl", Status::added);
    add("graphs/golden", "c.png", Status::deleted);
    results.started = "2026-01-02T03:04:05Z";
    EXPECT_EQ(junit(results, options), R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="wrinkle test" tests="5" failures="2" errors="1" skipped="1" time="0.250000">
  <testsuite name="graphs/a" tests="2" failures="1" errors="0" skipped="0" time="0.250000" timestamp="2026-01-02T03:04:05Z">
    <testcase name="glsl" classname="graphs.a" file="graphs/a.test.json" line="3" time="0.250000"/>
    <testcase name="points/0" classname="graphs.a" file="graphs/a.test.json" line="3" time="0.000000">
      <failure message="differs" type="failed">differs
</failure>
    </testcase>
  </testsuite>
  <testsuite name="graphs/b" tests="2" failures="0" errors="1" skipped="1" time="0.000000" timestamp="2026-01-02T03:04:05Z">
    <testcase name="render" classname="graphs.b" file="graphs/b.test.json" line="3" time="0.000000">
      <error message="differs" type="error">differs
</error>
    </testcase>
    <testcase name="glsl" classname="graphs.b" file="graphs/b.test.json" line="3" time="0.000000">
      <skipped message="differs"/>
    </testcase>
  </testsuite>
  <testsuite name="graphs/golden" tests="1" failures="1" errors="0" skipped="0" time="0.000000" timestamp="2026-01-02T03:04:05Z">
    <testcase name="c.png" classname="graphs.golden" file="graphs/golden.test.json" line="3" time="0.000000">
      <failure message="differs" type="deleted">differs
</failure>
    </testcase>
  </testsuite>
</testsuites>
)");
    results.added_fails = true;
    EXPECT_NE(junit(results, options).find("failures=\"3\" errors=\"1\" skipped=\"0\""),
              std::string::npos);
}

TEST_F(CiFormatsTest, XmlIsEscaped) {
    Check& check = add("a\"<&>'\t\n\r", "glsl", Status::failed);
    check.message =
        "\x1b[1;31mred\x1b[0m \x01 \xff \xed\xa0\x80 \xef\xbf\xbf ]]> \u00e9 \U0001f600";
    const std::string text = junit(results, options);
    EXPECT_NE(text.find("name=\"a&quot;&lt;&amp;&gt;&apos;&#9;&#10;&#13;\""), text.npos) << text;
    const std::string bad = "\xef\xbf\xbd";
    const std::string message =
        "red " + bad + " " + bad + " " + bad + bad + bad + " " + bad + " ]]&gt; \u00e9 \U0001f600";
    EXPECT_NE(text.find(">" + message + "\n</failure>"), text.npos) << text;
    EXPECT_EQ(text.find('\x1b'), text.npos);
}

TEST_F(CiFormatsTest, AttachmentsAreThePathsOfTheCaller) {
    add("a", "render", Status::failed).joined_image = "joined/a.png";
    EXPECT_EQ(junit(results, options).find("ATTACHMENT"), std::string::npos);
    options.attachment = [](const std::string& image) { return "out/<" + image; };
    EXPECT_NE(junit(results, options)
                  .find("<system-out>[[ATTACHMENT|out/&lt;joined/a.png]]</system-out>"),
              std::string::npos);
}

TEST_F(CiFormatsTest, TapNumbersTheChecks) {
    add("a", "glsl", Status::passed);
    add("b # SKIP", "glsl", Status::failed).message = "two\nlines: \"x\"";
    add("c", "glsl", Status::added);
    EXPECT_EQ(tap(results), R"(TAP version 14
1..3
ok 1 - a/glsl
not ok 2 - b \# SKIP/glsl
  ---
  message: "two\\nlines: \"x\""
  file: "b # SKIP.test.json"
  line: 3
  ...
ok 3 - c/glsl # SKIP differs
)");
}

TEST_F(CiFormatsTest, AnnotationsAreEscaped) {
    add("a:b,c%", "glsl", Status::failed).message = "50 %: a, b\r\nnext";
    EXPECT_EQ(github_annotations(results, std::filesystem::current_path()),
              "::error file=a%3Ab%2Cc%25.test.json,line=3,col=5,title=a%3Ab%2Cc%25/glsl::50 %25: "
              "a, b%0D%0Anext\n");
}

TEST_F(CiFormatsTest, AnnotationsNameFilesFromTheRootOfTheRepository) {
    add("a", "glsl", Status::failed);
    const std::filesystem::path here = std::filesystem::current_path();
    const std::string folder = here.filename().string();
    EXPECT_TRUE(github_annotations(results, here.parent_path())
                    .starts_with("::error file=" + folder + "/a.test.json,"));
    results.checks[0].file = here / "x/../b.test.json";
    EXPECT_TRUE(github_annotations(results, here).starts_with("::error file=b.test.json,"));
    EXPECT_TRUE(github_annotations(results, here / "x")
                    .starts_with("::error file=" + (here / "b.test.json").string() + ","));
}

TEST_F(CiFormatsTest, AnnotationsAreAtMostTen) {
    for (int i = 0; i < 30; ++i)
        add("a" + std::to_string(i), "glsl", Status::failed).measured = {
            {"mean", "", "", "", static_cast<double>(i + 1), 1, ""}};
    add("broken", "case", Status::error);
    add("new", "glsl", Status::added);
    const std::string text = github_annotations(results, std::filesystem::current_path());
    EXPECT_EQ(std::ranges::count(text, '\n'), 10);
    EXPECT_TRUE(text.starts_with("::error file=broken.test.json"));
    EXPECT_EQ(text.find("::error file=a29"), text.find('\n') + 1);
    EXPECT_NE(text.find("and 23 more checks"), text.npos);
}

TEST(Severity, ExcessIsTheLargestPartOfALimit) {
    Check check;
    EXPECT_EQ(check.excess(), 0);
    check.measured = {{"a", "", "", "", 2, 4, ""}, {"b", "", "", "", 6, 2, ""}};
    EXPECT_EQ(check.excess(), 3);
    EXPECT_EQ((Measured{"a", "", "", "", 0, 0, ""}.excess()), 0);
    EXPECT_EQ((Measured{"a", "", "", "", 1, 0, ""}.excess()), Measured::max_excess);
    EXPECT_EQ((Measured{"a", "", "", "", NAN, 1, ""}.excess()), Measured::max_excess);
}

}  // namespace
}  // namespace wrinkle::report
