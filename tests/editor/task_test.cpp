// Tests of background tasks: progress strip, cancellation, failed writes.
#include "editor/model/tasks/task.h"

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

#include "editor/model/document/folders.h"
#include "editor/view/panels/regions.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;

// A task that ends when `go` is set or when it is cancelled.
TaskSpec waiting_order(Session& session, const std::shared_ptr<std::atomic<bool>>& go, bool good) {
    const auto work = [go, good](TaskProgress& progress) -> TaskOutcome {
        progress.total = 4;
        progress.done = 1;
        while (!*go && !progress.cancelled)
            usleep(1000);
        return {good, good ? "Wrote it." : "It was not written: the disk is full."};
    };
    const auto again = [&session] {
        start_task(session, {"Once more",
                             [](TaskProgress&) -> TaskOutcome {
                                 return {true, "Wrote it at last."};
                             },
                             {}});
    };
    return {"Writing", work, again};
}

TEST_F(Headless, ATaskHasAStripAndTheRestGoesOn) {
    open(small_graph);
    const float before = regions_of(state).work.size.y;
    const auto go = std::make_shared<std::atomic<bool>>(false);
    ASSERT_TRUE(start_task(state, waiting_order(state, go, true)));
    EXPECT_FALSE(start_task(state, waiting_order(state, go, true)));
    EXPECT_EQ(state.status, "Writing is not done yet.");
    play("wait\nassert target task:cancel\nclick node:number\nkey Delete\nassert nodes 3");
    EXPECT_EQ(regions_of(state).work.size.y, before - task_height);
    *go = true;
    play("finish\nassert status Wrote it.\nassert no-target task:cancel");
    EXPECT_EQ(regions_of(state).work.size.y, before);
}

TEST_F(Headless, ATaskIsCancelledByItsButton) {
    open(small_graph);
    ASSERT_TRUE(
        start_task(state, waiting_order(state, std::make_shared<std::atomic<bool>>(false), false)));
    play("wait\nclick task:cancel\nfinish\nassert status Nothing was written.");
    EXPECT_FALSE(state.tasks.shown());
}

TEST_F(Headless, AFailedTaskSaysWhyAndIsTriedAgain) {
    open(small_graph);
    const auto go = std::make_shared<std::atomic<bool>>(true);
    ASSERT_TRUE(start_task(state, waiting_order(state, go, false)));
    play("finish\nassert status the disk is full\nassert target task:again");
    EXPECT_EQ(state.tasks.failed, "It was not written: the disk is full.");
    play("click task:again\nfinish\nassert status at last\nassert no-target task:again");
    ASSERT_TRUE(start_task(state, waiting_order(state, go, false)));
    play("finish\nclick task:close\nassert no-target task:close");
}

TEST_F(Headless, AnExportToAFullDiskSaysSoAndLeavesNothing) {
    open(small_graph);
    const fs::path out = folder.path() / "out";
    fs::create_directory(out);
    rlimit old = {};
    getrlimit(RLIMIT_FSIZE, &old);
    const rlimit small = {100, old.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    start_code_export(state, out / "a.glsl");
    const TaskOutcome outcome = state.tasks.running->outcome();
    setrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, handler);
    EXPECT_FALSE(outcome.good);
    EXPECT_EQ(outcome.sentence, "a.glsl was not written: it is larger than a file may be here.");
    EXPECT_TRUE(fs::is_empty(out));
    play("click task:again\nfinish\nassert status Wrote a.glsl.");
    EXPECT_EQ(text_of(out / "a.glsl"), program_output("compile " + file.string()));
}

TEST_F(Headless, AnExportToAFolderThatIsGoneSaysSo) {
    open(small_graph);
    start_code_export(state, folder.path() / "nowhere" / "a.glsl");
    play("finish\nassert status a.glsl was not written: its folder is no longer there.");
    EXPECT_EQ(disk_words("cannot be written: No space left on device"), "the disk is full");
    EXPECT_EQ(disk_words("cannot be written: Read-only file system"), "the disk can only be read");
    EXPECT_EQ(disk_words("something else"), "something else");
}

}  // namespace
}  // namespace wrinkle::editor
