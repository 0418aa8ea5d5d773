// Tests of saving: failures, files changed by other programs, unsaved changes, settings.
#include <sys/resource.h>

#include <unistd.h>

#include <csignal>
#include <fstream>

#include "editor/model/document/files.h"
#include "editor/view/commands/commands.h"
#include "editor/view/lifecycle.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

constexpr const char* rename_a_node = "click node:number\nkey Delete\nassert dirty\n";

std::string with_name(const std::string& name) {
    std::string text = small_graph;
    return text.replace(text.find("Small"), 5, name);
}

// Runs the check that the program runs once a second.
void look(State& state) {
    state.keeping.checked_at = 0;
    autosave_and_check_files(state);
}

TEST_F(Headless, NewAndOpenAskAboutUnsavedWork) {
    open(small_graph);
    const fs::path other = folder.write("other.json", with_name("Other"));
    play(std::string(rename_a_node) +
         "key Ctrl+N\nclick answer:cancel\nassert nodes 3\n"
         "key Ctrl+N\nclick answer:save\nassert nodes 0\nassert clean");
    EXPECT_EQ(text_of(file).find("\"number\""), std::string::npos);
    EXPECT_TRUE(state.path.empty());
    EXPECT_EQ(state.title(), "untitled.json - Wrinkle");
    play("key Ctrl+O\nclick answer:path\ntype " + other.string() + "\nkey Enter\nassert nodes 4");
    EXPECT_EQ(state.document().name, "Other");
    play(std::string(rename_a_node) + "key Ctrl+O\nclick answer:path\nkey Ctrl+A\ntype " +
         file.string() + "\nclick answer:open\nclick answer:discard\nassert nodes 3\nassert clean");
    EXPECT_EQ(text_of(other), with_name("Other"));
}

TEST_F(Headless, OpeningWhatIsNotThereSaysSoAndStays) {
    open(small_graph);
    play("key Ctrl+O\nkey Ctrl+A\ntype nowhere.json\nkey Enter\nassert target answer:path");
    EXPECT_NE(state.browser.error_text.find("nowhere.json"), std::string::npos);
    play("key Escape\nassert nodes 4");
    EXPECT_FALSE(state.question.open());
}

TEST_F(Headless, ANewGraphIsSavedUnderATypedName) {
    new_file(state);
    frame();
    play(
        "key Space\ntype smoothstep\nkey Enter\nkey Ctrl+Q\nkey Enter\nassert target answer:path\n"
        "type " +
        (folder.path() / "fresh").string() + "\nkey Enter");
    EXPECT_TRUE(state.quit) << "quitting goes on once it is saved";
    EXPECT_NE(text_of(folder.path() / "fresh.json").find("smoothstep"), std::string::npos);
}

TEST_F(Headless, SaveAsAsksBeforeItReplacesAFile) {
    open(small_graph);
    folder.write("other.json", "precious");
    play(
        "key Ctrl+Shift+S\nkey Ctrl+A\ntype other.json\nkey Enter\nassert target answer:replace\n"
        "click answer:cancel");
    EXPECT_EQ(text_of(folder.path() / "other.json"), "precious");
    EXPECT_EQ(state.path, file);
    play("key Ctrl+Shift+S\nkey Ctrl+A\ntype other.json\nkey Enter\nkey Enter\nassert clean");
    EXPECT_EQ(text_of(folder.path() / "other.json"), small_graph);
    EXPECT_EQ(state.path.filename(), "other.json");
    EXPECT_EQ(text_of(file), small_graph);
}

TEST_F(Headless, ADamagedFileIsSavedUnderAnotherNameOnly) {
    const std::string broken = std::string(small_graph).substr(0, 300);
    open(broken);
    play("key Ctrl+Shift+S\nkey Ctrl+A\ntype graph.json\nkey Enter\nassert target answer:path");
    EXPECT_NE(state.browser.error_text.find("Choose another name"), std::string::npos);
    play("wait\nkey Ctrl+A\ntype part.json\nkey Enter\nassert status Saved");
    EXPECT_EQ(text_of(file), broken);
    play("click node:noise\nkey Delete\nkey Ctrl+S\nassert status Saved");
}

