// Tests of read-only folders and files. Root can write anywhere, so attempts run in a child process
// without root's capabilities.
#include <sys/wait.h>

#include <unistd.h>

#include <functional>

#include "editor/model/document/files.h"
#include "editor/model/document/recovery.h"
#include "editor/view/lifecycle.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "headless.h"
#include "support/privileges.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

// Returns the result of `run`, called in such a process.
std::string unprivileged(const std::function<std::string()>& run) {
    int ends[2];
    if (pipe(ends) != 0) return "no pipe";
    const pid_t child = fork();
    if (child == 0) {
        const std::string said = test::drop_capabilities() ? run() : "the capabilities stay";
        const bool whole =
            write(ends[1], said.data(), said.size()) == static_cast<ssize_t>(said.size());
        _exit(whole ? 0 : 1);
    }
    close(ends[1]);
    std::string said;
    char bytes[4096];
    for (ssize_t n; (n = read(ends[0], bytes, sizeof bytes)) > 0;)
        said.append(bytes, static_cast<size_t>(n));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << said;
    return said;
}

constexpr auto readable = fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read;
constexpr auto enterable =
    readable | fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec;
constexpr auto open_to_all = fs::perms::all;

class ReadOnly : public Headless {
protected:
    ReadOnly() { fs::permissions(home.path(), open_to_all); }
    ~ReadOnly() override {
        fs::permissions(folder.path(), open_to_all);
        fs::permissions(home.path(), open_to_all);
    }
    void edit() { state.commit("Move", move_node(state.document(), "noise", 5, 7)); }
    std::string said() const {
        return state.status + (state.dirty() ? " [dirty]" : " [clean]") +
               (state.question.kind == Question::Kind::failed ? " [asks]" : "");
    }
};

TEST_F(ReadOnly, AFolderIsSaidAndTheEditsAreKept) {
    open(small_graph);
    edit();
    fs::permissions(file, open_to_all);
    fs::permissions(folder.path(), enterable);
    EXPECT_EQ(unprivileged([&] {
                  save_file(state);
                  return said();
              }),
              "graph.json was not saved: its folder may not be written to. Your edits are kept in "
              "the recovery file. [dirty] [asks]");
    EXPECT_EQ(text_of(file), small_graph);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "nothing is left";
    const auto found = list_recoverable(home.path() / "state");
    ASSERT_EQ(found.size(), 1U) << "of the child, which is gone";
    EXPECT_EQ(found[0].text, write_document(state.document()));
}

TEST_F(ReadOnly, AFileIsNotReplacedThoughItsFolderWouldAllowIt) {
    open(small_graph);
    edit();
    fs::permissions(folder.path(), open_to_all);
    fs::permissions(file, readable);
    EXPECT_EQ(unprivileged([&] {
                  save_file(state);
                  return said();
              }),
              "graph.json was not saved: it is read-only. Your edits are kept in the recovery "
              "file. [dirty] [asks]");
    EXPECT_EQ(text_of(file), small_graph);
    EXPECT_EQ(unprivileged([&] {
                  const fs::path link = folder.path() / "link.json";
                  fs::create_symlink(file, link);
                  save_file_as(state, link);
                  return state.status.substr(0, 41);
              }),
              "link.json was not saved: it is read-only.");
}

// The dialog leads to a save under another name; then the original command continues.
TEST_F(ReadOnly, AnotherNameIsOffered) {
    open(small_graph);
    edit();
    fs::permissions(folder.path(), open_to_all);
    fs::permissions(file, readable);
    fs::remove_all(home.path() / "config");  // owned by root if settings were saved before
    EXPECT_EQ(unprivileged([&] {
                  play(
                      "key Ctrl+Q\nclick answer:save\nassert target answer:save-as\n"
                      "click answer:save\nassert target answer:save-as\n"
                      "click answer:save-as\nassert target browser:name\nkey Ctrl+A\n"
                      "type mine.json\nkey Enter\nassert clean");
                  return state.status + (state.quit ? " and quits" : "") +
                         (HasFailure() ? " with failures" : "");
              }),
              "Saved mine.json and quits");
    EXPECT_EQ(text_of(folder.path() / "mine.json"), write_document(state.document()));
}

TEST_F(ReadOnly, AStateFolderIsSaidOnceAndWorkGoesOn) {
    open(small_graph);
    fs::permissions(folder.path(), open_to_all);
    fs::permissions(file, open_to_all);
    fs::permissions(home.path(), enterable);
    fs::remove_all(home.path() / "state");
    fs::remove_all(home.path() / "config");
    const std::string text = unprivileged([&] {
        std::string all;
        for (int i = 0; i < 5; ++i) {
            state.status.clear();
            state.commit("Move", move_node(state.document(), "noise", i, 7));
            state.panes.side = 0.2F + 0.05F * static_cast<float>(i);
            state.keeping.checked_at = 0;
            keep_edits(state, false);
            all += state.status + "\n";
            autosave_and_check_files(state);
            all += state.status + "\n";
        }
        save_file(state);
        all += said() + "\n";
        open_file(state, file);
        open_file(state, folder.path() / "other.json");
        open_file(state, file);
        return all + std::to_string(state.keeping.settings.recent.size());
    });
    const std::string kept = "Edits are not kept for recovery: its folder may not be written to";
    const std::string settings = "The settings were not saved: its folder may not be written to";
    const auto times = [&](const std::string& words) {
        size_t count = 0;
        for (size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1))
            ++count;
        return count;
    };
    EXPECT_NE(text.find(kept), std::string::npos) << text;
    EXPECT_NE(text.find(settings), std::string::npos) << text;
    EXPECT_LE(times(kept), 2U) << "both lines of the first round show it\n" << text;
    EXPECT_EQ(times(settings), 1U) << text;
    EXPECT_NE(text.find("Saved graph.json [clean]"), std::string::npos) << text;
}

TEST_F(ReadOnly, RecentFilesAreRememberedWithoutADisk) {
    open(small_graph);
    folder.write("other.json", small_graph);
    fs::permissions(folder.path(), open_to_all);
    fs::permissions(home.path(), enterable);
    EXPECT_EQ(unprivileged([&] {
                  state.keeping.folders = folders_below(home.path() / "none");
                  open_file(state, folder.path() / "other.json");
                  open_file(state, file);
                  return std::to_string(state.keeping.settings.recent.size());
              }),
              "2");
}

}  // namespace
}  // namespace wrinkle::editor
