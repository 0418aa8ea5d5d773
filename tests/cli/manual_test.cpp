// Tests of wrinkle man: every command has a page with the contents of its help, which groff
// accepts.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

using ManualTest = CliTest;
using Names = std::vector<std::string>;

TEST_F(ManualTest, APageForEachCommand) {
    ASSERT_EQ(run({"man", "--folder", "man1"}).code, 0);
    Names commands;
    for (const std::string& name : files())
        if (name.starts_with("man1/wrinkle-"))
            commands.push_back(name.substr(13, name.size() - 15));
    EXPECT_GE(commands.size(), 12u);
    const std::string whole = get("man1/wrinkle.1");
    EXPECT_EQ(whole, run({"man"}).out);
    for (const std::string& command : commands) {
        const std::string page = get("man1/wrinkle-" + command + ".1");
        EXPECT_EQ(page, run({"man", command}).out);
        EXPECT_TRUE(says(run({"--help"}).out, "\n  " + command + " ")) << command;
        for (const char* section : {".SH NAME", ".SH SYNOPSIS", ".SH OPTIONS", ".SH EXIT STATUS"})
            EXPECT_TRUE(says(page, section));
    }
}

TEST_F(ManualTest, NamesEveryOptionOfTheHelp) {
    const std::string page = run({"man", "compile"}).out, help = run({"compile", "--help"}).out;
    size_t options = 0;
    for (size_t at = help.find("\n  -"); at != help.npos; at = help.find("\n  -", at + 1)) {
        std::string name = help.substr(at + 3, help.find_first_of(" ,\n", at + 3) - at - 3);
        for (size_t dash = name.find('-'); dash != name.npos; dash = name.find('-', dash + 2))
            name.insert(dash, "\\");
        EXPECT_TRUE(says(page, "\\fB" + name + "\\fR"));
        ++options;
    }
    EXPECT_GE(options, 20u);
    EXPECT_TRUE(says(page, "function|shader"));
    EXPECT_TRUE(says(page, "default: baked"));
}

TEST_F(ManualTest, AnUnknownCommandIsWrongUsage) {
    const Ran ran = run({"man", "bake-a-cake"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_TRUE(says(ran.err, "there is no command 'bake-a-cake'"));
}

TEST_F(ManualTest, GroffHasNothingToSay) {
    const std::string groff = GROFF;
    if (groff.empty()) GTEST_SKIP() << "groff is not installed";
    ASSERT_EQ(run({"man", "--folder", "man1"}).code, 0);
    const Names pages = files();
    program = groff;
    for (const std::string& page : pages) {
        if (!page.ends_with(".1")) continue;
        const Ran ran = run({"-man", "-ww", "-Tutf8", page});
        EXPECT_EQ(ran.code, 0);
        EXPECT_EQ(ran.err, "") << page;
        EXPECT_TRUE(says(ran.out, "Wrong usage."));
    }
    put("bad.1", ".TH BAD 1\n.NOREQUEST\n");
    EXPECT_NE(run({"-man", "-ww", "-Tutf8", "bad.1"}).err, "") << "it would say so";
}

}  // namespace
}  // namespace wrinkle::test
