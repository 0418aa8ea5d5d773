// Tests of plugin discovery: the order of folders, manifests, the cache; graphs load no plugin.
#include <gtest/gtest.h>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

const fs::path ripples = WRINKLE_RIPPLES;

class PluginTest : public CliTest {
protected:
    void place(const fs::path& name) const {
        fs::create_directories((folder / name).parent_path());
        fs::copy_file(ripples, folder / name);
    }

    std::string in_home(const char* below) const { return "HOME=" + (folder / below).string(); }
};

const char* const rings = R"({"wrinkle": 1, "nodes": {"r": {"type": "ripples"}},
                             "outputs": {"height": {"from": "r.height"}}})";

TEST_F(PluginTest, TheUsersFolderIsFoundWithoutBeingNamed) {
    put("g.json", rings);
    const std::vector<std::string> home{"WRINKLE_NO_DEFAULT_PLUGINS=", in_home("home"),
                                        "XDG_DATA_HOME="};
    place("home/.local/share/wrinkle/plugins/ripples.so");
    const Ran listed = run({"plugins"}, "", home);
    EXPECT_EQ(listed.code, 0) << listed.err;
    EXPECT_TRUE(says(listed.out, "home/.local/share/wrinkle/plugins/ripples.so\n"));
    EXPECT_TRUE(says(listed.out, "    found: ripples\n"));
    EXPECT_EQ(run({"check", "g.json"}, "", home).code, 0);
    EXPECT_EQ(run({"check", "g.json"}).code, 1) << "switched off";
}

TEST_F(PluginTest, FindingsAreKeptInTheCache) {
    place("p/ripples.so");
    const std::vector<std::string> cache{"XDG_CACHE_HOME=" + (folder / "c").string()};
    const Ran first = run({"plugins", "--plugin-path", "p"}, "", cache);
    EXPECT_TRUE(fs::exists(folder / "c/wrinkle/plugins"));
    EXPECT_EQ(run({"plugins", "--plugin-path", "p"}, "", cache).out, first.out);
    EXPECT_EQ(run({"plugins", "--plugin-path", "p"}, "", {"XDG_CACHE_HOME=/proc"}).out, first.out);
}

// dlopen() searches for a name without a slash in the system's folders.
TEST_F(PluginTest, AManifestIsMadeOfAPluginInTheWorkingFolder) {
    place("ripples.so");
    const Ran written = run({"plugins", "--manifest", "ripples.so"});
    EXPECT_EQ(written.code, 0) << written.err;
    EXPECT_TRUE(exists("ripples.so.json"));
}

TEST_F(PluginTest, AManifestIsWrittenBesideThePlugin) {
    place("p/ripples.so");
    const Ran written = run({"plugins", "--manifest", "p/ripples.so"});
    EXPECT_EQ(written.code, 0) << written.err;
    EXPECT_EQ(written.out, "p/ripples.so.json\n");
    const std::string text = get("p/ripples.so.json");
    EXPECT_TRUE(parsed(text).has("sha256"));
    EXPECT_TRUE(says(text, "\"id\": \"ripples\""));
    EXPECT_TRUE(says(run({"plugins", "--plugin-path", "p"}).out, "found by its manifest: ripples"));
    put("g.json", rings);
    EXPECT_EQ(run({"compile", "g.json", "--plugin-path", "p"}).code, 0);
    put("p/none.so", "no plugin");
    const Ran refused = run({"plugins", "--manifest", "p/none.so"});
    EXPECT_EQ(refused.code, 1);
    EXPECT_TRUE(
        says(refused.err, "p/none.so: error: it cannot be loaded: it is not a shared object"));
    EXPECT_FALSE(exists("p/none.so.json"));
    put("q/ripples.so", get("p/ripples.so"));
    put("q/ripples.so.json/in_the_way", "");
    EXPECT_EQ(run({"plugins", "--manifest", "q/ripples.so"}).code, 3) << "it cannot be written";
}

// The rule holds for any file next to a graph and any key in it.
TEST_F(PluginTest, AGraphLoadsNoCode) {
    for (const char* name : {"ripples.so", "plugins/ripples.so", "wrinkle/plugins/ripples.so",
                             "lib/wrinkle/plugins/ripples.so"})
        place(name);
    put("g.json", R"({"wrinkle": 1, "plugins": ["ripples.so"], "plugin_path": "plugins",
                      "nodes": {"r": {"type": "ripples", "plugin": "./ripples.so"},
                                "s": {"type": "graph:ripples.so"},
                                "i": {"type": "image", "in": {"image": "ripples.so"}}},
                      "outputs": {"height": {"from": "r.height"}}})");
    for (const char* command : {"check", "compile"}) {
        const Ran ran = run({command, "g.json"});
        EXPECT_EQ(ran.code, 1);
        EXPECT_TRUE(says(ran.err, "unknown node type 'ripples'"));
    }
    EXPECT_EQ(run({"plugins"}).out, "");
}

TEST_F(PluginTest, OneThatBreaksIsNamedAndTheRestWorks) {
    put("g.json", rings);
    put("p/a.so", bytes_of(WRINKLE_BROKEN_PLUGIN));
    fs::rename(folder / "p/a.so", folder / "p/segv_while_loading.so");
    place("p/ripples.so");
    const Ran ran = run({"compile", "g.json", "--plugin-path", "p"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(says(ran.err,
                     "p/segv_while_loading.so: warning: it crashed while it was loaded: "
                     "SIGSEGV (Segmentation fault)\n"));
    EXPECT_TRUE(says(ran.out, "wrinkle_g("));
}

}  // namespace
}  // namespace wrinkle::test
