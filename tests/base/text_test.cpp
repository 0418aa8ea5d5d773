// Tests of spellings, names, suggestions and UTF-8.
#include "base/text.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <random>

#include "base/string_pool.h"

namespace wrinkle {
namespace {

TEST(Text, ShortestReadsBackAsTheSameNumber) {
    EXPECT_EQ(shortest(0.1), "0.1");
    EXPECT_EQ(shortest(0.1F), "0.1");
    EXPECT_EQ(shortest(-0.0), "-0");
    EXPECT_EQ(shortest(1e-7), "1e-07");
    EXPECT_EQ(shortest(3.0), "3");
    std::mt19937_64 random(3);
    for (int i = 0; i < 2000; ++i) {
        const auto value = static_cast<double>(random()) * 1e-12;
        EXPECT_EQ(std::strtod(shortest(value).c_str(), nullptr), value);
        const auto single = static_cast<float>(value);
        EXPECT_EQ(std::strtof(shortest(single).c_str(), nullptr), single);
    }
}

TEST(Text, JsonStringsEscapeWhatTheyMust) {
    EXPECT_EQ(json_quoted("plain é"), "\"plain é\"");
    EXPECT_EQ(json_quoted("a\"b\\c/d"), R"("a\"b\\c/d")");
    EXPECT_EQ(json_quoted("\n\t\r"), R"("\n\t\r")");
    EXPECT_EQ(json_quoted(std::string_view("\0\x1f", 2)), R"("\u0000\u001f")");
    EXPECT_EQ(json_quoted("\x7F\u0085\u061C\u2028\u202E\xFF"),
              R"("\u007f\u0085\u061c\u2028\u202e\ufffd")");
}

TEST(Text, IdentifiersFitC) {
    EXPECT_EQ(identifier("weave"), "weave");
    EXPECT_EQ(identifier("strap/weave 2"), "strap_weave_2");
    EXPECT_EQ(identifier("a--b"), "a_b");
    EXPECT_EQ(identifier("a__b"), "a_b");
    EXPECT_EQ(identifier("2nd"), "n2nd");
    EXPECT_EQ(identifier(""), "n");
    EXPECT_EQ(identifier("é"), "_");
    for (const char* word : {"weave", "a_b", "_",   "_a", "a_",  "x2", "Z", "a__b", "__", "2nd", "",
                             "é",     "a b", "a.b", "a-", "a/b", "@",  "[", "`",    "{",  "a:"})
        EXPECT_EQ(is_identifier(word), identifier(word) == word) << word;
}

TEST(Text, TheNearestNameIsASlipAway) {
    const std::string names[] = {"amount", "gradient", "uv"};
    EXPECT_EQ(nearest("amout", names), "amount");
    EXPECT_EQ(nearest("gradeint", names), "gradient");
    EXPECT_EQ(nearest("u", names), "uv");
    EXPECT_EQ(nearest("color", names), "");
    EXPECT_EQ(nearest("", {}), "");
    EXPECT_EQ(nearest(std::string(100'000, 'a'), names), "");
}

TEST(Text, SplitKeepsEmptyParts) {
    using Parts = std::vector<std::string_view>;
    EXPECT_EQ(split("a:b", ':'), (Parts{"a", "b"}));
    EXPECT_EQ(split(":a:", ':'), (Parts{"", "a", ""}));
    EXPECT_EQ(split("", ':'), (Parts{""}));
}

TEST(Text, Utf8IsWellFormed) {
    EXPECT_TRUE(is_utf8(""));
    EXPECT_TRUE(is_utf8("aé€\xF0\x9F\x98\x80"));
    EXPECT_TRUE(is_utf8("\xF4\x8F\xBF\xBF"));
    for (const std::string_view bad :
         {"\x80", "\xC3", "\xC3x", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF0\x80\x80\x80",
          "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"})
        EXPECT_FALSE(is_utf8(bad));
}

TEST(Text, AListHoldsEachTextOnce) {
    StringPool list;
    EXPECT_EQ(list.add(""), 0u);
    const uint32_t weave = list.add("weave"), noise = list.add("noise");
    EXPECT_NE(weave, noise);
    EXPECT_EQ(list.add(std::string("weave")), weave);
    const StringPool moved = std::move(list);
    EXPECT_EQ(moved[weave] + moved[noise] + moved[0], "weavenoise");
}

}  // namespace
}  // namespace wrinkle
