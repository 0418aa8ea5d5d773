// Tests of files changed by other programs: they are read again automatically.
#include "editor/model/document/used_files.h"

#include <fstream>

#include "editor/model/document/files.h"
#include "editor/model/document/plugins.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;

const char* const one_map = R"({ "wrinkle": 1, "nodes": {
    "map": { "type": "tangent_normal_map", "in": { "image": "textures/weave_normal.png" } },
    "normal": { "type": "resolve", "in": { "gradient": { "from": "map.gradient" } } } },
  "outputs": { "normal": { "from": "normal.normal" } } })";

class Watching : public Headless {
protected:
    // Runs one check of the files; no further check runs until the next call.
    void look() {
        state.used.checked_at = 0;
        frame();
        state.used.checked_at = 1e18;
        frame();
    }
    // Replaces the file by a rename, as other programs do. The new inode reveals the change even if
    // the clock is too coarse for a new modification time.
    static void replace(const fs::path& file, const fs::path& by) {
        const fs::path beside = file.string() + ".new";
        fs::copy_file(by, beside);
        fs::rename(beside, file);
    }
    fs::path textures() const { return fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures"; }
};

TEST_F(Watching, AnImageThatChangesIsReadAgain) {
    const fs::path image = texture("weave_normal.png");
    open(one_map);
    look();
    EXPECT_EQ(state.used.changes, 0U);
    replace(image, textures() / "rivets_normal.png");
    look();
    EXPECT_EQ(state.used.changes, 1U);
    EXPECT_EQ(state.status, "weave_normal.png was changed and is read again.");
    look();
    EXPECT_EQ(state.used.changes, 1U) << "once";
}

TEST_F(Watching, AnImageThatGoesIsBelievedGoneAfterASecondLook) {
    const fs::path image = texture("weave_normal.png");
    open(one_map);
    play("assert errors 0");
    look();
    fs::rename(image, image.string() + ".away");
    look();
    play("assert errors 0");
    look();
    play("assert errors 1\nassert status weave_normal.png is no longer there.");
    fs::rename(image.string() + ".away", image);
    look();
    play("assert errors 0");
}

TEST_F(Watching, AnImageInTheMiddleOfBeingReplacedIsNoChange) {
    const fs::path image = texture("weave_normal.png");
    open(one_map);
    look();
    fs::rename(image, image.string() + ".away");
    look();
    fs::rename(image.string() + ".away", image);
    look();
    EXPECT_EQ(state.used.changes, 0U);
}

TEST_F(Watching, ASubGraphThatChangesIsReadAgain) {
    folder.write("inner.json", R"({ "wrinkle": 1, "inputs": { "x": { "type": "float" } },
        "nodes": { "a": { "type": "add", "in": { "a": { "from": "input.x" } } } },
        "outputs": { "y": { "from": "a.result" } } })");
    open(R"({ "wrinkle": 1, "nodes": { "g": { "type": "graph:inner.json" } } })");
    look();
    ASSERT_NE(state.type_of("g"), nullptr);
    EXPECT_NE(state.type_of("g")->find_output("y"), NodeType::none);
    folder.write("inner.json", R"({ "wrinkle": 1, "inputs": { "x": { "type": "float" } },
        "nodes": { "a": { "type": "add", "in": { "a": { "from": "input.x" } } } },
        "outputs": { "other": { "from": "a.result" } } })");
    look();
    EXPECT_EQ(state.type_of("g")->find_output("y"), NodeType::none);
    EXPECT_NE(state.type_of("g")->find_output("other"), NodeType::none);
}

TEST_F(Watching, TheThreadLooksToo) {
    const fs::path image = texture("weave_normal.png");
    FileLooker looker([](FileQuestion&& question) { return look_at_files(question); }, {});
    state.used.looker = &looker;
    open(one_map);
    looker.wait_idle();
    look();
    looker.wait_idle();
    look();
    replace(image, textures() / "rivets_normal.png");
    for (int i = 0; i < 3; ++i) {
        look();
        looker.wait_idle();
    }
    frame();
    EXPECT_EQ(state.used.changes, 1U);
    state.used.looker = nullptr;
}

