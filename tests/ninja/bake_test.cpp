// Tests of distributed bakes: the examples of docs/baking.md.
#include <cstdlib>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

class SharedBakeTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        put("graph.json", ramp_graph());
        put("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n");
        const Ran ran = run({"bake", "graph.json", "--mesh", "m.obj", "--map", "value", "--size",
                             "200", "-o", "whole.png"});
        ASSERT_EQ(ran.code, 0) << ran.err;
    }

    // Runs a system program with `wrinkle` in its PATH.
    Ran run_other(const std::string& name, const std::vector<std::string>& args) {
        program = name;
        return run(args, "", {"PATH=" WRINKLE_BINARY_DIR "/bin:" + std::string(getenv("PATH"))});
    }
};

// Returns the blocks of the page that begin with `first`, unindented, up to the next empty line.
std::string block(const std::string& first) {
    const std::string page = bytes_of(WRINKLE_SOURCE_DIR "/docs/baking.md");
    std::string text;
    size_t at = page.find("    " + first);
    EXPECT_NE(at, page.npos) << first;
    while (at != page.npos && page.compare(at, 4, "    ") == 0) {
        const size_t end = page.find('\n', at) + 1;
        text += page.substr(at + 4, end - at - 4);
        at = end;
    }
    return text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    size_t count = 0;
    for (size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
        ++count;
    }
    EXPECT_GT(count, 0U) << from;
    return text;
}

TEST_F(SharedBakeTest, NinjaBakesWhatChanged) {
    std::string rules = block("rule bake_part");
    put("build.ninja", replaced(rules, "--size 8192", "--map value --size 200"));
    const Ran ran = run_other(NINJA, {"-v"});
    ASSERT_EQ(ran.code, 0) << ran.out;
    EXPECT_EQ(get("normal.png"), get("whole.png"));
    EXPECT_TRUE(says(run_other(NINJA, {"-v"}).out, "no work to do"));
    put("m.obj", get("m.obj") + "# moved\n");
    EXPECT_TRUE(says(run_other(NINJA, {"-n"}).out, "[1/3]")) << "the mesh is a dependency";
}

TEST_F(SharedBakeTest, ShellAndParallelGiveTheSameBytes) {
    const std::string shell =
        replaced(replaced(block("for i in 1 2 3 4"), "--size 16384", "--map value --size 200"),
                 "normal.png", "shell.png");
    const Ran ran = run_other("/bin/sh", {"-ec", shell});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(get("shell.png"), get("whole.png"));
    if (std::system("parallel --version >/dev/null 2>&1") != 0)
        GTEST_SKIP() << "GNU parallel is not installed";
    std::string line = replaced(block("parallel wrinkle bake"), "64", "5");
    line = replaced(line, "m.obj", "m.obj --map value --size 200");
    line += "wrinkle bake --merge part1 part2 part3 part4 part5 -o parallel.png";
    fs::remove_all(folder / "part1");
    const Ran shared = run_other("/bin/sh", {"-ec", line});
    ASSERT_EQ(shared.code, 0) << shared.err;
    EXPECT_EQ(get("parallel.png"), get("whole.png"));
}

// Runs the script of the job array once per index.
TEST_F(SharedBakeTest, TheScriptOfAnArrayBakesItsShard) {
    put("bake.sh", replaced(replaced(block("#!/bin/sh"), "/64", "/3"), "m.obj",
                            "m.obj --map value --size 200"));
    std::string all;
    for (const char* task : {"1", "2", "3"})
        all += "SLURM_ARRAY_TASK_ID=" + std::string(task) + " sh bake.sh; ";
    const Ran ran =
        run_other("/bin/sh", {"-ec", all + "wrinkle bake --merge part1 part2 part3 -o a.png"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(get("a.png"), get("whole.png"));
}

}  // namespace
}  // namespace wrinkle::test
