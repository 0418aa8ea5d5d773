// Tests of the HTML report: escapes, policy, size, and the parts of each kind of check.
#include "report/page.h"

#include <gtest/gtest.h>

#include "base/base64.h"
#include "report/diff_markup.h"
#include "report/markup.h"
#include "support/files.h"

namespace wrinkle::report {
namespace {

constexpr const char* hostile = "<img src=x onerror=alert(1)>\"'&</script></noscript>";

size_t count(const std::string& text, const std::string& part) {
    size_t found = 0;
    for (size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size()))
        ++found;
    return found;
}

// A file that begins as a PNG file of 16 x 8 pixels, of that many bytes.
std::string png(size_t bytes) {
    std::string file("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x10\0\0\0\x08", 24);
    return file + std::string(bytes - file.size(), 'x');
}

Check failed(const std::string& test, CheckKind kind) {
    Check check;
    check.test = test;
    check.name = "glsl";
    check.kind = kind;
    check.status = Status::failed;
    check.message = "differs";
    return check;
}

class PageTest : public testing::Test {
protected:
    std::string made() const { return page(results, folder, max_bytes); }

    // A check with three images of `bytes` bytes each that exceeds its limit by `factor`.
    void add_images(const std::string& test, size_t bytes, double factor) {
        Check check = failed(test, CheckKind::image);
        check.measured = {{"mean", "", "", "", factor, 1, ""}};
        check.expected_image = check.actual_image = check.map_image = test + ".png";
        check.width = check.height = 16;
        temporary.put(test + ".png", png(bytes));
        results.checks.push_back(check);
    }