TEST_F(Headless, AChangedFileIsReadAgainWhenNothingIsUnsaved) {
    open(small_graph);
    folder.write("graph.json", with_name("Theirs"));
    look(state);
    EXPECT_EQ(state.document().name, "Theirs");
    EXPECT_FALSE(state.dirty());
    play("key Ctrl+Z\nassert dirty");
    EXPECT_EQ(write_document(state.document()), small_graph);
}

TEST_F(Headless, ATouchedFileIsNoChange) {
    open(small_graph);
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::hours(1));
    look(state);
    EXPECT_FALSE(state.history.can_undo());
    EXPECT_FALSE(state.question.open());
}

TEST_F(Headless, OfTwoChangedVersionsTheUserChooses) {
    open(small_graph);
    play(rename_a_node);
    folder.write("graph.json", with_name("Theirs"));
    look(state);
    play("wait\nclick answer:mine\nassert dirty\nassert nodes 3");
    look(state);
    EXPECT_FALSE(state.question.open()) << "it is asked once";
    play("key Ctrl+S\nassert clean");
    EXPECT_EQ(text_of(file).find("Theirs"), std::string::npos);
    play("click node:noise\nkey Delete");
    folder.write("graph.json", with_name("Again"));
    look(state);
    play("wait\nclick answer:theirs\nassert clean\nassert nodes 4\nkey Ctrl+Z\nassert nodes 2");
}

TEST_F(Headless, ADecisionForLaterIsAskedForAtTheNextChangeAndWhenSaving) {
    open(small_graph);
    play(rename_a_node);
    folder.write("graph.json", with_name("Theirs"));
    look(state);
    play("wait\nkey Escape\nassert no-target answer:later\nassert nodes 3");
    look(state);
    EXPECT_FALSE(state.question.open());
    folder.write("graph.json", with_name("Once more"));
    look(state);
    play("wait\nclick answer:later");
    look(state);
    EXPECT_FALSE(state.question.open());
    play("key Ctrl+S\nassert target answer:mine\nkey Escape");
    EXPECT_EQ(text_of(file), with_name("Once more"));
    play("key Ctrl+S\nclick answer:mine\nassert clean");
    EXPECT_EQ(text_of(file).find("Once more"), std::string::npos);
}

TEST_F(Headless, SavingOverWhatAnotherProgramWroteAsksFirst) {
    open(small_graph);
    play(rename_a_node);
    folder.write("graph.json", with_name("Theirs"));
    state.keeping.checked_at = 1e18;  // no further check of the file
    play("key Ctrl+Q\nclick answer:save\nassert target answer:theirs");
    EXPECT_EQ(text_of(file), with_name("Theirs"));
    play("click answer:mine");
    EXPECT_TRUE(state.quit);
    EXPECT_EQ(text_of(file).find("Theirs"), std::string::npos);
}

TEST_F(Headless, ADeletedFileIsWrittenAgain) {
    open(small_graph);
    fs::remove(file);
    look(state);
    play("assert dirty\nassert status no longer there\nkey Ctrl+S\nassert clean");
    EXPECT_EQ(text_of(file), small_graph);
}

TEST_F(Headless, AVanishedFolderIsSaidAndTheEditsStay) {
    open(small_graph);
    play(rename_a_node);
    const fs::path gone = folder.path().string() + "-gone";
    fs::rename(folder.path(), gone);
    play(
        "key Ctrl+S\nassert status graph.json was not saved: its folder is no longer there.\n"
        "assert dirty\nassert nodes 3\nkey Escape\nkey Ctrl+Q\nclick answer:save\n"
        "assert target answer:save-as");
    EXPECT_FALSE(state.quit);
    EXPECT_NE(state.question.error_text.find("was not saved"), std::string::npos);
    fs::rename(gone, folder.path());
    play("click answer:save\nassert clean");
    EXPECT_TRUE(state.quit);
}

TEST_F(Headless, ADeviceThatIsFullIsSaid) {
    open(small_graph);
    state.path = "/dev/full";
    state.disk = {};
    EXPECT_FALSE(save_file_as(state, "/dev/full"));
    EXPECT_NE(state.status.find("full was not saved: the disk is full."), std::string::npos)
        << state.status;
}

