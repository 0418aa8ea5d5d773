// Tests of dependency files with unusual names: real Make and real Ninja read the exact name, or
// the name is an error.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

class DepfileTest : public CliTest {
protected:
    Ran run_as(const std::string& other, const std::vector<std::string>& args) {
        const std::string wrinkle = std::exchange(program, other);
        const Ran ran = run(args);
        program = wrinkle;
        return ran;
    }

    // Returns true if Make treats the graph as a prerequisite: only a newer graph triggers the
    // rule.
    bool make_reads(const std::string& name) {
        put("Makefile", "all: out.glsl\nout.glsl:\n\t@echo made\ninclude out.d\n");
        const auto then = fs::last_write_time(folder / "out.glsl");
        fs::last_write_time(folder / name, then - std::chrono::hours(1));
        const int before = run_as(MAKE, {"-q", "out.glsl"}).code;
        fs::last_write_time(folder / name, then + std::chrono::hours(1));
        return before == 0 && run_as(MAKE, {"-q", "out.glsl"}).code == 1;
    }

    // Returns true if the graph is the only dependency that Ninja records for the step.
    bool ninja_reads(const std::string& name) {
        put("in", "");
        fs::copy_file(folder / "out.glsl", folder / "kept");
        put("build.ninja",
            "rule r\n  command = cp kept out.glsl\n  depfile = out.d\n  deps = gcc\n"
            "build out.glsl: r in\n");
        const Ran built = run_as(NINJA, {"--quiet"});
        if (built.code != 0) return false;
        return says(run_as(NINJA, {"-t", "deps", "out.glsl"}).out, "(VALID)\n    " + name + "\n\n");
    }

    void fresh_folder() {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
};

TEST_F(DepfileTest, EachNameIsReadByMakeAndByNinjaOrRefused) {
    std::vector<std::string> names;
    for (int c = 1; c < 0x80; ++c)
        for (const char* frame : {"a?b", "?b", "a?", "a??b", "a\\?b", "a ?b"}) {
            std::string name;
            for (const char each : std::string(frame))
                name += each == '?' ? static_cast<char>(c) : each;
            if (c != '/') names.push_back(name);
        }
    names.insert(names.end(),
                 {"a b#c:d$e\\f", "\u00E4\u2028.json", "50%.json", "it(1) [2] {3}~,+@!"});
    size_t held = 0;
    for (const std::string& name : names) {
        SCOPED_TRACE(testing::PrintToString(name));
        fresh_folder();
        put(name, tilt_graph());
        const Ran ran = run({"compile", "-o", "out.glsl", "-MD", "-MF", "out.d", "--", name});
        if (ran.code == 0) {
            ++held;
            EXPECT_TRUE(make_reads(name));
            EXPECT_TRUE(ninja_reads(name));
        } else {
            EXPECT_EQ(ran.code, 1);
            EXPECT_TRUE(says(ran.err, "no dependency file can hold the name"));
            EXPECT_EQ(files().size(), 1u) << "something was written";
        }
    }
    EXPECT_GT(held, 400u);
}

TEST_F(DepfileTest, ANameWithALineBreakRunsNoRecipe) {
    const std::string name = "g.json\nall:\n\ttouch broken\n";
    put(name, tilt_graph());
    for (const std::vector<std::string>& more :
         std::vector<std::vector<std::string>>{{}, {"-MP"}, {"-MT", "x"}}) {
        std::vector<std::string> words{"compile", name, "-o", "out.glsl", "-MD", "-MF", "out.d"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(run(words).code, 1);
    }
    put("fine.json", tilt_graph());
    EXPECT_EQ(run({"compile", "fine.json", "-o", "o", "-MD", "-MT", "x\ny: ;touch broken"}).code,
              1);
    EXPECT_EQ(run({"compile", "fine.json", "-o", "SHELL=x", "-MD"}).code, 1);
    EXPECT_EQ(files(), (std::vector<std::string>{"fine.json", name}));
}

TEST_F(DepfileTest, ABakeRefusesSuchNamesBeforeItBegins) {
    put("g;x.json", tilt_graph());
    const Ran ran = run({"bake", "g;x.json", "--mesh", "sphere", "--size", "8", "--map", "normal",
                         "-o", "out.png", "-MD"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "no dependency file can hold the name 'g;x.json'"));
    EXPECT_FALSE(exists("out.png"));
}

}  // namespace
}  // namespace wrinkle::test
