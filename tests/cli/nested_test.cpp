// Tests of thirty files that each use the next one twice: check, compile and inputs succeed; eval
// and render, which would run every call, fail with the number of calls.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

class NestedTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        for (int level = 0; level < 30; ++level) {
            const std::string next = "graph:g" + std::to_string(level + 1) + ".json";
            const std::string from = level == 0 ? "waves.height" : "input.h";
            const auto use = [&](const std::string& name, const std::string& amount) {
                return "\"s" + name +
                       "\": {\"type\": \"height_scale\", \"in\": {\"height\": {\"from\": \"" +
                       from + "\"}, \"amount\": " + amount + "}}, \"" + name + "\": {\"type\": \"" +
                       next + "\", \"in\": {\"h\": {\"from\": \"s" + name + ".height\"}}}, ";
            };
            put("g" + std::to_string(level) + ".json",
                graph(level == 0, use("a", "0.5") + use("b", "0.75") +
                                      R"("waves": {"type": "waves"}, "sum": {"type": "height_add",
                                      "in": {"a": {"from": "a.h"}, "b": {"from": "b.h"}}})"));
        }
        put("g30.json", graph(false, R"("sum": {"type": "height_min", "in":
            {"a": {"from": "input.h"}, "b": 0.001}})"));
    }

    static std::string graph(bool top, const std::string& nodes) {
        const std::string inputs = top ? "" : R"("inputs": {"h": {"type": "height"}}, )";
        const std::string outputs = top ? R"("displacement": {"from": "sum.height"},
                                            "normal": {"from": "sum.height"})"
                                        : R"("h": {"from": "sum.height"})";
        return "{\"wrinkle\": 1, " + inputs + "\"nodes\": {" + nodes + "}, \"outputs\": {" +
               outputs + "}}";
    }

    void expect_refused(const std::vector<std::string>& args, const std::string& doing) {
        const Ran ran = run(args);
        EXPECT_EQ(ran.code, 1);
        EXPECT_EQ(ran.out, "");
        EXPECT_EQ(ran.err, "g0.json: error: " + doing +
                               " would make 2147483646 calls of sub-graphs, and makes 100000 at "
                               "most ('wrinkle compile' makes a function of each sub-graph)\n");
        EXPECT_FALSE(exists("out.png"));
    }
};

TEST_F(NestedTest, ThirtyLevelsAreCheckedAndCompiled) {
    EXPECT_EQ(run({"check", "g0.json"}).code, 0);
    const Ran ran = run({"compile", "g0.json"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_NE(ran.out.find("float wrinkle_g0_g30("), std::string::npos);
    EXPECT_NE(ran.out.find("wrinkle_g0_g1("), std::string::npos);
    EXPECT_LT(ran.out.size(), 60'000U);
    EXPECT_EQ(run({"inputs", "g0.json"}).code, 0);
}

TEST_F(NestedTest, ThirtyLevelsAreNotRun) {
    expect_refused({"eval", "g0.json", "--at", "{}"}, "eval");
    expect_refused({"render", "g0.json", "-o", "out.png"}, "render");
    expect_refused({"render", "g0.json", "--displace", "-o", "out.png"}, "render");
}

}  // namespace
}  // namespace wrinkle::test
