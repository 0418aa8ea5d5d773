// Tests of recovery files: unsaved edits survive a crash, damaged files, recovery.
#include "editor/model/document/recovery_file.h"

#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <random>

#include "editor/model/document/files.h"
#include "editor/model/document/recovery.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

// Left by a process that died: the document texts in order, and the recovery file.
struct Left {
    std::vector<std::string> texts;
    fs::path file;
};

Left leave_file(const TemporaryFolder& home, int edits) {
    Left left;
    {
        RecoveryFile recovery;
        for (int i = 0; i < edits; ++i) {
            const Document document = set_output({}, "o" + std::to_string(i), {"a", "y"});
            left.texts.push_back(write_document(document));
            EXPECT_FALSE(recovery.write(home.path(), "/nowhere/graph.json", "", document));
        }
        EXPECT_TRUE(list_recoverable(home.path()).empty()) << "it is in use";
    }
    const auto found = list_recoverable(home.path());
    EXPECT_EQ(found.size(), 1U);
    if (!found.empty()) left.file = found[0].file;
    return left;
}

TEST(RecoveryFile, GivesBackTheLastText) {
    const TemporaryFolder home;
    const Left left = leave_file(home, 20);
    const auto found = read_recovery_file(left.file);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->text, left.texts.back());
    EXPECT_EQ(found->graph, "/nowhere/graph.json");
    EXPECT_EQ(found->edits, 20U);
}

TEST(RecoveryFile, APartOfItIsNotRead) {
    const TemporaryFolder home;
    const Left left = leave_file(home, 6);
    const std::string whole = text_of(left.file);
    for (size_t cut = 0; cut < whole.size(); ++cut) {
        std::ofstream(left.file, std::ios::binary) << whole.substr(0, cut);
        ASSERT_FALSE(read_recovery_file(left.file)) << "at byte " << cut;
    }
}

TEST(RecoveryFile, DamagedBytesAreNotRead) {
    const TemporaryFolder home;
    const Left left = leave_file(home, 6);
    const std::string whole = text_of(left.file);
    std::mt19937 random(2);
    for (int i = 0; i < 3000; ++i) {
        std::string damaged = whole;
        for (size_t n = 1 + random() % 3; n > 0; --n)
            damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
        std::ofstream(left.file, std::ios::binary) << damaged;
        ASSERT_EQ(read_recovery_file(left.file).has_value(), damaged == whole);
    }
}

// A program that is killed while it writes leaves a temporary file next to its last edit.
TEST(RecoveryFile, AnUnfinishedOneIsRemovedAndTheLastEditStays) {
    const TemporaryFolder home;
    const Left left = leave_file(home, 3);
    const fs::path unfinished = left.file.string() + ".new";
    std::ofstream(unfinished) << text_of(left.file).substr(0, 30);
    const auto found = list_recoverable(home.path());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].text, left.texts.back());
    EXPECT_FALSE(fs::exists(unfinished));
}

TEST(RecoveryFile, WhatIsSavedIsNotRecoverable) {
    const TemporaryFolder home;
    const Document other = set_output({}, "other", {"a", "y"});
    const Document saved = set_output({}, "saved", {"a", "y"});
    const fs::path graph = home.write("graph.json", write_document(saved));
    {
        RecoveryFile recovery;
        recovery.write(home.path(), graph, "", other);
        recovery.write(home.path(), graph, "", saved);
    }
    EXPECT_TRUE(list_recoverable(home.path()).empty());
    EXPECT_TRUE(fs::is_empty(home.path() / "journal"));
}

size_t journals(const TemporaryFolder& home) {
    const fs::path folder = home.path() / "state" / "journal";
    std::error_code error;
    return fs::exists(folder)
               ? static_cast<size_t>(std::distance(fs::directory_iterator(folder, error), {}))
               : 0;
}

// Copies the recovery files to "left", as a process that dies now leaves them: files without a
// lock. Returns that folder.
fs::path die(const TemporaryFolder& home) {
    const fs::path folder = home.path() / "state" / "journal", left = home.path() / "left";
    fs::remove_all(left);
    if (fs::exists(folder)) fs::copy(folder, left);
    return left;
}

void leave_subgraphs(const TemporaryFolder& home, const fs::path& left) {
    for (const auto& entry : fs::directory_iterator(left))
        fs::copy(entry,
                 home.path() / "state" / "journal" / ("left-" + entry.path().filename().string()));
}

TEST_F(Headless, EveryCommittedEditIsInTheRecoveryFileAfterItsFrame) {
    open(small_graph);
    EXPECT_EQ(journals(home), 0U) << "nothing is unsaved";
    const auto kept = [&] {
        for (const auto& entry : fs::directory_iterator(home.path() / "state" / "journal"))
            if (const auto found = read_recovery_file(entry.path())) return found->text;
        return std::string();
    };
    for (int i = 0; i < 10; ++i) {
        state.commit("Move", move_node(state.document(), "noise", i + 1, 5));
        frame();
        EXPECT_EQ(kept(), write_document(state.document()));
    }
    play("key Ctrl+Z");
    EXPECT_EQ(kept(), write_document(state.document())) << "undo is an edit too";
    play("key Ctrl+S");
    EXPECT_EQ(journals(home), 0U);
    play("click node:number\nkey Delete");
    EXPECT_EQ(journals(home), 1U);
    play("key Ctrl+Z");
    EXPECT_EQ(journals(home), 0U);
    play("click node:number\nkey Delete\nkey Ctrl+N\nclick answer:discard");
    EXPECT_EQ(journals(home), 0U);
}

