// Tests of plugins that exit, crash or misbehave in build(), in every command that runs it: the
// program continues, names plugin and node, and its output is unaffected.
#include <gtest/gtest.h>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

class PluginDeath : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        put("p/dying.so", bytes_of(WRINKLE_DYING_PLUGIN));
    }

    static std::string graph(const std::string& way) {
        return R"({
  "wrinkle": 1,
  "nodes": {
    "mine": { "type": "dying", "in": { "value": 0.25, "way": ")" +
               way + R"(" } },
    "normal": { "type": "resolve", "in": { "gradient": { "from": "mine.value" } } }
  },
  "outputs": { "normal": { "from": "normal.normal" }, "value": { "from": "mine.value" } }
}
)";
    }

    Ran run_on(const std::string& way, std::vector<std::string> words) {
        put("g.json", graph(way));
        words.insert(words.end(), {"g.json", "--plugin-path", "p/dying.so"});
        return run(words);
    }

    // `deaths`: ways to fail, each with the message after "the plugin p/dying.so cannot be used: ".
    void expect_at_the_node(const std::vector<std::pair<const char*, const char*>>& deaths) {
        for (const auto& [way, words] : deaths) {
            const Ran ran = run_on(way, {"compile"});
            EXPECT_EQ(ran.code, 1) << way;
            EXPECT_EQ(ran.out, "") << way;
            EXPECT_EQ(ran.err, at_the_node + "the plugin p/dying.so cannot be used: " + words +
                                   " (report it to the author of the node)\n")
                << way;
        }
    }

    const std::string at_the_node = "g.json:4:5: error: node 'mine': ";
};

TEST_F(PluginDeath, InBuildIsAnErrorAtTheNode) {
    expect_at_the_node({
        {"ends", "it ended the program in build(), with exit code 0"},
        {"ends_at_once", "it ended the program in build(), with exit code 0"},
        {"aborts", "it crashed in build(): SIGABRT (Aborted)"},
        {"crashes", "it crashed in build(): SIGSEGV (Segmentation fault)"},
        {"recurses", "it crashed in build(): SIGSEGV (Segmentation fault)"},
        {"hangs", "it hung in build(): it was ended after 5 s"},
        {"emits", "it makes more than 100000 calls in build()"},
        {"closes", "it closed the files of its process in build()"},
        {"throws", "its build() threw an exception: thrown other.json:1:1: error: forged"},
    });
}

TEST_F(PluginDeath, OfTooMuchMemoryIsAnErrorAtTheNode) {
    LIMITED_MEMORY;
    expect_at_the_node({
        {"takes_memory", "its build() threw an exception: std::bad_alloc"},
        {"allocates", "it crashed in build(): SIGSEGV (Segmentation fault)"},
    });
}

TEST_F(PluginDeath, IsAMessageOfEveryCommand) {
    const std::vector<std::vector<std::string>> commands = {
        {"compile", "-o", "out"},
        {"compile", "--target", "spirv", "-o", "out"},
        {"eval", "--mesh", "plane", "--uv", "0.5,0.5"},
        {"render", "-o", "out.png", "--size", "16x16"},
        {"bake", "--mesh", "plane", "-o", "out.png", "--size", "16"},
    };
    for (const auto& command : commands)
        for (const char* way : {"ends", "crashes"}) {
            const Ran ran = run_on(way, command);
            EXPECT_EQ(ran.code, 1) << command[0];
            EXPECT_EQ(ran.out, "") << command[0];
            EXPECT_TRUE(says(ran.err, at_the_node + "the plugin p/dying.so cannot be used: it "))
                << command[0];
            EXPECT_EQ(files(), (std::vector<std::string>{"g.json", "p", "p/dying.so"}));
        }
}

TEST_F(PluginDeath, IsAFailureOfATestCase) {
    put("g.json", graph("crashes"));
    put("g.test.json", R"({"points": [{}], "expect": [{"value": 0.25}]})");
    const Ran ran = run({"test", ".", "--plugin-path", "p"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.out, "0 passed, 1 failed"));
    EXPECT_TRUE(says(ran.out + ran.err, "it crashed in build(): SIGSEGV (Segmentation fault)"));
}

TEST_F(PluginDeath, OfOneGraphLeavesTheOthers) {
    put("a.json", graph("crashes"));
    put("b.json", graph("fine"));
    const Ran ran = run({"compile", "a.json", "b.json", "-o", "out", "--plugin-path", "p"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "a.json:4:5: error: node 'mine': "));
    EXPECT_EQ(ran.err.find("b.json"), ran.err.npos) << ran.err;
    EXPECT_EQ(run({"compile", "b.json", "--plugin-path", "p"}).code, 0);
}

// The constructor of the plugin ends any other process.
TEST_F(PluginDeath, CodeIsNeverLoadedIntoTheProgram) {
    const Ran ran = run_on("fine", {"eval", "--mesh", "plane", "--uv", "0.5,0.5"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(says(ran.out, "\"value\": 0.25"));
}

TEST_F(PluginDeath, PrintsOfAPluginAreNotInTheOutput) {
    const Ran fine = run_on("fine", {"compile"});
    const Ran prints = run_on("prints", {"compile"});
    EXPECT_EQ(prints.code, 0);
    EXPECT_EQ(prints.err, "");
    EXPECT_EQ(prints.out, fine.out);
}

// The plugin changes the working folder, the environment, the limits and the file mode mask.
TEST_F(PluginDeath, ChangesOfAPluginStayInItsProcess) {
    run_on("fine", {"compile", "-o", "fine.glsl"});
    const Ran ran = run_on("changes", {"compile", "-o", "changes.glsl"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(get("changes.glsl"), get("fine.glsl"));
}

TEST_F(PluginDeath, AMessageOfAPluginIsOneLineThatForgesNothing) {
    const Ran ran = run_on("forges", {"compile"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_EQ(ran.err, at_the_node + "one other.json:1:1: error: two [2J end\n");
}

TEST_F(PluginDeath, AMessageOfAPluginEndsAfter4096Bytes) {
    const Ran ran = run_on("says_much", {"compile"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_EQ(ran.err, at_the_node + std::string(4096, 'x') + "...\n");
}

TEST_F(PluginDeath, ResultsOfAFunctionMayTakeThePlaceOfItsArguments) {
    const Ran ran = run_on("aliases", {"eval", "--mesh", "plane", "--uv", "0.5,0.5"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(says(ran.out, "\"value\": 0.5"));
}

TEST_F(PluginDeath, ANodeOfManyCallsIsCompiled) {
    const Ran ran = run_on("many", {"eval", "--mesh", "plane", "--uv", "0.5,0.5"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(says(ran.out, "\"value\": 5001"));
}

}  // namespace
}  // namespace wrinkle::test
