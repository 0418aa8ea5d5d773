// Tests of the recovery journal: unsaved edits survive a crash, damaged journals, recovery.
#include "editor/model/document/journal.h"

#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <random>

#include "editor/model/document/files.h"
#include "editor/model/document/recovery.h"
#include "editor/model/document/text_delta.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

std::string random_line(std::mt19937& random) {
    return random() % 3 ? "line " + std::to_string(random() % 40) + "\n" : "}\n";
}

TEST(TextDelta, BringsAnyTextBack) {
    std::mt19937 random(5);
    std::string text;
    for (int i = 0; i < 2000; ++i) {
        std::string next = text;
        for (size_t n = random() % 4; n > 0; --n) {
            const size_t at = next.empty() ? 0 : random() % next.size();
            switch (random() % 3) {
                case 0:
                    next.insert(at, random_line(random) + random_line(random));
                    break;
                case 1:
                    next.erase(at, random() % 60);
                    break;
                default:
                    next.replace(at, 1, std::string(1, static_cast<char>(random() % 256)));
            }
        }
        ASSERT_EQ(apply_text_delta(text, text_delta(text, next)), next);
        text = next.size() > 4000 ? next.substr(0, 300) : next;
    }
}

TEST(TextDelta, IsSmallWhereLittleChanged) {
    std::string before, after;
    for (int i = 0; i < 500; ++i) {
        before += "a line with the number " + std::to_string(i) + "\n";
        if (i != 7)
            after += i == 2500 ? "changed\n" : "a line with the number " + std::to_string(i) + "\n";
    }
    EXPECT_LT(text_delta(before, after).size(), 100U);
    EXPECT_EQ(apply_text_delta(before, text_delta(before, after)), after);
}

TEST(TextDelta, NonsenseIsNone) {
    for (const char* delta : {"=1", "=0,99\n", "=99,1\n", "+5\nabc", "*", "=,\n", "+-1\n",
                              "=1,2,3\n", "+99999999999999999999999\n"})
        EXPECT_FALSE(apply_text_delta("text", delta)) << delta;
    EXPECT_EQ(apply_text_delta("text", "=1,2\n+2\nab=0,1\n"), "exabt");
}

// Journal of a process that died: the document texts in order, and the journal file.
struct Left {
    std::vector<std::string> texts;
    fs::path file;
};

Left leave_journal(const TemporaryFolder& home, int edits) {
    Left left;
    {
        Journal journal;
        for (int i = 0; i < edits; ++i) {
            const Document document = set_name({}, std::to_string(i));
            left.texts.push_back(write_document(document));
            EXPECT_FALSE(journal.keep(home.path(), "/nowhere/graph.json", "", document));
        }
        EXPECT_TRUE(list_recoverable(home.path()).empty()) << "it is in use";
    }
    const auto found = list_recoverable(home.path());
    EXPECT_EQ(found.size(), 1U);
    if (!found.empty()) left.file = found[0].journal;
    return left;
}

TEST(Journal, GivesBackTheLastText) {
    const TemporaryFolder home;
    const Left left = leave_journal(home, 20);
    const auto found = read_journal(left.file);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->text, left.texts.back());
    EXPECT_EQ(found->graph, "/nowhere/graph.json");
    EXPECT_EQ(found->edits, 20U);
}

TEST(Journal, ATornRecordIsNotRead) {
    const TemporaryFolder home;
    const Left left = leave_journal(home, 6);
    const std::string whole = text_of(left.file);
    size_t states = 0;
    for (size_t cut = 0; cut <= whole.size(); ++cut) {
        std::ofstream(left.file, std::ios::binary) << whole.substr(0, cut);
        const auto found = read_journal(left.file);
        const size_t now = found ? found->edits : 0;
        ASSERT_TRUE(now == states || now == states + 1) << "at byte " << cut;
        states = now;
        if (found) {
            ASSERT_EQ(found->text, left.texts[now - 1]);
        }
    }
    EXPECT_EQ(states, 6U);
}

