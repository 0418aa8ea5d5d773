// Tests of parsing: every kind of invalid text, with its exact report and the values parsed before
// it.
#include "json/parse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "json/write.h"

namespace wrinkle::json {
namespace {

std::string problems(const std::string& text, uint32_t max_depth = 64) {
    Diagnostics diagnostics;
    parse(text, "g.json", diagnostics, max_depth);
    return to_text(diagnostics);
}

Value read(const std::string& text) {
    Diagnostics diagnostics;
    const Parsed parsed = parse(text, "g.json", diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    EXPECT_TRUE(parsed.complete);
    return parsed.root;
}

// Reports on these tokens separated by this space; locations are given as the index of the first
// token that ends after them.
std::string report_by_token(const std::vector<std::string>& tokens, const std::string& space) {
    std::string text, reports;
    std::vector<size_t> ends;
    for (const std::string& token : tokens) {
        text += token;
        ends.push_back(text.size());
        text += space;
    }
    Diagnostics diagnostics;
    const Parsed parsed = parse(text, "g.json", diagnostics);
    for (const Diagnostic& each : diagnostics.list()) {
        size_t at = 0;
        for (uint32_t line = 1; line < each.where.line; ++line)
            at = text.find('\n', at) + 1;
        at += each.where.column - 1;
        const auto token = std::upper_bound(ends.begin(), ends.end(), at) - ends.begin();
        reports += std::to_string(token) + " " + each.pointer + " " + each.message + " " +
                   each.expected + "\n";
    }
    return reports + (parsed.root.tree() ? one_line(parsed.root) : "");
}

TEST(Parse, KindsAndSpellings) {
    const Value v = read(R"({"a": null, "b": true, "c": 1.50e1, "d": "x\u00e9\n", "e": [1, -0]})");
    ASSERT_EQ(v.size(), 5u);
    EXPECT_TRUE(v.find("a").is(Kind::null));
    EXPECT_TRUE(v.has("a"));
    EXPECT_FALSE(v.has("z"));
    EXPECT_TRUE(v.find("b").as_boolean());
    EXPECT_EQ(v.find("c").as_number(), 15.0);
    EXPECT_EQ(v.find("c").spelling(), "1.50e1");
    EXPECT_EQ(v.find("d").as_string(), "x\xC3\xA9\n");
    EXPECT_EQ(v.find("e").at(1).spelling(), "-0");
    EXPECT_EQ(v.find("e").at(0).as_number(), 1.0);
}

TEST(Parse, ChildrenStandInOrder) {
    std::string keys;
    for (const Member& member : read(R"({"z": {"q": [1,[2]]}, "a": [], "m": {}})").children())
        keys += std::string(member.key) + "=" + one_line(member.value) + ";";
    EXPECT_EQ(keys, "z={ \"q\": [1, [2]] };a=[];m={};");
    size_t items = 0;
    for (const Member& member : read("[[], {}, 3]").children())
        items += member.key.empty() ? 1 : 0;
    EXPECT_EQ(items, 3u);
    for (const Member& member : Value().children())
        ADD_FAILURE() << member.key;
}

TEST(Parse, PlacesAndPointers) {
    const Value v = read("{\n  \"\xC3\xA9\": 1, \"b/~\": [10,\n\t{\"x\": \"y\"}]\n}");
    const Value b = v.find("b/~");
    EXPECT_EQ(b.location().line, 2u);
    EXPECT_EQ(b.key_location().column, 11u);  // é is one column
    EXPECT_EQ(b.location().column, 18u);
    const Value x = b.at(1).find("x");
    EXPECT_EQ(x.location().line, 3u);
    EXPECT_EQ(x.location().column, 8u);
    EXPECT_EQ(x.pointer(), "/b~1~0/1/x");
    EXPECT_EQ(b.at(0).key_location().column, b.at(0).location().column);
    EXPECT_EQ(v.pointer(), "");
}

TEST(Parse, ByteOrderMarkIsNoColumn) {
    const Value v = read("\xEF\xBB\xBF{\"a\": 1}");
    EXPECT_EQ(v.location().column, 1u);
    EXPECT_EQ(v.find("a").location().column, 7u);
}

TEST(Parse, ColumnsOfLongLines) {
    std::string text = "[";
    for (int i = 0; i < 10000; ++i)
        text += "\"\xC3\xA9\",";
    const Value v = read(text + "7]");
    EXPECT_EQ(v.at(10000).location().column, 1u + 1 + 10000 * 4);
}

TEST(Parse, LocationOfTheEndOfATextOfAnySize) {
    for (const size_t size : {4095, 4096, 4097, 8192}) {
        Diagnostics diagnostics;
        parse("[" + std::string(size - 1, ' '), "g.json", diagnostics);
        EXPECT_TRUE(to_text(diagnostics).starts_with("g.json:1:" + std::to_string(size + 1) + ":"))
            << to_text(diagnostics);
    }
}

// The oracle counts from the beginning of the text.
TEST(Parse, LocationsInALongText) {
    std::string text = "\xEF\xBB\xBF[";
    for (int i = 0; i < 4000; ++i)
        text += i % 7 == 0 ? "\"\u00e9\xc3\xa9\"," : i % 500 == 499 ? "\n1," : "12,";
    text += "0]";
    const Value all = read(text);
    ASSERT_EQ(all.size(), 4001u);
    for (size_t i = 0; i < all.size(); i += 3) {
        const Value item = all.at(i);
        uint32_t line = 1, column = 1;
        for (uint32_t k = 3; k < item.offset(); ++k) {
            const bool ends = text[k] == '\n', begins = (text[k] & 0xC0) != 0x80;
            line += ends;
            column = ends ? 1 : column + begins;
        }
        EXPECT_EQ(item.location().line, line) << i;
        EXPECT_EQ(item.location().column, column) << i;
    }
}

TEST(Parse, SyntaxErrorsSayWhatAndWhere) {
    EXPECT_EQ(problems(""), "g.json:1:1: error: unexpected end of the file (expected a value)\n");
    EXPECT_EQ(problems("{\"a\": 1,\n"),
              "g.json:2:1: error: unexpected end of the file (expected a key in double quotes)\n");
    EXPECT_EQ(problems("[1, 2"),
              "g.json:1:6: error: unexpected end of the file (expected ',' or ']')\n");
    EXPECT_EQ(problems("{\"a\": 1,}"),
              "g.json:1:9: error: unexpected '}' (remove the comma before it)\n");
    EXPECT_EQ(problems("[1,,2]"), "g.json:1:4: error: unexpected ',' (expected a value)\n");
    EXPECT_EQ(problems("[1 2]"), "g.json:1:4: error: unexpected number 2 (expected ',' or ']')\n");
    EXPECT_EQ(problems("{\"a\", \"b\"}"), "g.json:1:5: error: unexpected ',' (expected ':')\n");
    EXPECT_EQ(problems("{\"a\" 1}"), "g.json:1:6: error: unexpected number 1 (expected ':')\n");
    EXPECT_EQ(problems("{a: 1}"),
              "g.json:1:2: error: unexpected 'a' (expected a key in double quotes)\n");
    EXPECT_EQ(problems("[1] x"),
              "g.json:1:5: error: unexpected 'x' (expected the end of the file)\n");
    EXPECT_EQ(problems("[1] [2]"),
              "g.json:1:5: error: unexpected '[' (expected the end of the file)\n");
    EXPECT_EQ(problems("[tru]"), "g.json:1:2: error: unexpected 'tru' (expected a value)\n");
    EXPECT_EQ(problems("[1] // no"), "g.json:1:5: error: JSON has no comments (remove it)\n");
    EXPECT_EQ(problems("{'a': 1}"),
              "g.json:1:2: error: unexpected character ' (strings need double quotes)\n");
    EXPECT_EQ(problems("{\"a\": \"bc\n}"),
              "g.json:1:10: error: the string has no closing quote on its line (expected '\"', or "
              "\\n for a line break)\n");
    EXPECT_EQ(problems("[\"b\tc\"]"),
              "g.json:1:4: error: the string contains the unescaped byte 0x09 (write \\u0009)\n");
    EXPECT_EQ(problems("[\"b\\qc\"]"),
              "g.json:1:5: error: the string has an invalid escape (expected \\\", \\\\, \\/, \\b, "
              "\\f, \\n, \\r, \\t, or \\u and four hexadecimal digits, surrogates in pairs)\n");
    EXPECT_EQ(problems("[1-2]"), "g.json:1:3: error: unexpected number -2 (expected ',' or ']')\n");
    EXPECT_EQ(problems("[1 \"a\"]"),
              "g.json:1:4: error: unexpected string (expected ',' or ']')\n");
    EXPECT_EQ(problems("[1.5, -e5]"),
              "g.json:1:7: error: '-e5' is not a number (expected digit after '-')\n");
    EXPECT_EQ(problems("[\"bc"),
              "g.json:1:2: error: the string has no closing quote (expected '\"')\n");
}

// White space between tokens moves the location of a report and changes nothing else.
TEST(Parse, SpaceMovesReportsWithTheirTokens) {
    const std::vector<std::string> tokens = {"{", "}",     "[",    "]",  ",",      ":",
                                             "1", "\"a\"", "true", "x7", "\"\\n\""};
    const std::string spaces[] = {" ", "\t\t ", " \r\n  ", "\n\n"};
    std::mt19937 random(11);
    for (int round = 0; round < 3000; ++round) {
        std::vector<std::string> chosen(1 + random() % 9);
        for (std::string& token : chosen)
            token = tokens[random() % tokens.size()];
        std::set<std::string> reports;
        for (const std::string& space : spaces)
            reports.insert(report_by_token(chosen, space));
        EXPECT_EQ(reports.size(), 1u) << *reports.begin() << *reports.rbegin();
    }
}

TEST(Parse, Numbers) {
    EXPECT_EQ(problems("[NaN]"),
              "g.json:1:2: error: NaN is not a number in JSON (expected a finite number)\n");
    EXPECT_EQ(problems("[-Infinity]"),
              "g.json:1:2: error: -Infinity is not a number in JSON (expected a finite number)\n");
    EXPECT_EQ(problems("[1,1e999]"),
              "g.json:1:4: error: the number 1e999 is out of range (expected a finite number)\n");
    EXPECT_EQ(problems("[1.]"),
              "g.json:1:2: error: '1.' is not a number (expected digit after '.')\n");
    EXPECT_EQ(read("1e-999").as_number(), 0.0);
    EXPECT_EQ(read("123456789012345678901234567890").as_number(), 123456789012345678901234567890.0);
    EXPECT_EQ(read("12").spelling(), "12");
}

TEST(Parse, BytesThatAreNoText) {
    EXPECT_EQ(problems("[\"a\xFF\"]"),
              "g.json:1:4: error: the string is not valid UTF-8 at byte 0xFF (save the file as "
              "UTF-8)\n");
    EXPECT_EQ(problems("\xFF\xFE[]"),
              "g.json:1:1: error: unexpected byte 0xFF (expected a value)\n");
    EXPECT_EQ(problems(std::string("[]\0[]", 5)),
              "g.json:1:3: error: unexpected byte 0x00 (expected the end of the file)\n");
    EXPECT_EQ(problems(std::string("[1,\0", 4)),
              "g.json:1:4: error: unexpected byte 0x00 (expected a value)\n");
}

TEST(Parse, DuplicateKeysKeepTheFirst) {
    Diagnostics diagnostics;
    const Value v =
        parse("{\"a\": 1,\n \"a\": {\"x\": 2, \"x\": 3}, \"b\": 4}", "g.json", diagnostics).root;
    EXPECT_EQ(to_text(diagnostics),
              "g.json:2:16: error: key \"x\" occurs twice (first at line 2, column 8)\n"
              "g.json:2:2: error: key \"a\" occurs twice (first at line 1, column 2)\n");
    EXPECT_EQ(one_line(v), "{ \"a\": 1, \"b\": 4 }");
    std::string keys;
    for (const Member& member : v.children())
        keys += member.key;
    EXPECT_EQ(keys, "ab");
    EXPECT_EQ(v.size(), 2u);
    EXPECT_EQ(diagnostics.list()[0].pointer, "/a/x");
}

// Nested objects of 1 to 24 members each; the first of equal keys is retained, checked with a set.
TEST(Parse, EveryDuplicateOfObjectsOfAnySizeIsFound) {
    std::mt19937 random(7);
    size_t expected = 0;
    std::set<size_t> kept;  // sizes of the objects that occurred
    const auto object = [&](const auto& self, int depth) -> std::string {
        std::set<uint32_t> met;
        std::string text;
        const uint32_t count = 1 + random() % 24;
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t key = random() % 40;
            expected += !met.insert(key).second;
            const bool inner = depth < 3 && random() % 8 == 0;
            text += (i ? ",\"" : "{\"") + std::string(key % 7, 'k') + std::to_string(key) +
                    "\":" + (inner ? self(self, depth + 1) : "0");
        }
        kept.insert(met.size());
        return text + "}";
    };
    for (int i = 0; i < 200; ++i) {
        Diagnostics diagnostics;
        expected = 0;
        parse(object(object, 0), "g.json", diagnostics);
        EXPECT_EQ(diagnostics.error_count(), expected);
    }
    EXPECT_GT(*kept.rbegin(), 12u);
}

// A text may end after any key; members before the end are compared as well.
TEST(Parse, DuplicatesOfATextThatEnds) {
    for (int members = 1; members <= 20; ++members) {
        std::string text = "{\"k0\":0";
        for (int i = 1; i < members; ++i)
            text += ",\"k" + std::to_string(i) + "\":{\"in\":0,\"in\":1}";
        Diagnostics diagnostics;
        const Value root = parse(text + ",\"k0\":2,\"k1\"", "g.json", diagnostics).root;
        EXPECT_EQ(diagnostics.error_count(), static_cast<size_t>(members) + 1) << members;
        EXPECT_EQ(root.size(), static_cast<size_t>(members));
    }
}

TEST(Parse, AMillionDuplicatesAreCounted) {
    std::string text = "{";
    for (int i = 0; i < 300000; ++i)
        text += "\"a\":1,";
    Diagnostics diagnostics;
    parse(text + "\"a\":1}", "g.json", diagnostics);
    EXPECT_EQ(diagnostics.error_count(), 300000u);
    EXPECT_EQ(diagnostics.dropped(), 299000u);
}

TEST(Parse, DepthIsLimitedWithAPlace) {
    EXPECT_EQ(problems(std::string(100000, '[')),
              "g.json:1:65: error: nested more than 64 deep (arrays and objects nest at most 64 "
              "deep)\n");
    EXPECT_EQ(problems("[[[1]]]", 2),
              "g.json:1:3: error: nested more than 2 deep (arrays and objects nest at most 2 "
              "deep)\n");
    EXPECT_EQ(problems("[[[1]]]", 3), "");
}

TEST(Parse, DeepTextsAreReadWithoutRecursion) {
    const std::string deep = std::string(200000, '[') + std::string(200000, ']');
    Diagnostics diagnostics;
    const Value v = parse(deep, "g.json", diagnostics, 300000).root;
    EXPECT_FALSE(diagnostics.has_errors());
    EXPECT_TRUE(v == parse(deep, "h.json", diagnostics, 300000).root);
}

TEST(Parse, TheDeepestTextsAreWrittenAndBuilt) {
    const std::string deep = std::string(64, '[') + std::string(64, ']');
    const Value v = read(deep);
    EXPECT_EQ(one_line(v), deep);
    EXPECT_EQ(one_line(Value::array(std::vector{v})), "[" + deep + "]");
    EXPECT_TRUE(v == Value::array(std::vector{v.at(0)}));
}

TEST(Parse, WhatStoodBeforeAnErrorIsKept) {
    Diagnostics diagnostics;
    const Parsed parsed = parse("{\"a\": [1, 2], \"b\": {\"c\": 3, \"d\"", "g.json", diagnostics);
    EXPECT_FALSE(parsed.complete);
    EXPECT_EQ(one_line(parsed.root), "{ \"a\": [1, 2], \"b\": { \"c\": 3 } }");
    EXPECT_TRUE(parsed.root.cut_off());
    EXPECT_FALSE(parsed.root.find("a").cut_off());
    EXPECT_TRUE(parsed.root.find("b").cut_off());
    EXPECT_EQ(diagnostics.list()[0].pointer, "/b");
}

TEST(Parse, EveryTruncationIsOneErrorAtItsEndOrItsToken) {
    const std::string text =
        "{\"k\\u00e9y\": [1.5e3, -2, true, null, \"s\xC3\xA9t\"], \"o\": {\"p\": {}, \"q\": [[]]}}";
    for (size_t n = 0; n < text.size(); ++n) {
        Diagnostics diagnostics;
        const Parsed parsed = parse(text.substr(0, n), "g.json", diagnostics);
        EXPECT_FALSE(parsed.complete);
        ASSERT_EQ(diagnostics.error_count(), 1u) << text.substr(0, n);
        const Location where = diagnostics.list()[0].where;
        EXPECT_EQ(where.line, 1u);
        EXPECT_GE(where.column, 1u);
        EXPECT_LE(where.column, n + 1) << text.substr(0, n);
        one_line(parsed.root);
    }
}

}  // namespace
}  // namespace wrinkle::json
