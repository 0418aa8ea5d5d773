// JUnit, TAP and annotations: counts, escapes and outcomes, against texts written by hand.
#include "report/ci_formats.h"

#include <gtest/gtest.h>

#include <cmath>

#include <sstream>

#include "base/text.h"
#include "report/annotations.h"
#include "report/hostile_results.h"
#include "report/xml.h"

namespace wrinkle::test {
namespace {

using namespace report;

const std::string replaced = "\xEF\xBF\xBD";  // U+FFFD

CiOptions options_here() {
    return {std::filesystem::current_path(), "", false};
}

Check check_of(Status status) {
    Check check;
    check.test = "graphs/rings";
    check.name = "points/2";
    check.file = "graphs/rings.test.json";
    check.line = 12;
    check.column = 5;
    check.kind = CheckKind::point;
    check.status = status;
    if (status != Status::passed) check.message = "normal is 3 degrees off";
    return check;
}

Results results_of(std::initializer_list<Status> all) {
    Results results;
    for (const Status status : all) {
        results.checks.push_back(check_of(status));
        results.checks.back().name += std::to_string(results.checks.size());
    }
    return results;
}

TEST(Xml, EscapesAttributesAndTexts) {
    EXPECT_EQ(xml_attribute("a&b<c>d\"e'f\tg\nh\ri"),
              "a&amp;b&lt;c&gt;d&quot;e&apos;f&#9;g&#10;h&#13;i");
    EXPECT_EQ(xml_text("a&b<c>d\"e'f\tg\nh\r ]]>"), "a&amp;b&lt;c&gt;d\"e'f\tg\nh&#13; ]]&gt;");
}

TEST(Xml, ReplacesCharactersThatItDoesNotAllow) {
    for (int code = 0; code < 0x20; ++code) {
        const std::string text = {'x', static_cast<char>(code), 'y'};
        const bool allowed = code == 9 || code == 10 || code == 13;
        EXPECT_EQ(xml_characters(text), allowed ? text : "x" + replaced + "y") << code;
    }
    EXPECT_EQ(xml_characters("\x7F \xC2\x85 \xEE\x80\x80 \xEF\xBF\xBD \xF4\x8F\xBF\xBF"),
              "\x7F \xC2\x85 \xEE\x80\x80 \xEF\xBF\xBD \xF4\x8F\xBF\xBF");
    EXPECT_EQ(xml_characters("\xEF\xBF\xBE\xEF\xBF\xBF"), replaced + replaced);
    EXPECT_EQ(xml_characters("\xFF\xC0\x80 \xED\xA0\x80 \xE2\x82"),
              replaced + replaced + replaced + " " + replaced + replaced + replaced + " " +
                  replaced + replaced);
}

TEST(Xml, LeavesOutAnsiSequences) {
    EXPECT_EQ(xml_characters("\x1B[1;31mred\x1B[0m, \x1B[?25lcursor"), "red, cursor");
    EXPECT_EQ(xml_characters("\x1B]0;title\aa\x1B]8;;http://x\x1B\\b\x1BMc"), "abc");
    EXPECT_EQ(xml_characters("\x1B]0;open"), "0;open");
    EXPECT_EQ(xml_characters("\x1B[31\xC3\xA4"), "31\xC3\xA4");
    EXPECT_EQ(xml_characters("\x1B"), replaced);
}

TEST(JUnit, IsASuiteForEachCaseAndATestcaseForEachCheck) {
    Results results = results_of({Status::passed, Status::failed});
    results.started = "2026-11-26T02:00:00Z";
    results.checks[0].seconds = 0.5;
    results.checks[1].seconds = 0.125;
    results.checks[1].expected = "wrinkle test --accept";
    results.checks[1].measured = {
        {"normal", "weave.normal", "[0, 0, 1]", "[0, 1, 0]", 90, 0.05, "degrees"},
        {"height", "", "1", "1", 0, 0.5, ""}};
    results.checks[1].actual_image = "images/a b.png";
    CiOptions options = options_here();
    options.attachments = "build/report";
    EXPECT_EQ(
        junit(results, options),
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<testsuites name=\"wrinkle test\" tests=\"2\" failures=\"1\" errors=\"0\" skipped=\"0\" "
        "time=\"0.625\">\n"
        "  <testsuite name=\"graphs/rings\" tests=\"2\" failures=\"1\" errors=\"0\" skipped=\"0\" "
        "time=\"0.625\" timestamp=\"2026-11-26T02:00:00Z\">\n"
        "    <testcase name=\"points/21\" classname=\"graphs/rings\" "
        "file=\"graphs/rings.test.json\" line=\"12\" time=\"0.500\"/>\n"
        "    <testcase name=\"points/22\" classname=\"graphs/rings\" "
        "file=\"graphs/rings.test.json\" line=\"12\" time=\"0.125\">\n"
        "      <failure message=\"normal is 3 degrees off\" type=\"point-failed\">normal is 3 "
        "degrees off\nwrinkle test --accept\n"
        "normal (weave.normal): expected [0, 0, 1], found [0, 1, 0], measured 90 degrees, limit "
        "0.05 degrees\n</failure>\n"
        "      <system-out>[[ATTACHMENT|build/report/images/a b.png]]</system-out>\n"
        "    </testcase>\n"
        "  </testsuite>\n"
        "</testsuites>\n");
}

TEST(JUnit, NewBaselinesFailOnlyWhereAskedAndDeletedOnesAlways) {
    const Results results = results_of({Status::added, Status::deleted, Status::error});
    CiOptions options = options_here();
    EXPECT_NE(junit(results, options).find("failures=\"1\" errors=\"1\" skipped=\"1\""),
              std::string::npos);
    options.added_fails = true;
    EXPECT_NE(junit(results, options).find("failures=\"2\" errors=\"1\" skipped=\"0\""),
              std::string::npos);
}

TEST(JUnit, AProblemOfTheRunIsAnError) {
    Results results = results_of({Status::passed});
    results.problems = {"OpenGL is not available"};
    const std::string text = junit(results, options_here());
    EXPECT_NE(
        text.find("<testsuites name=\"wrinkle test\" tests=\"2\" failures=\"0\" errors=\"1\""),
        text.npos);
    EXPECT_NE(text.find("<error message=\"OpenGL is not available\" type=\"case-error\">"),
              text.npos);
}

TEST(JUnit, AttachesNoImageThatWouldEndItsLine) {
    Results results = results_of({Status::failed});
    for (const std::string path :
         {"a]]b.png", "a\nb.png", "a\rb.png", "a\x1B[m.png", "a\xFF.png"}) {
        results.checks[0].actual_image = path;
        EXPECT_EQ(junit(results, options_here()).find("ATTACHMENT"), std::string::npos) << path;
    }
    results.checks[0].actual_image.clear();
    results.checks[0].expected_image = "gone.png";
    EXPECT_NE(junit(results, options_here()).find("[[ATTACHMENT|gone.png]]"), std::string::npos);
}

TEST(JUnit, HostileTextsLeaveNoRawControlCharacter) {
    const std::string text = junit(hostile_results(), options_here());
    EXPECT_TRUE(is_utf8(text));
    for (const char c : text)
        ASSERT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t');
    EXPECT_EQ(text.find("]]>"), text.npos);
    EXPECT_EQ(text.find("[31m"), text.npos);
}

TEST(Tap, IsVersion14) {
    Results results = results_of({Status::passed, Status::failed, Status::added});
    results.checks[0].name = "a # b \\ c\n";
    results.problems = {"no \"GL\""};
    EXPECT_EQ(tap(results, options_here()),
              "TAP version 14\n1..4\n"
              "ok 1 - graphs/rings/a \\# b \\\\ c\\\\n\n"
              "not ok 2 - graphs/rings/points/22\n"
              "  ---\n"
              "  message: \"normal is 3 degrees off\"\n"
              "  status: failed\n"
              "  at:\n"
              "    file: \"graphs/rings.test.json\"\n"
              "    line: 12\n"
              "    column: 5\n"
              "  ...\n"
              "ok 3 - graphs/rings/points/23 # SKIP normal is 3 degrees off\n"
              "not ok 4 - wrinkle test/run 1\n"
              "  ---\n"
              "  message: \"no \\\"GL\\\"\"\n"
              "  status: error\n"
              "  ...\n");
}

TEST(Tap, HostileTextsAddNoLine) {
    std::istringstream lines(tap(hostile_results(), options_here()));
    int points = 0;
    for (std::string line; std::getline(lines, line);) {
        points += line.starts_with("ok ") || line.starts_with("not ok ");
        const bool known = line.starts_with("ok ") || line.starts_with("not ok ") ||
                           line.starts_with("  ") || line.starts_with("1..7") ||
                           line == "TAP version 14";
        EXPECT_TRUE(known) << line;
    }
    EXPECT_EQ(points, 7);
}

TEST(Annotations, EscapeTextsAndProperties) {
    EXPECT_EQ(github_commands({{true, "a,b:c%.json", 3, 4, "x: y, z", "50 %\r\nof: a, b"}}),
              "::error file=a%2Cb%3Ac%25.json,line=3,col=4,title=x%3A y%2C z::"
              "50 %25\\r%0Aof: a, b\n");
    EXPECT_EQ(github_commands({{false, "", 0, 0, "", "no file"}}), "::warning::no file\n");
    EXPECT_EQ(github_commands({{true, "a.json", 0, 9, "t", "general"}}),
              "::error file=a.json,title=t::general\n");
}

TEST(Annotations, WorstComeFirstAndTheLastCountsTheRest) {
    const auto lines_of = [](size_t count) {
        Results results;
        for (size_t i = 0; i < count; ++i)
            results.checks.push_back(check_of(i + 1 < count ? Status::failed : Status::error));
        std::vector<std::string> lines;
        std::istringstream text(github_annotations(results, options_here()));
        for (std::string line; std::getline(text, line);)
            lines.push_back(line);
        return lines;
    };
    EXPECT_EQ(lines_of(10).size(), 10U);
    EXPECT_EQ(lines_of(10).back().find(" more"), std::string::npos);
    const std::vector<std::string> lines = lines_of(15);
    ASSERT_EQ(lines.size(), 10U);
    EXPECT_EQ(lines[9], "::error title=wrinkle::and 6 more: see the log");
    EXPECT_TRUE(lines[0].starts_with("::error file=graphs/rings.test.json,line=12,col=5,"))
        << lines[0];
    const Results mixed =
        results_of({Status::added, Status::passed, Status::failed, Status::error});
    const std::string text = github_annotations(mixed, options_here());
    EXPECT_LT(text.find("points/24"), text.find("points/23"));
    EXPECT_LT(text.find("points/23"), text.find("::warning"));
    EXPECT_EQ(text.find("points/22"), text.npos);
}

TEST(Annotations, HostileTextsAddNoCommand) {
    std::istringstream lines(github_annotations(hostile_results(), options_here()));
    for (std::string line; std::getline(lines, line);) {
        EXPECT_TRUE(line.starts_with("::error ") || line.starts_with("::warning ")) << line;
        EXPECT_EQ(line.find('\x1B'), line.npos);
    }
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
}  // namespace wrinkle::test
