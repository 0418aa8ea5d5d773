// Tests of the HTML report: escapes, policy, size, and the parts of each kind of check.
#include "report/page.h"

#include <gtest/gtest.h>

#include "base/base64.h"
#include "report/markup.h"
#include "support/files.h"

namespace wrinkle::report {
namespace {

constexpr const char* hostile = "<img src=x onerror=alert(1)>\"'&</script>";

size_t count(const std::string& text, const std::string& part) {
    size_t found = 0;
    for (size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size()))
        ++found;
    return found;
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
        temporary.put(test + ".png", std::string(bytes, 'x'));
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
    results.version = results.driver = results.command = results.started = hostile;
    results.problems = {hostile};
    const std::string text = made();
    EXPECT_EQ(text.find("<img"), text.npos);
    EXPECT_EQ(count(text, "<script"), 1U);
    EXPECT_EQ(count(text, "</script"), 1U);
    EXPECT_EQ(text.find("x\"'"), text.npos);
    EXPECT_GT(count(text, "&lt;img src=x onerror=alert(1)&gt;&quot;'&amp;&lt;/script&gt;"), 12U);
}

TEST_F(PageTest, ControlCharactersAndBytesThatAreNoTextAreEscaped) {
    EXPECT_EQ(html("a\x1b[31m\r\n\xff\xed\xa0\x80"), "a\\x1b[31m\\r\\n\\xff\\xed\\xa0\\x80");
    EXPECT_EQ(html("\u202e"), "\\u202e");
    EXPECT_EQ(html("\u00e9"), "\u00e9");
}

TEST_F(PageTest, OnlyTheScriptOfThePageMayRun) {
    const std::string text = made();
    const std::string policy =
        "content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src "
        "'sha256-";
    ASSERT_NE(text.find(policy), text.npos);
    EXPECT_LT(text.find(policy), text.find("<style"));
    for (const char* word : {"http:", "https:", "//cdn", "src=\"/", "import ", " onclick"})
        EXPECT_EQ(text.find(word), text.npos) << word;
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
    EXPECT_EQ(verdict({Status::error}), "Failed");
    EXPECT_EQ(verdict({Status::deleted, Status::added}), "Failed");
}

TEST_F(PageTest, ErrorsComeFirstThenTheWorst) {
    add_images("small", 10, 2);
    add_images("large", 10, 50);
    results.checks.push_back(failed("broken", CheckKind::none));
    results.checks.back().status = Status::error;
    const std::string text = made();
    EXPECT_LT(text.find("id=\"broken/glsl\""), text.find("id=\"large/glsl\""));
    EXPECT_LT(text.find("id=\"large/glsl\""), text.find("id=\"small/glsl\""));
}

TEST_F(PageTest, ImagesAreInThePageOfTheWorstUntilItIsFull) {
    add_images("small", 3000, 2);
    add_images("large", 3000, 50);
    const std::string uri = "data:image/png;base64," + base64(std::string(3000, 'x'));
    EXPECT_EQ(count(made(), uri), 6U);
    EXPECT_EQ(made().find("too large"), std::string::npos);
    max_bytes = 20000;
    const std::string text = made();
    EXPECT_EQ(count(text, uri), 3U);
    EXPECT_LT(text.find(uri), text.find("id=\"small/glsl\""));
    EXPECT_NE(text.find("the images of 1 checks are only in its folder"), text.npos);
    EXPECT_NE(text.find("small.png is not in this page"), text.npos);
}

TEST_F(PageTest, ImagesOutsideTheFolderAreNotRead) {
    temporary.put("secret.png", "secret");
    std::filesystem::create_directory(folder / "report");
    Check check = failed("a", CheckKind::image);
    check.actual_image = "../secret.png";
    results.checks = {check};
    const std::string text = page(results, folder / "report");
    EXPECT_EQ(text.find(base64("secret")), text.npos);
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
