// Tests of lists of diagnostics: text, JSON, and the limit on their number.
#include "base/diagnostics.h"

#include <gtest/gtest.h>

namespace wrinkle {
namespace {

Diagnostic unknown_port() {
    return {RuleId::unknown_port,    Severity::error, {"graph.json", 12, 7},
            "/nodes/weave/in/amout", "weave",         "unknown port 'amout'",
            "did you mean 'amount'?"};
}

Diagnostic warning() {
    return file_problem(Severity::warning, RuleId::cache, "", "hm", "");
}

TEST(Diagnostics, ReadLikeACompilersMessages) {
    EXPECT_EQ(to_text(unknown_port()),
              "graph.json:12:7: error: node 'weave': unknown port 'amout' (did you mean "
              "'amount'?)");
    EXPECT_EQ(to_text(warning()), "warning: hm");
    Diagnostic file = warning();
    file.where.file = "a.json";
    EXPECT_EQ(to_text(file), "a.json: warning: hm");
}

TEST(Diagnostics, AreOneLineWhateverTheNamesHold) {
    const std::string name = "x\nother.json:1:1: error: \x1B[2J\u202E";
    const std::string shown = "x\\nother.json:1:1: error: \\x1b[2J\\u202e";
    Diagnostic d = unknown_port();
    d.where = {name, 1, 2};
    d.pointer = d.node = d.message = d.expected = name;
    EXPECT_EQ(to_text(d),
              shown + ":1:2: error: node '" + shown + "': " + shown + " (" + shown + ")");
    Diagnostics list;
    list.add(std::move(d));
    const std::string json = to_json(list);
    EXPECT_EQ(json.find('\x1B'), json.npos);
    EXPECT_NE(json.find(R"(x\nother.json:1:1: error: \u001b[2J\u202e)"), json.npos) << json;
}

TEST(Diagnostics, AsJson) {
    Diagnostics list;
    EXPECT_EQ(to_json(list), "{\"version\": 1, \"diagnostics\": [], \"dropped\": 0}\n");
    list.add(unknown_port());
    EXPECT_EQ(to_json(list),
              "{\"version\": 1, \"diagnostics\": [\n"
              "  {\"severity\": \"error\", \"rule\": \"unknown-port\", \"file\": \"graph.json\", "
              "\"line\": 12, \"column\": 7, "
              "\"pointer\": \"/nodes/weave/in/amout\", \"node\": \"weave\", "
              "\"message\": \"unknown port 'amout'\", \"expected\": \"did you mean 'amount'?\"}"
              "], \"dropped\": 0}\n");
}

TEST(Diagnostics, KeepTheFirstAndCountTheRest) {
    Diagnostics list(2);
    list.add(warning());
    EXPECT_FALSE(list.has_errors());
    for (int i = 0; i < 3; ++i)
        list.error(RuleId::option, "e" + std::to_string(i));
    EXPECT_TRUE(list.has_errors());
    EXPECT_EQ(list.error_count(), 3u);
    EXPECT_EQ(list.list().size(), 2u);
    EXPECT_EQ(list.dropped(), 2u);
    EXPECT_EQ(to_text(list), "warning: hm\nerror: e0\nand 2 more problems\n");
}

TEST(Diagnostics, AppendedOnesCountEvenWhereTheyWereDropped) {
    Diagnostics full(1);
    full.add(warning());
    full.error(RuleId::option, "lost");
    Diagnostics list;
    list.append(full);
    EXPECT_TRUE(list.has_errors());
    EXPECT_EQ(list.error_count(), 1u);
    EXPECT_EQ(list.dropped(), 1u);
}

}  // namespace
}  // namespace wrinkle
