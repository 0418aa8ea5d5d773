// Tests that the output does not depend on the environment and is complete after any kill.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

using SameBytesTest = CliTest;
using Names = std::vector<std::string>;

// The decimal separator is a comma in German; Turkish maps letter case differently. The test
// compiles the locales and checks nothing if their sources are missing.
TEST_F(SameBytesTest, InAnyLocale) {
    put("i.json", tilt_graph("0.123456"));
    const Names args{"compile", "i.json", "--params", "uniform", "--reflect", "r.json"};
    const std::string text = run(args).out, reflection = get("r.json");
    EXPECT_TRUE(says(reflection, "0.123456"));
    for (const std::string language : {"de_DE", "tr_TR"}) {
        fs::create_directories(folder / "locales");
        const fs::path made = folder / "locales" / (language + ".UTF-8");
        const std::string make = "localedef -i " + language + " -f UTF-8 " + made.string();
        if (std::system((make + " >/dev/null 2>&1").c_str()) != 0)
            GTEST_SKIP() << "localedef cannot make " << language << " (Debian package locales)";
        const Ran ran =
            run(args, "",
                {"LOCPATH=" + (folder / "locales").string(), "LC_ALL=" + language + ".UTF-8"});
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.out, text) << language;
        EXPECT_EQ(get("r.json"), reflection) << language;
    }
}

TEST_F(SameBytesTest, OverRuns) {
    const std::string sample = WRINKLE_SOURCE_DIR "/graphs/everything.json";
    const Ran first = run({"compile", sample});
    ASSERT_EQ(first.code, 0) << first.err;
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(run({"compile", sample}).out, first.out);
}

TEST_F(SameBytesTest, AFullDiskIsSaid) {
    put("g.json", tilt_graph());
    const Ran ran = run({"compile", "g.json", "-o", "/dev/full"});
    EXPECT_EQ(ran.code, 3);
    EXPECT_TRUE(says(ran.err, "/dev/full: cannot be written: No space left on device"));
    const Ran several = run({"compile", "g.json", "-o", "g.glsl", "-MD", "-MF", "/dev/full"});
    EXPECT_EQ(several.code, 3);
    EXPECT_TRUE(says(several.err, "/dev/full"));
}

// The file has the old or the new content at every moment.
TEST_F(SameBytesTest, AKilledCompilerLeavesWholeFiles) {
    put("old.json", tilt_graph("0.5"));
    put("new.json", tilt_graph("0.25"));
    const std::string old_text = run({"compile", "old.json", "--name", "g"}).out;
    const std::string new_text = run({"compile", "new.json", "--name", "g"}).out;
    put("g.glsl", old_text);
    for (int i = 0; i < 40; ++i) {
        const bool back = get("g.glsl") == new_text;
        const pid_t child =
            start({"compile", back ? "old.json" : "new.json", "--name", "g", "-o", "g.glsl"});
        usleep(static_cast<useconds_t>(500 * i));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        const std::string now = get("g.glsl");
        EXPECT_TRUE(now == old_text || now == new_text) << now;
    }
}

}  // namespace
}  // namespace wrinkle::test
