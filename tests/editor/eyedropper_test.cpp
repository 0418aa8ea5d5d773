// Tests of the eyedropper of the color picker, without a window: values of the 2D view, a given
// pixel, and the keys. window_test.cpp reads pixels of the screen.
#include "headless.h"

namespace wrinkle::editor {
namespace {

// The 2D view shows `paint`; its blue exceeds the range of the screen.
const char* const two_colors = R"({"wrinkle": 1,
    "inputs": {"tint": {"type": "color", "default": [0.25, 0.25, 0.25]}},
    "nodes": {"paint": {"type": "color", "in": {"color": [0.6, 0.2, 3]}},
        "m": {"type": "material", "in": {"color": {"from": "input.tint"}, "fuzz_color": "#808080"}}},
    "outputs": {"material": {"from": "m.material"}},
    "layout": {"paint": [0, 0], "m": [300, 0]}})";

class Eyedroppers : public Headless {
protected:
    void SetUp() override {
        open(two_colors);
        state.flat.maker = &maker_;
        play("key 7\nclick node:paint\nkey Shift+E");
        for (int i = 0; i < 3; ++i)
            frame(), maker_.wait_idle(), frame();
    }
    void TearDown() override { state.flat.maker = nullptr; }
    std::array<double, 3> tint() const {
        const json::Value& value = state.document().inputs.find("tint")->default_value;
        return {value.at(0).as_number(), value.at(1).as_number(), value.at(2).as_number()};
    }

private:
    FlatMaker maker_{FlatPainter()};
};

TEST_F(Eyedroppers, TakeTheValueOfThe2dView) {
    play("click input:tint\nkey I\nwait 3\nclick flat\nwait 3");
    EXPECT_FALSE(state.eyedropper.on);
    EXPECT_NEAR(tint()[0], 0.6, 1e-6);
    EXPECT_NEAR(tint()[1], 0.2, 1e-6);
    EXPECT_NEAR(tint()[2], 3, 1e-6);
    EXPECT_EQ(state.view.selected, std::set<std::string>{"paint"}) << "the click did more";
    play("key Escape\nkey Ctrl+Z");
    EXPECT_NEAR(tint()[0], 0.25, 1e-6);
}

TEST_F(Eyedroppers, TakeThePixelElsewhere) {
    play("click input:tint\nclick input:tint:picker#pick\nwait 3");
    ASSERT_TRUE(state.eyedropper.on);
    state.eyedropper.pixel = {1, 0.5F, 0};
    play("click node:m\nwait 3");
    EXPECT_NEAR(tint()[0], 1, 1e-6);
    EXPECT_NEAR(tint()[1], 0.214041, 1e-6);  // 0.5 of sRGB
    EXPECT_EQ(tint()[2], 0);
}

TEST_F(Eyedroppers, EscapeLeavesThePickerOpen) {
    play("click input:tint\nkey I\nwait 3\nkey Escape\nwait 3\nassert target input:tint:picker");
    EXPECT_FALSE(state.eyedropper.on);
    play("assert clean\nkey Escape\nwait 3\nassert no-target input:tint:picker\nassert clean");
}

TEST_F(Eyedroppers, WorkInThePopupOfAField) {
    play("click field:m.fuzz_color.0\nwait 3\nkey I\nwait 3");
    ASSERT_TRUE(state.eyedropper.on);
    state.eyedropper.pixel = {1, 1, 0};
    play("click canvas\nwait 3\nassert target color\nassert value m.fuzz_color [1,1,0]");
    play("key I\nwait 3\nkey Escape\nwait 3\nassert target color");
    play("key Escape\nwait 3\nassert no-target color\nassert value m.fuzz_color \"#808080\"");
}

}  // namespace
}  // namespace wrinkle::editor