    wrinkle::test::TemporaryFolder temporary;
    std::filesystem::path folder = temporary.path();
    Results results;
    uint64_t max_bytes = max_page_bytes;
};

TEST_F(PageTest, NoTextBecomesMarkup) {
    Check check = failed(hostile, CheckKind::text);
    check.name = check.message = check.file = check.expected = hostile;
    check.expected_text = "same\n";
    check.actual_text = std::string("same\n") + hostile + "\n";
    check.nodes_of_lines = {hostile, hostile};
    check.measured = {{hostile, hostile, hostile, hostile, 2, 1, hostile}};
    check.map_measure = hostile;
    check.actual_image = hostile;
    Check point = check, passed = check;
    point.kind = CheckKind::point;
    passed.status = Status::passed;
    results.checks = {check, point, passed};
    results.version = results.driver = results.command = results.approval = results.started =
        hostile;
    results.problems = {hostile};
    const std::string text = made();
    EXPECT_EQ(text.find("<img"), text.npos);
    EXPECT_EQ(count(text, "<script"), 1U);
    EXPECT_EQ(count(text, "</script"), 1U);
    EXPECT_EQ(count(text, "</noscript"), 2U);  // one of each check
    EXPECT_EQ(text.find("x\"'"), text.npos);
    EXPECT_GT(
        count(text,
              "&lt;img src=x onerror=alert(1)&gt;&quot;'&amp;&lt;/script&gt;&lt;/noscript&gt;"),
        12U);
}

TEST_F(PageTest, ControlCharactersAndBytesThatAreNoTextAreEscaped) {
    EXPECT_EQ(html("a\x1b[31m\r\n\xff\xed\xa0\x80"), "a\\x1b[31m\\r\\n\\xff\\xed\\xa0\\x80");
    EXPECT_EQ(html("\u202e"), "\\u202e");
    EXPECT_EQ(html("\u00e9"), "\u00e9");
}

TEST_F(PageTest, OnlyTheScriptOfThePageMayRun) {
    const std::string text = made();
    const std::string policy =
        "content=\"default-src 'none'; base-uri 'none'; form-action 'none'; img-src data:; "
        "style-src 'sha256-";
    EXPECT_EQ(count(text, "'unsafe-"), 0U);
    EXPECT_EQ(count(text, " style="), 0U);
    ASSERT_NE(text.find(policy), text.npos);
    EXPECT_LT(text.find(policy), text.find("<style"));
    for (const char* word : {"http:", "https:", "//cdn", "src=\"/", "import ", " onclick"})
        EXPECT_EQ(text.find(word), text.npos) << word;
}

TEST_F(PageTest, HasTheCommandsOfTheRun) {
    results.approval = "wrinkle test --report out";
    EXPECT_NE(made().find("<code id=\"accept\">wrinkle test --report out --review</code>"),
              std::string::npos);
    EXPECT_EQ(made().find("<code id=\"repeat\">"), std::string::npos);
    results.command = "wrinkle test a";
    EXPECT_NE(made().find("<code id=\"repeat\">wrinkle test a</code>"), std::string::npos);
}

TEST_F(PageTest, VerdictFollowsTheChecks) {
    const auto verdict = [&](std::initializer_list<Status> all) {
        results.checks.clear();
        for (const Status status : all)
            results.checks.emplace_back().status = status;
        const std::string text = made();
        const size_t begin = text.find('>', text.find("<h1")) + 1;
        return text.substr(begin, text.find('<', begin) - begin);
    };
    EXPECT_EQ(verdict({Status::passed}), "Passed");
    EXPECT_EQ(verdict({Status::passed, Status::added}), "Passed, with new checks");
    EXPECT_EQ(verdict({Status::passed, Status::failed}), "Failed");
    results.added_fails = true;
    EXPECT_EQ(verdict({Status::passed, Status::added}), "Failed");
    results.added_fails = false;
    EXPECT_EQ(verdict({Status::error}), "Failed");
    EXPECT_EQ(verdict({Status::deleted, Status::added}), "Failed");
}

TEST_F(PageTest, ErrorsComeFirstThenTheWorst) {
    add_images("small", 30, 2);
    add_images("large", 30, 50);
    results.checks.push_back(failed("broken", CheckKind::none));
    results.checks.back().status = Status::error;
    const std::string text = made();
    EXPECT_LT(text.find("id=\"broken/glsl\""), text.find("id=\"large/glsl\""));
    EXPECT_LT(text.find("id=\"large/glsl\""), text.find("id=\"small/glsl\""));
}

TEST_F(PageTest, ImagesAreInThePageOfTheWorstUntilItIsFull) {
    add_images("small", 3000, 2);
    add_images("large", 3000, 50);
    const std::string uri = "data:image/png;base64," + base64(png(3000));
    EXPECT_EQ(count(made(), uri), 6U);
    EXPECT_EQ(made().find("too large"), std::string::npos);
    max_bytes = made().size() - 6000;
    const std::string text = made();
    EXPECT_EQ(count(text, uri), 3U);
    EXPECT_LT(text.find(uri), text.find("id=\"small/glsl\""));
    EXPECT_NE(text.find("the images of 1 checks and the lines of 0 checks are only in its folder"),
              text.npos);
    EXPECT_NE(text.find("small.png is not in this page"), text.npos);
}

TEST_F(PageTest, ImagesOutsideTheFolderAreNotRead) {
    temporary.put("secret.png", png(40));
    std::filesystem::create_directory(folder / "report");
    Check check = failed("a", CheckKind::image);
    check.actual_image = "../secret.png";
    results.checks = {check};
    const std::string text = page(results, folder / "report");
    EXPECT_EQ(text.find(base64(png(40))), text.npos);
    EXPECT_NE(text.find("../secret.png is not in this page"), text.npos);
}

TEST_F(PageTest, TextsHaveTheNodeOfEachLine) {
    Check check = failed("a", CheckKind::text);
    check.expected_text = "one\ntwo\nthree\n";
    check.actual_text = "one\n2\nthree\n";
    check.nodes_of_lines = {"", "weave", ""};
    results.checks = {check};
    const std::string text = made();
    const size_t added = text.find("<tr class=\"added\">");
    ASSERT_NE(added, text.npos);
    const std::string row = text.substr(added, text.find("</tr>", added) - added);
    EXPECT_NE(row.find("weave"), row.npos);
    EXPECT_NE(row.find("<code>2</code>"), row.npos);
    EXPECT_EQ(count(text, "<tr class=\"removed\">"), 1U);
    EXPECT_NE(text.find("Nodes of these lines: <code>weave</code>"), text.npos);
    EXPECT_NE(text.find("data-nodes=\"weave\""), text.npos);
}

TEST_F(PageTest, ThePartOfALineThatChangedIsMarked) {
    Check check = failed("a", CheckKind::text);
    check.expected_text = "same\nfloat x = a + b;\n\u00e9\u00e8\u00e9\nall of it\n";
    check.actual_text = "same\nfloat x = a - b;\n\u00e9\u00ea\u00e9\n12345678\n";
    const std::string table = diff_markup(check).table;
    for (const char* part : {"float x = a <mark>+</mark> b;", "float x = a <mark>-</mark> b;",
                             "\u00e9<mark>\u00e8</mark>\u00e9", "\u00e9<mark>\u00ea</mark>\u00e9",
                             "<code>all of it</code>", "<code>12345678</code>"})
        EXPECT_NE(table.find(part), table.npos) << part;
}

TEST_F(PageTest, OutputsThatAreMissingAreNamed) {
    Check check = failed("a", CheckKind::point);
    check.measured = {{"height", "", "0.5", "", 0, 0, ""}, {"front", "lit", "1", "1", 0, 1, ""}};
    results.checks = {check};
    const std::string text = made();
    EXPECT_NE(text.find("<tr class=\"over\"><th scope=\"row\">height</th>"), text.npos);
    EXPECT_NE(text.find(">missing</td>"), text.npos);
    EXPECT_NE(text.find(">height missing</span>"), text.npos);
    EXPECT_EQ(count(text, "<tr class=\"over\">"), 1U);
}

TEST_F(PageTest, LongDifferencesAreCut) {
    Check check = failed("a", CheckKind::text);
    for (int i = 0; i < 50; ++i)
        check.actual_text += std::to_string(i) + "\n";
    const std::string table = diff_markup(check, 20).table;
    EXPECT_EQ(count(table, "<tr class=\"added\">"), 20U);
    EXPECT_NE(table.find("30 more lines are not in this page."), table.npos);
}

TEST_F(PageTest, AllOfAPageIsWithinItsSize) {
    for (int i = 0; i < 300; ++i) {
        Check check = failed("case_" + std::to_string(1000 + i), CheckKind::text);
        check.measured = {{"lines", "", "", "", 1000.0 - i, 1, ""}};
        for (int line = 0; line < 20; ++line) {
            check.expected_text += "old " + std::to_string(line) + "\n";
            check.actual_text += "new " + std::to_string(line) + "\n";
        }
        results.checks.push_back(check);
    }
    const size_t all = made().size();
    max_bytes = all / 2;
    const std::string text = made();
    EXPECT_LE(text.size(), max_bytes);
    EXPECT_GT(text.size(), max_bytes * 9 / 10);
    const size_t left_out = count(text, "The lines that differ are not in this page.");
    EXPECT_GT(left_out, 100U);
    EXPECT_NE(text.find("the lines of " + std::to_string(left_out) + " checks are only"),
              text.npos);
    EXPECT_LT(text.find("<tr class=\"removed\">"), text.find("id=\"case_1001/glsl\""));
    EXPECT_NE(text.find("id=\"case_1299/glsl\""), text.npos);
}

TEST_F(PageTest, ChecksOfACaseAreTogetherWithThosePassed) {
    for (const char* name : {"b", "a", "b", "b"}) {
        results.checks.push_back(failed(name, CheckKind::point));
        results.checks.back().name = "points/" + std::to_string(results.checks.size());
    }
    results.checks[2].status = Status::passed;
    results.checks[3].status = Status::error;
    const std::string text = made();
    const auto at = [&](const char* part) { return text.find(part); };
    EXPECT_LT(at("<h3>b<span class=\"others\">passed: points/3</span></h3>"),
              at("id=\"b/points/1\""));
    EXPECT_LT(at("id=\"b/points/1\""), at("id=\"b/points/4\""));
    EXPECT_LT(at("id=\"b/points/4\""), at("<h3>a</h3>"));
    EXPECT_NE(at("2 of 2 cases differ</p>"), text.npos);
    EXPECT_NE(at("id=\"b/points/4\" data-status=\"error\" data-seconds=\"0\" "
                 "data-nodes=\"\">"),
              text.npos);
}

TEST_F(PageTest, PointsOfACaseAreRowsOfATable) {
    for (int i = 0; i < 3; ++i) {
        Check& point = results.checks.emplace_back(failed("a", CheckKind::point));
        point.name = "points/" + std::to_string(i);
    }
    results.checks[0].measured = {{"normal", "n.normal", "1", "2", 7, 0.05, "degrees"},
                                  {"height", "h.height", "3", "3", 0, 0.5, ""}};
    results.checks[1].measured = {{"lit", "", "4", "", 0, 0.5, ""}};
    results.checks[2].status = Status::passed;
    const std::string text = made();
    const size_t begin = text.find("<table class=\"points\">");
    ASSERT_NE(begin, text.npos);
    const std::string table = text.substr(begin, text.find("</table>", begin) - begin);
    EXPECT_NE(text.find("2 of 3 points differ</summary>"), text.npos);
    for (const char* part :
         {"<th scope=\"col\">normal<br><code>n.normal</code><br>limit 0.05 degrees</th>"
          "<th scope=\"col\">height<br><code>h.height</code><br>limit 0.5</th>"
          "<th scope=\"col\">lit</th></tr>",
          "<a href=\"#a/points/0\">points/0</a></th><td class=\"over\"><strong>7 degrees</strong>"
          "<br>1 \u2192 2</td><td>0</td><td></td></tr>",
          "points/1</a></th><td></td><td></td><td class=\"over\"><strong>missing</strong>"
          "<br>4 \u2192 none</td></tr>",
          "points/2</th><td colspan=\"3\">passed</td></tr>"})
        EXPECT_NE(table.find(part), table.npos) << part << "\n" << table;
    results.checks.resize(1);
    EXPECT_EQ(made().find("<table class=\"points\">"), std::string::npos);
}

TEST_F(PageTest, TheHeadingOfACaseHasItsCosts) {
    results.checks = {failed("a", CheckKind::text), failed("a", CheckKind::cost)};
    results.checks[1].status = Status::passed;
    results.checks[1].name = "budget";
    results.checks[1].measured = {{"alu", "", "200", "212", 212, 200, ""},
                                  {"branches", "", "9", "2", 2, 9, ""}};
    EXPECT_NE(made().find("<h3>a<span class=\"cost over\">alu 212 / 200, +12</span><span "
                          "class=\"cost\">branches 2 / 9, \u22127</span>"),
              std::string::npos);
    results.after = "b.json";
    results.checks[1].measured = {{"alu", "", "200", "188", -12, 0, ""}};
    EXPECT_NE(made().find("<h3>a<span class=\"cost\">alu 200 \u2192 188, \u221212</span>"),
              std::string::npos);
}

TEST_F(PageTest, ImagesHaveTheirSizeAndADescription) {
    add_images("a", 30, 2);
    results.checks[0].message = "differs by 7";
    temporary.put("other.png", "no image");
    results.checks[0].expected_image = "other.png";
    const std::string text = made();
    EXPECT_NE(text.find("<p>other.png is not in this page.</p><figcaption>Expected"), text.npos);
    EXPECT_EQ(count(text, "\" width=\"16\" height=\"8\" alt=\""), 2U);
    EXPECT_NE(text.find("alt=\"Map of the difference: differs by 7\""), text.npos);
}

TEST_F(PageTest, ImagesWithinTheirLimitsAreCounted) {
    add_images("a", 30, 0.5);
    add_images("b", 30, 0);
    for (Check& check : results.checks)
        check.status = Status::passed;
    EXPECT_NE(made().find("0 of 2 cases differ; 1 image changed within the"), std::string::npos);
}

TEST_F(PageTest, PassedChecksAreNames) {
    for (int i = 0; i < 10000; ++i) {
        Check& check = results.checks.emplace_back();
        check.test = "graphs/materials/case_" + std::to_string(i);
        check.name = "glsl";
        check.actual_text = "text that is not shown";
    }
    const std::string text = made();
    EXPECT_LT(text.size(), 600'000U);
    EXPECT_EQ(count(text, "<li>"), 10000U);
}

TEST(Base64, IsThatOfTheRfc) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xfb\xff"), "+/8=");
}

}  // namespace
}  // namespace wrinkle::report
