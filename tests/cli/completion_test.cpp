// Tests of shell completion: commands, options, their values, files, and nodes of plugins.
#include <algorithm>

#include "base/text.h"
#include "cli/support.h"

namespace wrinkle::test {
namespace {

using Names = std::vector<std::string>;

class CompletionTest : public CliTest {
protected:
    // The lines that are offered for these words; the last word is incomplete.
    Names offered(const Names& words) const {
        Names args{"complete", "--"};
        args.insert(args.end(), words.begin(), words.end());
        const Ran ran = run(args);
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.err, "");
        Names lines;
        for (const std::string_view line : split(ran.out, '\n'))
            if (!line.empty()) lines.emplace_back(line);
        return lines;
    }

    // The value of COMPREPLY in bash after it has sourced the script.
    std::string in_bash(const std::string& words, int cursor) const {
        put("wrinkle.bash", run({"completion", "bash"}).out);
        put("ask.bash", "source ./wrinkle.bash\nCOMP_WORDS=(" + words +
                            ")\nCOMP_CWORD=" + std::to_string(cursor) + "\n_wrinkle " +
                            WRINKLE_BINARY_DIR
                            "/bin/wrinkle\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
        const std::string command = "cd '" + folder.string() + "' && bash ask.bash > answer 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0);
        return get("answer");
    }
};

bool has(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

TEST_F(CompletionTest, OffersCommands) {
    EXPECT_EQ(offered({"c"}), (Names{"check", "compare", "compile", "completion", "convert"}));
    EXPECT_TRUE(has(offered({""}), "render"));
    EXPECT_EQ(offered({"watch", "com"}), (Names{"compare", "compile"}));
    EXPECT_EQ(offered({"watch", "compile", "--targ"}), Names{"--target"});
    EXPECT_FALSE(has(offered({""}), "complete"));
    EXPECT_EQ(offered({}), Names{});
}

TEST_F(CompletionTest, OffersOptionsAndTheirValues) {
    EXPECT_EQ(offered({"render", "--li"}), (Names{"--light", "--lighting", "--list-targets"}));
    EXPECT_EQ(offered({"eval", "--precision", ""}), (Names{"double", "float"}));
    EXPECT_EQ(offered({"eval", "--precision=f"}), Names{"--precision=float"});
    EXPECT_EQ(offered({"eval", "--precision", "=", "d"}), Names{"double"});
    EXPECT_TRUE(has(offered({"compile", "--target", "g"}), "glsl330"));
    EXPECT_TRUE(has(offered({"compile", "--target", "h"}), "hlsl"));
    EXPECT_TRUE(has(offered({"compile", "--target", ""}), "essl300"));
    EXPECT_TRUE(has(offered({"render", "--mesh", "to"}), "torus"));
    EXPECT_EQ(offered({"completion", "z"}), Names{"zsh"});
}

TEST_F(CompletionTest, OffersNodesAlsoOfPlugins) {
    const std::string plugin = WRINKLE_BINARY_DIR "/lib/wrinkle/plugins/ripples.so";
    EXPECT_EQ(offered({"nodes", "gradient_m"}), Names{"gradient_mix"});
    EXPECT_EQ(offered({"nodes", "rip"}), Names{});
    EXPECT_EQ(offered({"nodes", "--plugin-path", plugin, "rip"}), Names{"ripples"});
}

TEST_F(CompletionTest, OffersFilesOfTheRightKind) {
    for (const char* name : {"a.json", "b.png", "c.so", "d.test.json", "inner/e.json", ".f.json"})
        put(name, "");
    EXPECT_EQ(offered({"check", ""}), (Names{"a.json", "d.test.json", "inner/"}));
    EXPECT_EQ(offered({"check", "a.json", "inner/"}), Names{"inner/e.json"});
    EXPECT_EQ(offered({"test", ""}), (Names{"d.test.json", "inner/"}));
    for (const char* option : {"--test", "--manifest"})
        EXPECT_EQ(offered({"plugins", option, ""}), (Names{"c.so", "inner/"})) << option;
    EXPECT_EQ(offered({"nodes", "--plugin-path", ""}), (Names{"c.so", "inner/"}));
    EXPECT_EQ(offered({"check", "--root", ""}), Names{"inner/"});
    EXPECT_EQ(offered({"compile", "a.json", "-o", ""}), Names{});  // the shell completes the file
    EXPECT_EQ(offered({"explain-log", ""}), (Names{"a.json", "d.test.json", "inner/"}));
    EXPECT_EQ(offered({"explain-log", "a.json", ""}), Names{});  // a log may have any name
}

TEST_F(CompletionTest, WorksInBash) {
    put("two words.json", "");
    put("graphs/a.json", "");
    EXPECT_EQ(in_bash("wrinkle form", 1), "format\n");
    EXPECT_EQ(in_bash("wrinkle check ''", 2), "graphs/\ntwo\\ words.json\n");
    EXPECT_EQ(in_bash("wrinkle eval --precision = fl g.json", 4), "float\n");
}

TEST_F(CompletionTest, HasAScriptForEachShell) {
    for (const char* shell : {"bash", "zsh", "fish"}) {
        const Ran ran = run({"completion", shell});
        EXPECT_EQ(ran.code, 0);
        EXPECT_TRUE(says(ran.out, " complete -- "));
    }
    EXPECT_EQ(run({"completion", "tcsh"}).code, 2);
    EXPECT_EQ(run({"completion"}).code, 2);
}

}  // namespace
}  // namespace wrinkle::test
