// Tests of input to a real window: xdotool sends keys and buttons through the X server.
// WRINKLE_TAPS sets their number in the longest test; default: 60. Skipped only if Xvfb is not
// available.
#include <atomic>
#include <cstdlib>
#include <random>
#include <thread>

#include "editor/model/document/recovery.h"
#include "graph/read.h"
#include "headless.h"
#include "running_editor.h"

namespace wrinkle::editor {
namespace {

using Clock = RunningEditor::Clock;
using Ms = std::chrono::milliseconds;

size_t taps() {
    const char* wanted = std::getenv("WRINKLE_TAPS");
    return wanted ? static_cast<size_t>(std::atoi(wanted)) : 60;
}

// Returns the newest unsaved text of the only open graph and the number of its edits; std::nullopt
// if there is no recovery file.
std::optional<Recoverable> kept(const std::filesystem::path& folder) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "journal", ignored))
        if (auto found = read_recovery_file(entry.path())) return found;
    return std::nullopt;
}

class Hand : public Headless {
protected:
    // The window has the size of the headless one, so the headless target positions are valid.
    void begin(const std::string& text) {
        open(text);
        for (int i = 0; i < 4; ++i)
            frame();
        editor.emplace(screen, std::vector<std::string>{file.string(), "--size", "1600", "900",
                                                        "--state", home.path().string()});
        // The title has the name of the graph after the first frame; the next few frames fit the
        // view.
        ASSERT_EQ(do_now("search --sync --onlyvisible --name graph.json windowfocus --sync"), 0);
        std::this_thread::sleep_for(Ms(500));
    }
    int do_now(const std::string& steps) const {
        const std::string command = screen.variable() + " xdotool " + steps + " >/dev/null 2>&1";
        return std::system(command.c_str());
    }
    std::string click_at(const std::string& target) const {
        const auto rect = state.targets.find(target);
        if (!rect) return "click-on-nothing";  // not an xdotool command, so it fails
        return "mousemove " + std::to_string(static_cast<int>(rect->middle_x())) + " " +
               std::to_string(static_cast<int>(rect->y0 + 8)) + " click 1 ";
    }
    // Waits until the recovery file has this many edits; after a time limit returns the last text
    // read.
    std::optional<Recoverable> wait_for(size_t edits) const {
        const auto patience = Clock::now() + std::chrono::seconds(40 + taps() / 3);
        std::optional<Recoverable> found;
        while (Clock::now() < patience && (!found || found->edits < edits)) {
            std::this_thread::sleep_for(Ms(50));
            found = kept(state.keeping.folders.state);
        }
        return found;
    }

    VirtualScreen screen;
    std::optional<RunningEditor> editor;
};

// Stops the process for all but 8 ms of each period, to simulate slow frames.
class Slowly {
public:
    Slowly(pid_t process, Ms period)
        : thread_([=, this] {
              while (!done_) {
                  kill(process, SIGSTOP);
                  std::this_thread::sleep_for(period - Ms(8));
                  kill(process, SIGCONT);
                  std::this_thread::sleep_for(Ms(8));
              }
          }) {}
    ~Slowly() {
        done_ = true;
        thread_.join();
    }
    Slowly(const Slowly&) = delete;
    Slowly& operator=(const Slowly&) = delete;

private:
    std::atomic<bool> done_ = false;
    std::thread thread_;
};

class HandAtRate : public Hand, public ::testing::WithParamInterface<int> {};

// Clicks select one of two nodes and keys mute it. A lost or reordered tap mutes the wrong node.
TEST_P(HandAtRate, EveryTapArrivesInOrder) {
    if (!screen.is_there()) GTEST_SKIP() << "there is no Xvfb here";
    begin(small_graph);
    std::mt19937 random(7);
    const char* const names[] = {"softer", "noise"};
    bool muted[2] = {false, false};
    size_t chosen = 0, edits = 0;
    std::string steps = click_at("node:softer");
    for (size_t i = 0; i < taps(); ++i) {
        if (random() % 2) {
            chosen = 1 - chosen;
            steps += click_at(std::string("node:") + names[chosen]);
        } else {
            steps += "key m ";
            muted[chosen] = !muted[chosen];
            ++edits;
        }
    }
    {
        const Slowly slowly(editor->process(), Ms(1000 / GetParam()));
        ASSERT_EQ(do_now(steps), 0);
    }
    const auto found = wait_for(edits);
    ASSERT_TRUE(found) << "nothing arrived";
    EXPECT_EQ(found->edits, edits);
    Diagnostics problems;
    const Document document = read_document(found->text, "graph.json", problems);
    for (size_t i = 0; i < 2; ++i)
        EXPECT_EQ(document.find(names[i])->muted, muted[i]) << names[i];
    std::printf("%zu taps, %zu edits at %d frames a second\n", taps(), found->edits, GetParam());
}

#if defined(__SANITIZE_ADDRESS__)  // every frame is slow there
INSTANTIATE_TEST_SUITE_P(FramesASecond, HandAtRate, ::testing::Values(20));
#else
INSTANTIATE_TEST_SUITE_P(FramesASecond, HandAtRate, ::testing::Values(5, 20, 60));
#endif

TEST_F(Hand, WhatIsTypedAheadIsNotLost) {
    if (!screen.is_there()) GTEST_SKIP() << "there is no Xvfb here";
    begin(small_graph);
    {
        const Slowly slowly(editor->process(), Ms(200));
        ASSERT_EQ(do_now("mousemove 400 700 key space type --delay 1 worley"), 0);
        ASSERT_EQ(do_now("key Return key ctrl+s"), 0);
    }
    const auto patience = Clock::now() + std::chrono::seconds(30);
    while (Clock::now() < patience && text_of(file).find("worley") == std::string::npos)
        std::this_thread::sleep_for(Ms(50));
    EXPECT_NE(text_of(file).find("worley"), std::string::npos) << text_of(file);
}

}  // namespace
}  // namespace wrinkle::editor
