// Tests of the turntable and of the input `time`.
#include "editor/view/preview/play.h"

#include "editor/view/commands/commands.h"
#include "with_preview.h"

namespace wrinkle::editor {
namespace {

const char* const glowing = R"({ "wrinkle": 1,
    "inputs": { "time": { "type": "float", "default": 0.25, "slider": [0, 4] } },
    "presets": { "later": { "time": 0.5 } },
    "nodes": { "paint": { "type": "ramp", "in": { "factor": { "from": "input.time" } } } },
    "outputs": { "color": { "from": "paint.color" } } })";

TEST_F(Headless, TheTurntableTurnsUntilItIsPressedAgain) {
    open(small_graph);
    const float before = state.view.preview_view.yaw;
    play("key Shift+T\nwait 30");
    EXPECT_TRUE(state.play.moves());
    const float turned = state.view.preview_view.yaw;
    EXPECT_GT(turned, before + 0.05F);
    play("key Shift+T\nwait 5\nassert clean");
    EXPECT_FALSE(state.play.moves());
    const float after = state.view.preview_view.yaw;
    play("wait 5");
    EXPECT_EQ(state.view.preview_view.yaw, after);
}

TEST_F(Headless, WithoutAnInputTimeNothingPlays) {
    open(small_graph);
    EXPECT_FALSE(find_command("play")->enabled(state));
    play("assert no-target time:bar\nkey K\nwait 5");
    EXPECT_FALSE(state.play.moves());
}

TEST_F(Headless, TimeIsPlayedPausedAndMoved) {
    open(glowing);
    play("key K\nwait 30\nclick time:play\nassert clean");
    EXPECT_FALSE(state.play.moves());
    ASSERT_TRUE(state.play.seconds);
    EXPECT_GT(*state.play.seconds, 0.3);
    const double paused = *state.play.seconds;
    play("wait 10");
    EXPECT_EQ(state.play.seconds, paused);
    play("click time:bar\nassert clean");
    EXPECT_NEAR(*state.play.seconds, 2, 0.1) << "the middle of the slider";
    play("click time:reset");
    EXPECT_FALSE(state.play.seconds);
}

TEST_F(Headless, TimeIsThatOfTheFrames) {
    open(glowing);
    const auto run = [&](int frames) {
        for (int i = 0; i < frames; ++i)
            frame();
    };
    const double delta = static_cast<double>(ImGui::GetIO().DeltaTime);
    state.play.seconds = 0;
    state.play.running = true;
    run(60);
    EXPECT_NEAR(*state.play.seconds, 60 * delta, 1e-6);
    state.play = {.turning = true};
    const float before = state.view.preview_view.yaw;
    run(60);
    constexpr double full_turn = 20;  // seconds
    EXPECT_NEAR(state.view.preview_view.yaw - before, 60 * delta / full_turn * 6.2831853, 1e-4);
}

TEST_F(Headless, AnotherGraphHasTheTimeOfItsInput) {
    open(glowing);
    play("click time:bar");
    ASSERT_TRUE(state.play.seconds);
    open(glowing);
    EXPECT_FALSE(state.play.seconds);
}

TEST_F(Headless, TimeBeginsAgainAtTheEndOfTheSlider) {
    open(glowing);
    state.play.seconds = 3.99;
    play("key K\nwait 5");
    EXPECT_LT(*state.play.seconds, 1);
}

class PlayedPreview : public WithPreview {
protected:
    std::vector<uint8_t> seen() { return pixels_of(see().texture); }
};

TEST_F(PlayedPreview, ShowsTheTimeUntilItIsResetAndAfterOtherChanges) {
    begin(glowing);
    const auto first = seen();
    state.view.preview_request.preset = "later";
    const auto later = seen();
    EXPECT_NE(later, first);
    state.view.preview_request.preset.clear();
    state.play.seconds = 0.5;
    EXPECT_EQ(seen(), later);
    state.play.seconds = 0.25;
    EXPECT_EQ(seen(), first);
    state.view.preview_request.preset = "later";
    EXPECT_EQ(seen(), first) << "of another preset too";
    state.play.seconds.reset();
    EXPECT_EQ(seen(), later);
    EXPECT_FALSE(state.dirty());
}

TEST_F(PlayedPreview, AScriptGoesOnWhileItMoves) {
    begin(glowing);
    see();
    state.play.turning = true;
    preview_->show(state.view.preview_view, "", {}, side + 1, side);
    EXPECT_TRUE(is_settled(state));
}

}  // namespace
}  // namespace wrinkle::editor