// A limit on the file size stops the write midway, as a full disk does.
TEST_F(Headless, AHalfWrittenFileNeverTakesThePlaceOfTheOldOne) {
    open(small_graph);
    play(rename_a_node);
    rlimit old = {};
    getrlimit(RLIMIT_FSIZE, &old);
    const rlimit small = {100, old.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const bool saved = save_file(state);
    setrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, handler);
    EXPECT_FALSE(saved);
    EXPECT_NE(state.status.find("graph.json was not saved"), std::string::npos) << state.status;
    EXPECT_EQ(text_of(file), small_graph);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1)
        << "nothing is left over";
    EXPECT_TRUE(state.dirty());
    EXPECT_TRUE(save_file(state));
}

TEST_F(Headless, AReadOnlyFolderIsSaid) {
    open(small_graph);
    play(rename_a_node);
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    const bool powerless = access(folder.path().c_str(), W_OK) != 0;  // root can write anywhere
    const bool saved = save_file(state);
    fs::permissions(folder.path(), fs::perms::owner_all);
    EXPECT_NE(saved, powerless);
    EXPECT_EQ(state.status.find("may not be written to") != std::string::npos, powerless);
    EXPECT_EQ(disk_words(std::make_error_code(std::errc::permission_denied)),
              "its folder may not be written to");
}

TEST_F(Headless, RecentFilesAreInTheMenuTheLatestFirst) {
    open(small_graph);
    for (int i = 0; i < 12; ++i)
        open_file(state, folder.write("g" + std::to_string(i) + ".json", with_name("G")));
    open_file(state, file);
    ASSERT_EQ(state.keeping.settings.recent.size(), 10U);
    EXPECT_EQ(state.keeping.settings.recent[0].filename(), "graph.json");
    EXPECT_EQ(state.keeping.settings.recent[1].filename(), "g11.json");
    play("click menu:File\nclick recent:2");
    EXPECT_EQ(state.path.filename(), "g11.json");
}

TEST(Settings, ComeBackAndKeepTheRestWhenOneIsUnusable) {
    const TemporaryFolder home;
    const Folders folders = folders_below(home.path() / "deep");
    Settings settings;
    settings.side = 0.4F;
    settings.width = 1000;
    settings.theme = "light";
    settings.recent = {"/a/b.json", "/ü.json", "/bad\xFF.json"};
    EXPECT_EQ(write_settings(folders, settings), "");
    settings.recent.pop_back();
    std::string trouble;
    EXPECT_EQ(read_settings(folders, trouble), settings);
    EXPECT_EQ(trouble, "");
    const fs::path file = folders.config / "settings.json";
    std::string text = text_of(file);
    text.replace(text.find("1000"), 4, "1e99");
    std::ofstream(file) << text;
    settings.width = Settings().width;
    EXPECT_EQ(read_settings(folders, trouble), settings);
    EXPECT_NE(trouble.find("width"), std::string::npos) << trouble;
}

TEST(Settings, ADamagedFileIsKeptAsideAndReplaced) {
    const TemporaryFolder home;
    const Folders folders = folders_below(home.path());
    write_settings(folders, {});
    const fs::path file = folders.config / "settings.json";
    std::string whole = text_of(file);
    for (size_t cut = 0; cut + 2 < whole.size(); cut += 7) {
        std::ofstream(file) << whole.substr(0, cut);
        std::string trouble;
        EXPECT_EQ(read_settings(folders, trouble), Settings());
        EXPECT_NE(trouble.find(".bak"), std::string::npos);
        EXPECT_EQ(text_of(file.string() + ".bak"), whole.substr(0, cut));
        EXPECT_FALSE(fs::exists(file));
    }
    std::string trouble;
    EXPECT_EQ(read_settings(Folders(), trouble), Settings());
    EXPECT_EQ(trouble, "");
}

TEST_F(Headless, SettingsFollowTheSplitters) {
    open(small_graph);
    state.panes.side = 0.42F;
    look(state);
    std::string trouble;
    EXPECT_EQ(read_settings(state.keeping.folders, trouble).side, 0.42F);
}

}  // namespace
}  // namespace wrinkle::editor