TEST(Journal, DamagedBytesGiveAnEarlierStateOrNone) {
    const TemporaryFolder home;
    const Left left = leave_journal(home, 6);
    const std::string whole = text_of(left.file);
    std::mt19937 random(2);
    for (int i = 0; i < 3000; ++i) {
        std::string damaged = whole;
        for (size_t n = 1 + random() % 3; n > 0; --n)
            damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
        std::ofstream(left.file, std::ios::binary) << damaged;
        const auto found = read_journal(left.file);
        if (found) {
            ASSERT_EQ(found->text, left.texts[found->edits - 1]);
        }
    }
}

TEST(Journal, WhatIsSavedIsNotRecoverable) {
    const TemporaryFolder home;
    const Document other = set_name({}, "other"), saved = set_name({}, "saved");
    const fs::path graph = home.write("graph.json", write_document(saved));
    {
        Journal journal;
        journal.keep(home.path(), graph, "", other);
        journal.keep(home.path(), graph, "", saved);
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

// Copies the journals to "left", as a process that dies now leaves them: files without a lock.
// Returns that folder.
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

TEST_F(Headless, EveryCommittedEditIsInTheJournalAfterItsFrame) {
    open(small_graph);
    EXPECT_EQ(journals(home), 0U) << "nothing is unsaved";
    const auto kept = [&] {
        for (const auto& entry : fs::directory_iterator(home.path() / "state" / "journal"))
            if (const auto found = read_journal(entry.path())) return found->text;
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

TEST_F(Headless, AJournalThatCannotBeWrittenIsSaidAndTriedAgain) {
    open(small_graph);
    play("click node:number\nkey Delete");
    rlimit old = {};
    getrlimit(RLIMIT_FSIZE, &old);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small = {800, old.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    for (int i = 0; i < 20; ++i) {
        state.commit("Move", move_node(state.document(), "noise", i, 7.25));
        state.keeping.looked = 0;
        frame();
    }
    const std::string status = state.status, unkept = state.keeping.unkept;
    const bool saved = save_file(state);
    setrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, handler);
    EXPECT_FALSE(unkept.empty());
    EXPECT_EQ(saved, write_document(state.document()).size() <= 800);
    state.commit("Move", move_node(state.document(), "noise", 3, 99));
    state.keeping.looked = 0;
    frame();
    frame();
    EXPECT_TRUE(state.keeping.unkept.empty());
    leave_subgraphs(home, die(home));
    const auto found = list_recoverable(home.path() / "state");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].text, write_document(state.document())) << "nothing torn is in between";
}

// Prints its figure; does not check times.
TEST_F(Headless, FiguresOfTheJournalAtTwoThousandNodes) {
    std::string nodes, places;
    for (int i = 0; i < 2000; ++i) {
        const std::string id = "\"n" + std::to_string(i) + "\": ";
        nodes += (i ? "," : "") + id + R"({ "type": "add", "in": { "b": 0.25 } })";
        places += (i ? "," : "") + id + "[" + std::to_string(i) + ", 0]";
    }
    open_file(state, folder.write("long.json", R"({"wrinkle": 1, "nodes": {)" + nodes +
                                                   R"(}, "layout": {)" + places + "}}"));
    double all = 0, worst = 0;
    for (int i = 0; i < 100; ++i) {
        const std::string id = "n" + std::to_string(i * 19 % 2000);
        state.commit("edit", i % 2 ? move_node(state.document(), id, i, 3)
                                   : remove_node(state.document(), id));
        const auto start = std::chrono::steady_clock::now();
        keep_edits_now(state);
        const std::chrono::duration<double, std::milli> time =
            std::chrono::steady_clock::now() - start;
        all += time.count();
        worst = std::max(worst, time.count());
    }
    uintmax_t bytes = 0;
    for (const auto& entry : fs::directory_iterator(home.path() / "state" / "journal"))
        bytes += entry.file_size();
    std::printf("journal at 2,000 nodes: %.2f ms a commit (worst %.2f), %.1f kB in all\n",
                all / 100, worst, static_cast<double>(bytes) / 1000);
}

}  // namespace
}  // namespace wrinkle::editor
