// Tests of the difference of texts: both texts can be put together from it, and it is shortest.
#include "report/text_diff.h"

#include <gtest/gtest.h>

#include <random>

namespace wrinkle::report {
namespace {

using Kind = DiffLine::Kind;

std::string shown(const std::vector<DiffLine>& lines) {
    std::string text;
    for (const DiffLine& line : lines)
        text +=
            std::string(1, " -+~"[static_cast<size_t>(line.kind)]) + std::string(line.text) + "|";
    return text;
}

TEST(TextDiff, ShowsRemovedAndAddedLines) {
    EXPECT_EQ(shown(diff_lines("a\nb\nc\n", "a\nx\nc\n")), " a|-b|+x| c|");
    EXPECT_EQ(shown(diff_lines("a\n", "a\n")), "~|");
    EXPECT_EQ(shown(diff_lines("", "a\nb")), "+a|+b|");
    EXPECT_EQ(shown(diff_lines("a\nb", "")), "-a|-b|");
    EXPECT_EQ(shown(diff_lines("", "")), "");
    EXPECT_EQ(shown(diff_lines("1\n2\n3\n4\n5\n6\n7\n", "1\n2\n3\nx\n5\n6\n7\n", 1)),
              "~| 3|-4|+x| 5|~|");
}

TEST(TextDiff, NumbersAreThoseOfTheTexts) {
    const auto lines = diff_lines("a\nb\nc\n", "b\nc\nd\n");
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0].expected_line, 1U);
    EXPECT_EQ(lines[0].actual_line, 0U);
    EXPECT_EQ(lines[1].expected_line, 2U);
    EXPECT_EQ(lines[1].actual_line, 1U);
    EXPECT_EQ(lines[3].actual_line, 3U);
}

TEST(TextDiff, BothTextsCanBeRestored) {
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        std::string texts[2];
        for (std::string& text : texts)
            for (unsigned i = random() % 30; i > 0; --i)
                text += std::string(1, static_cast<char>('a' + random() % 4)) + "\n";
        const auto lines = diff_lines(texts[0], texts[1], 1000);
        std::string restored[2];
        for (const DiffLine& line : lines) {
            if (line.kind != Kind::added) restored[0] += std::string(line.text) + "\n";
            if (line.kind != Kind::removed) restored[1] += std::string(line.text) + "\n";
        }
        EXPECT_EQ(restored[0], texts[0]);
        EXPECT_EQ(restored[1], texts[1]);
    }
}

TEST(TextDiff, LargeTextsEndSoon) {
    std::string a = "begin\n", b = "begin\n";
    for (int i = 0; i < 200'000; ++i) {
        a += "a" + std::to_string(i) + "\n";
        b += "b" + std::to_string(i) + "\n";
    }
    a += "end\n";
    b += "end\n";
    const auto lines = diff_lines(a, b);
    EXPECT_EQ(lines.size(), 400'002U);
    EXPECT_EQ(lines.front().text, "begin");
    EXPECT_EQ(lines.back().text, "end");
}

}  // namespace
}  // namespace wrinkle::report