TEST_F(Headless, ADragIsKeptAtItsEnd) {
    open(small_graph);
    play("click canvas+0,250");
    const auto at = *state.targets.find("field:softer.amount");
    queue.motion(at.middle_x(), at.middle_y());
    queue.button(0, true);
    for (int i = 1; i < 20; ++i) {
        queue.motion(at.middle_x() + static_cast<float>(i), at.middle_y());
        frame();
    }
    while (!queue.empty())
        frame();
    EXPECT_TRUE(state.dirty());
    EXPECT_EQ(journals(home), 0U);
    queue.button(0, false);
    frame();
    frame();
    EXPECT_EQ(journals(home), 1U);
}

TEST_F(Headless, WhatADeadProgramLeftIsOfferedAndComesBack) {
    open(small_graph);
    play("click node:number\nkey Delete");
    const std::string edited = write_document(state.document());
    const fs::path left = die(home);
    open(small_graph);  // discards the edits
    leave_subgraphs(home, left);
    carry_out(state, {PendingAction::Kind::open, file});
    play("wait\nassert nodes 4\nclick answer:later\nassert nodes 4");
    EXPECT_EQ(journals(home), 1U);
    play("click menu:File\nclick menu:recover\nclick answer:recover\nassert nodes 3\nassert dirty");
    EXPECT_EQ(write_document(state.document()), edited);
    EXPECT_EQ(journals(home), 1U) << "the new one, and no longer the old one";
    EXPECT_TRUE(state.keeping.recoverable.empty());
    play("key Ctrl+Z\nassert nodes 4\nassert clean\nkey Ctrl+Shift+Z\nkey Ctrl+S\nassert clean");
    EXPECT_EQ(text_of(file), edited);
    EXPECT_EQ(journals(home), 0U);
}

TEST_F(Headless, AGraphWithoutAFileIsRecoveredToo) {
    new_file(state);
    frame();
    play("key Space\ntype smoothstep\nkey Enter\nassert nodes 1");
    const fs::path left = die(home);
    new_file(state);
    leave_subgraphs(home, left);
    look_for_recoverable(state);
    offer_recovery(state);
    play("wait\nclick answer:recover\nassert node smoothstep\nassert dirty");
    EXPECT_TRUE(state.path.empty());
}

TEST_F(Headless, AGraphWithoutAFileIsRecoveredInItsFolder) {
    texture("rivets_normal.png");
    new_file(state, folder.path());
    play("drop textures/rivets_normal.png canvas\nassert nodes 2\nassert errors 0");
    const fs::path left = die(home);
    new_file(state);
    ASSERT_NE(state.folder(), fs::canonical(folder.path()));
    leave_subgraphs(home, left);
    look_for_recoverable(state);
    offer_recovery(state);
    play("wait\nclick answer:recover\nassert nodes 2\nassert errors 0");
    EXPECT_EQ(state.folder(), fs::canonical(folder.path()));
}

TEST_F(Headless, ARecoveredPartOfADamagedFileDoesNotReplaceIt) {
    const std::string broken = std::string(small_graph).substr(0, 300);
    open(broken);
    play("click node:noise\nkey Delete");
    const fs::path left = die(home);
    open(small_graph);
    leave_subgraphs(home, left);
    folder.write("graph.json", broken);
    look_for_recoverable(state);
    ASSERT_EQ(state.keeping.recoverable.size(), 1U);
    recover(state, state.keeping.recoverable[0]);
    frame();
    play("assert no-node noise\nkey Ctrl+S\nassert status Not saved");
    EXPECT_EQ(text_of(file), broken);
}

TEST_F(Headless, ADeadProgramsEditsCanBeGivenUp) {
    open(small_graph);
    play("click node:number\nkey Delete");
    const fs::path left = die(home);
    open(small_graph);
    leave_subgraphs(home, left);
    carry_out(state, {PendingAction::Kind::open, file});
    play("wait\nclick answer:forget\nassert nodes 4");
    EXPECT_EQ(journals(home), 0U);
}

TEST_F(Headless, ARecoveryFileThatCannotBeWrittenIsSaidAndTriedAgain) {
    open(small_graph);
    play("click node:number\nkey Delete");
    rlimit old = {};
    getrlimit(RLIMIT_FSIZE, &old);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small = {100, old.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    for (int i = 0; i < 20; ++i) {
        state.commit("Move", move_node(state.document(), "noise", i, 7.25));
        state.keeping.checked_at = 0;
        frame();
    }
    const std::string status = state.status, unkept = state.keeping.unkept;
    const bool saved = save_file(state);
    setrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, handler);
    EXPECT_FALSE(unkept.empty());
    EXPECT_FALSE(saved);
    state.commit("Move", move_node(state.document(), "noise", 3, 99));
    state.keeping.checked_at = 0;
    frame();
    frame();
    EXPECT_TRUE(state.keeping.unkept.empty());
    leave_subgraphs(home, die(home));
    const auto found = list_recoverable(home.path() / "state");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].text, write_document(state.document())) << "nothing torn is in between";
}

}  // namespace
}  // namespace wrinkle::editor
