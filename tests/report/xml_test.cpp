// Escapes of XML, and formats with hostile texts.
#include "report/xml.h"

#include <gtest/gtest.h>

#include <sstream>

#include "base/text.h"
#include "report/annotations.h"
#include "report/ci_formats.h"
#include "report/hostile_results.h"

namespace wrinkle::test {
namespace {

using namespace report;

const std::string replaced = "\xEF\xBF\xBD";  // U+FFFD

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

TEST(HostileTexts, LeaveNoControlCharacterInXml) {
    const std::string text = junit(hostile_results(), {});
    EXPECT_TRUE(is_utf8(text));
    for (const char c : text)
        ASSERT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t');
    EXPECT_EQ(text.find("]]>"), text.npos);
    EXPECT_EQ(text.find("[31m"), text.npos);
}

TEST(HostileTexts, AddNoLineToTap) {
    std::istringstream lines(tap(hostile_results()));
    int points = 0;
    for (std::string line; std::getline(lines, line);) {
        const bool is_point = line.starts_with("ok ") || line.starts_with("not ok ");
        points += is_point;
        EXPECT_TRUE(is_point || line.starts_with("  ") || line == "1..6" ||
                    line == "TAP version 14")
            << line;
    }
    EXPECT_EQ(points, 6);
}

// A backslash before '#' would make it the begin of a directive again.
TEST(HostileTexts, AddNoDirectiveToTap) {
    Results results;
    Check& check = results.checks.emplace_back();
    check.test = "a";
    check.name = "b \\# SKIP";
    check.status = Status::failed;
    EXPECT_NE(tap(results).find("not ok 1 - a/b \\\\\\# SKIP\n"), std::string::npos);
}

TEST(HostileTexts, AddNoAnnotation) {
    std::istringstream lines(
        github_annotations(hostile_results(), std::filesystem::current_path()));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        EXPECT_TRUE(line.starts_with("::error ") || line.starts_with("::notice ")) << line;
        EXPECT_EQ(line.find('\x1B'), line.npos);
        EXPECT_EQ(line.find('\r'), line.npos);
    }
    EXPECT_EQ(count, 5);
}

using Level = Annotation::Level;

TEST(Annotations, EscapeTextsAndProperties) {
    EXPECT_EQ(
        github_commands({{Level::error, "a,b:c%.json", 3, 4, "x: y, z", "50 %\r\nof: a, b"}}, ""),
        "::error file=a%2Cb%3Ac%25.json,line=3,col=4,title=x%3A y%2C z::50 %25%0D%0Aof: a, b\n");
    EXPECT_EQ(github_commands({{Level::warning, "", 0, 0, "", "no file"}}, ""),
              "::warning::no file\n");
    EXPECT_EQ(github_commands({{Level::notice, "a.json", 0, 9, "t", "general"}}, ""),
              "::notice file=a.json,title=t::general\n");
}

TEST(Annotations, ErrorsComeFirstAndTheLastCountsTheRest) {
    std::vector<Annotation> all(10, {Level::warning, "", 0, 0, "", "w"});
    EXPECT_EQ(github_commands(all, "").find(" more"), std::string::npos);
    all.insert(all.end(), 5, {Level::error, "", 0, 0, "", "e"});
    std::string expected;
    for (int i = 0; i < 9; ++i)
        expected += i < 5 ? "::error::e\n" : "::warning::w\n";
    EXPECT_EQ(github_commands(all, "of them"),
              expected + "::warning title=wrinkle::and 6 more of them\n");
}

TEST(Annotations, OfDiagnosticsNameTheRule) {
    Diagnostics list;
    list.add(file_problem(Severity::warning, RuleId::mesh_uvs, "m.obj", "no uvs", "unwrap it"));
    list.error(RuleId::opengl, "no OpenGL");
    EXPECT_EQ(github_annotations(list, std::filesystem::current_path()),
              "::error title=opengl::no OpenGL\n"
              "::warning file=m.obj,title=mesh-uvs::no uvs (unwrap it)\n");
}

}  // namespace
}  // namespace wrinkle::test
