// Tests of turns: renderings wait for frames, but only for a limited time.
#include "editor/view/preview/frame_gate.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

namespace wrinkle::editor {
namespace {

TEST(FrameGate, WithoutAFrameNobodyWaits) {
    FrameGate turns;
    turns.wait_for_frame();
    { const FrameGate::Frame frame(turns); }
    turns.wait_for_frame();
}

TEST(FrameGate, AStripComesAfterTheFrame) {
    FrameGate turns;
    int early = 0;
    constexpr int rounds = 100;
    for (int i = 0; i < rounds; ++i) {
        std::atomic<bool> ended = false, begun = false;
        std::optional<FrameGate::Frame> frame(std::in_place, turns);
        std::thread other([&] {
            begun = true;
            turns.wait_for_frame();
            early += !ended;
        });
        while (!begun)
            std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ended = true;
        frame.reset();
        other.join();
    }
    // The OS may suspend a thread between two of these lines, so some early renderings are allowed.
    EXPECT_LT(early, rounds / 2);
}

TEST(FrameGate, AFrameThatNeverEndsHoldsNothingUp) {
    FrameGate turns;
    const FrameGate::Frame frame(turns);
    turns.wait_for_frame();
}

}  // namespace
}  // namespace wrinkle::editor
