// Tests of plugins that end or hang their process in build(): the graph has a problem; the editor,
// its edits and their recovery are unaffected.
#include <chrono>

#include "editor/model/document/plugins.h"
#include "editor/model/document/recovery.h"
#include "headless.h"
#include "running_editor.h"
#include "virtual_screen.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* plugin = TEST_PLUGINS "/dying.so";

std::string graph(const std::string& way) {
    return R"({
  "wrinkle": 1,
  "nodes": {
    "mine": { "type": "dying", "in": { "way": ")" +
           way + R"(" } },
    "number": { "type": "add", "in": { "a": 1, "b": 2 } }
  },
  "outputs": { "value": { "from": "mine.value" } }
}
)";
}

class PluginDeath : public Headless {
protected:
    void SetUp() override {
        state.plugins.places = {plugin};
        load_plugins(state);
        EXPECT_EQ(to_text(state.plugins.problems), "");
    }
    void TearDown() override { state.registry = &built_in_registry(); }
};

TEST_F(PluginDeath, IsAProblemOfTheGraph) {
    for (const auto& [way, words] :
         {std::pair("crashes", "it crashed in build(): SIGSEGV (Segmentation fault)"),
          {"ends", "it ended the program in build(), with exit code 0"},
          {"hangs", "it hung in build(): it was ended after 5 s"}}) {
        open(graph(way));
        play("assert errors 1\nclick node:number\nkey Delete\nassert nodes 1\nassert errors 1");
        const std::string text = to_text(state.built.problems);
        EXPECT_NE(text.find("node 'mine': the plugin " + std::string(plugin)), text.npos) << text;
        EXPECT_NE(text.find(words), text.npos) << text;
    }
    open(graph("fine"));
    play("assert errors 0");
}

// The editor is killed twice; the second run recovers the edits in the `--state` folder.
TEST(PluginDeathInAnEditor, LeavesTheWindowTheEditsAndTheirRecovery) {
    const VirtualScreen screen;
    if (!screen.is_there()) GTEST_SKIP() << "there is no Xvfb here";
    const TemporaryFolder folder, home;
    const fs::path file = folder.write("graph.json", graph("crashes"));
    const auto run = [&](const std::string& script) {
        const fs::path played = home.write("script.txt", script);
        RunningEditor editor(screen, {file.string(), "--plugin-path", plugin, "--script",
                                      played.string(), "--state", home.path().string()});
        editor.listen(Clock::now() + std::chrono::seconds(60), "reached");
        return editor.kill();
    };
    EXPECT_NE(run("wait\nassert errors 1\nclick node:number\nkey Delete\nassert nodes 1\n"
                  "assert dirty\nwait\nsay reached\n")
                  .find("reached"),
              std::string::npos);
    EXPECT_EQ(text_of(file), graph("crashes"));
    ASSERT_EQ(list_recoverable(home.path() / "state").size(), 1U);
    EXPECT_NE(run("wait\nclick answer:recover\nassert nodes 1\nassert dirty\nassert errors 1\n"
                  "key Ctrl+S\nassert clean\nsay reached\n")
                  .find("reached"),
              std::string::npos);
    EXPECT_EQ(text_of(file).find("\"number\""), std::string::npos) << text_of(file);
    EXPECT_NE(text_of(file).find("\"crashes\""), std::string::npos) << text_of(file);
}

}  // namespace
}  // namespace wrinkle::editor