TEST_F(Watching, APluginIsLoadedAnewAndItsLostNodesAreKept) {
    const fs::path plugins = folder.path() / "plugins", built = TEST_PLUGINS;
    fs::create_directory(plugins);
    fs::copy_file(built / "good.so", plugins / "mine.so");
    state.plugins.places = {plugins.string()};
    Diagnostics problems;
    load_plugins(state);
    EXPECT_EQ(to_text(problems), "");
    const char* const graph = R"({ "wrinkle": 1, "nodes": { "s": { "type": "small" } } })";
    open(graph);
    look();
    ASSERT_NE(state.type_of("s"), nullptr);
    replace(plugins / "mine.so", built / "second.so");
    look();
    EXPECT_NE(state.type_of("s"), nullptr) << "it may still be being written";
    look();
    EXPECT_EQ(state.type_of("s"), nullptr) << state.status;
    EXPECT_NE(state.registry->find("smaller"), nullptr);
    play("assert node s\nassert errors 1\nclick node:s\nkey Ctrl+S\nassert clean");
    EXPECT_EQ(text_of(file), graph);
    replace(plugins / "mine.so", built / "good.so");
    look();
    look();
    EXPECT_NE(state.type_of("s"), nullptr) << state.status;
    play("assert errors 0");
    fs::remove(plugins / "mine.so");
    look();
    look();
    look();
    EXPECT_EQ(state.type_of("s"), nullptr) << state.status;
    state.registry = &built_in_registry();
    state.is_synced = false;
}

// A failed rebuild, as left by an interrupted linker or a wrong interface.
TEST_F(Watching, ABrokenRebuildOfAPluginKeepsTheLastGoodOne) {
    const fs::path plugins = folder.path() / "plugins", built = TEST_PLUGINS;
    fs::create_directory(plugins);
    fs::copy_file(built / "good.so", plugins / "mine.so");
    state.plugins.places = {plugins.string()};
    load_plugins(state);
    open(R"({ "wrinkle": 1, "nodes": { "s": { "type": "small" } },
              "outputs": { "a": { "from": "s.value" } } })");
    look();
    for (const char* broken : {"wrong_abi.so", "missing_symbol.so", "null_result.so"}) {
        replace(plugins / "mine.so", built / broken);
        look();
        look();
        EXPECT_NE(state.status.find("mine.so was refused: "), std::string::npos) << state.status;
        ASSERT_NE(state.type_of("s"), nullptr) << broken;
        play("assert node s\nassert errors 0");
    }
    replace(plugins / "mine.so", built / "second.so");
    look();
    look();
    EXPECT_EQ(state.type_of("s"), nullptr) << "a good one without that node";
    EXPECT_NE(state.registry->find("smaller"), nullptr);
    state.registry = &built_in_registry();
    state.is_synced = false;
}

TEST_F(Watching, APluginThatIsRefusedIsAProblemWithItsWholeReason) {
    const fs::path plugins = folder.path() / "plugins", built = TEST_PLUGINS;
    fs::create_directory(plugins);
    fs::copy_file(built / "wrong_abi.so", plugins / "mine.so");
    state.plugins.places = {plugins.string()};
    load_plugins(state);
    new_file(state);
    state.start.left = true;
    frame();
    frame();
    play("assert target problem:1\nassert no-target problem:2\nkey F8");
    ASSERT_EQ(state.plugins.reports.size(), 1U);
    const std::string why = state.plugins.reports[0].why;
    EXPECT_NE(why.find("interface 77"), std::string::npos) << why;
    const Diagnostic& problem = state.plugins.problems.list().at(0);
    EXPECT_EQ(why.find(problem.message), 0U) << problem.message;
    EXPECT_EQ(fs::path(problem.where.file).filename(), "mine.so");
    replace(plugins / "mine.so", built / "good.so");
    reload_plugins(state);
    frame();
    frame();
    play("assert no-target problem:1");
    state.registry = &built_in_registry();
}

TEST_F(Watching, APluginThatIsCutShortIsRefusedAndTheEditorGoesOn) {
    const fs::path plugins = folder.path() / "plugins", built = TEST_PLUGINS;
    fs::create_directory(plugins);
    const std::string whole = text_of(built / "good.so");
    state.plugins.places = {plugins.string()};
    for (size_t part = 0; part < 8; ++part) {
        std::ofstream(plugins / "mine.so", std::ios::binary)
            << whole.substr(0, whole.size() * part / 8);
        load_plugins(state);
        EXPECT_FALSE(state.plugins.problems.list().empty());
        EXPECT_EQ(state.registry->find("small"), nullptr);
    }
    reload_plugins(state);
    EXPECT_NE(state.status.find("mine.so was refused"), std::string::npos) << state.status;
    state.registry = &built_in_registry();
}

}  // namespace
}  // namespace wrinkle::editor
