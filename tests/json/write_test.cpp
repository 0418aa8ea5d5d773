#include "json/write.h"

#include <gtest/gtest.h>

#include <vector>

#include "json/parse.h"

namespace wrinkle::json {
namespace {

Value value_of(const std::string& text) {
    Diagnostics diagnostics;
    return parse(text, "g.json", diagnostics, 1000).root;
}

TEST(Write, OneLineKeepsNumbersAndOrder) {
    EXPECT_EQ(one_line(value_of("{ \"b\":1.0 ,\"a\":[ 1e2,\"\\u00e9\\/\" ]}")),
              "{ \"b\": 1.0, \"a\": [1e2, \"\xC3\xA9/\"] }");
    EXPECT_EQ(one_line(Value()), "null");
    EXPECT_EQ(one_line(value_of("[false,true,null,[],{}]")), "[false, true, null, [], {}]");
}

TEST(Write, PrettyOpensOnlyWhatDoesNotFit) {
    const Value v = value_of(R"({"a": [1, 2, 3], "b": {"c": "dddddddd"}, "e": []})");
    EXPECT_EQ(pretty(v), R"({ "a": [1, 2, 3], "b": { "c": "dddddddd" }, "e": [] })");
    EXPECT_EQ(pretty(v, 2, 0, 30),
              "{\n    \"a\": [1, 2, 3],\n    \"b\": { \"c\": \"dddddddd\" },\n    \"e\": []\n  }");
    EXPECT_EQ(pretty(v, 0, 0, 18),
              "{\n  \"a\": [1, 2, 3],\n  \"b\": {\n    \"c\": \"dddddddd\"\n  },\n  \"e\": []\n}");
}

TEST(Write, WidthIsWhatIsWritten) {
    for (const char* text : {R"({"a": [1, 2, 3], "b": {"c": "d"}})", "[[], {}, [true]]", "\"x\"",
                             R"([{"a": 1}, {"b": {"c": null}}])"}) {
        const Value v = value_of(text);
        const size_t columns = one_line(v).size();
        EXPECT_EQ(pretty(v, 0, 0, columns + 1), one_line(v));
        if (v.size() > 0) {
            EXPECT_NE(pretty(v, 0, 0, columns), one_line(v));
        }
        EXPECT_EQ(pretty(v, 0, 7, columns + 8), one_line(v));
    }
}

TEST(Build, ValuesMadeByHand) {
    const Value list =
        Value::array(std::vector{Value::number(0.1), Value::single(0.1f), Value::boolean(true),
                                 Value(), Value::string("a\"\n")});
    EXPECT_EQ(one_line(list), "[0.1, 0.1, true, null, \"a\\\"\\n\"]");
    const std::pair<std::string, Value> members[] = {{"x", list}, {"y", Value::number(1e300)}};
    const Value v = Value::object(members);
    EXPECT_EQ(one_line(v), "{ \"x\": [0.1, 0.1, true, null, \"a\\\"\\n\"], \"y\": 1e+300 }");
    EXPECT_FALSE(v.has_location());
    EXPECT_EQ(v.location().line, 0u);
    EXPECT_EQ(v.find("x").at(4).pointer(), "/x/4");
}

TEST(Build, PartsOfAReadValueKeepTheirSpelling) {
    const Value old = value_of("[8.0, 8]");
    EXPECT_EQ(one_line(Value::array(std::vector{Value::number(3), old.at(0)})), "[3, 8.0]");
}

TEST(Equality, IsOfValuesNotOfSpelling) {
    EXPECT_TRUE(value_of("[1.0, {\"a\": \"\\u0041\"}]") == value_of("[1, {\"a\": \"A\"}]"));
    EXPECT_FALSE(value_of("[1]") == value_of("[2]"));
    EXPECT_FALSE(value_of("[[1], 2]") == value_of("[[1, 2]]"));
    EXPECT_FALSE(value_of("[\"1\"]") == value_of("[1]"));
    EXPECT_TRUE(value_of("null") == Value());
    EXPECT_FALSE(value_of("0") == Value());
    EXPECT_FALSE(value_of("true") == value_of("false"));
}

}  // namespace
}  // namespace wrinkle::json
