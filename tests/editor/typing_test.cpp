// Tests of values: fast typing, and display.
#include <cmath>

#include "editor/view/canvas/layout.h"
#include "graph/edit.h"
#include "headless.h"
#include "json/parse.h"

namespace wrinkle::editor {
namespace {

const char* const vectors = R"({"wrinkle": 1, "nodes": {
    "turn": {"type": "uv_transform"}, "rock": {"type": "gradient_noise"}},
    "layout": {"turn": [0, 0], "rock": [400, 0]}})";

class Typing : public Headless {
protected:
    void wait(int frames) {
        for (int i = 0; i < frames; ++i)
            frame();
    }
    // Sends input as a keyboard does: key press, character, key release.
    void tap(const char* key, unsigned letter, int frames) {
        queue.key(key_named(key), true);
        if (letter) queue.character(letter);
        wait(frames);
        queue.key(key_named(key), false);
        wait(frames);
    }
    void play_out() {
        while (!queue.empty())
            frame();
        wait(8);
    }
};

TEST_F(Typing, NoDigitAfterTabIsLost) {
    open(vectors);
    for (int frames = 0; frames < 6; ++frames) {
        play("double field:turn.scale.0\nwait 10");
        tap("4", '4', frames);
        tap("Tab", 0, frames);
        tap("5", '5', frames);
        tap("Enter", 0, frames);
        play_out();
        play("assert value turn.scale [4, 5]\nkey Ctrl+Z\nkey Ctrl+Z\nassert clean");
        EXPECT_EQ(state.popup.kind, Popup::Kind::none) << frames << " frames between";
    }
}

TEST_F(Typing, NoLetterThatIsTypedAheadOfASearchIsLost) {
    open(vectors);
    for (int frames = 0; frames < 4; ++frames) {
        tap("Space", ' ', frames);
        for (const char letter : std::string("worley"))
            tap(std::string(1, static_cast<char>(std::toupper(letter))).c_str(),
                static_cast<unsigned>(letter), frames);
        wait(12);
        while (!queue.empty())
            frame();
        EXPECT_EQ(state.palette.query, "worley") << frames << " frames between";
        play("key Escape\nwait 4");
        state.palette = {};
    }
}

TEST_F(Typing, KeysComeThroughWhenNoFieldTakesThem) {
    open(vectors);
    state.field_wait = 6;  // as if a field had opened without getting the focus
    play("key Ctrl+A");
    EXPECT_EQ(state.view.selected.size(), 2U);
}

class Shown : public Headless {
protected:
    std::string shown(const char* node, const char* port, const std::string& value) {
        Diagnostics none;
        state.commit("value",
                     set_value(state.document(), node, port, json::parse(value, "", none).root));
        frame();
        for (const Field& field : state.layout.find(node)->fields)
            if (field.port == port) return field.value;
        return "none";
    }
};

TEST_F(Shown, ANumberReadsAsItsValue) {
    open(vectors);
    EXPECT_EQ(shown("rock", "scale", "0.015"), "0.015 \u00D7");
    EXPECT_EQ(shown("rock", "scale", "0.6"), "0.6 \u00D7");
    EXPECT_EQ(shown("rock", "scale", "7"), "7 \u00D7");
    EXPECT_EQ(shown("rock", "scale", "1234.5"), "1234.5 \u00D7");
    EXPECT_EQ(shown("rock", "scale", "100000"), "100000 \u00D7");
    EXPECT_EQ(shown("rock", "scale", "-0.25"), "-0.25 \u00D7");
    EXPECT_EQ(shown("rock", "scale", "0.00001"), "1e-05 \u00D7");
    EXPECT_EQ(shown("rock", "gain", "0.333"), "0.333");
    EXPECT_EQ(shown("rock", "amplitude", "0.0125"), "0.0125 m");
    EXPECT_EQ(shown("rock", "octaves", "3"), "3");
}

// A narrow field drops the zero before the decimal point, then decimals; never the integer part.
TEST_F(Shown, ANumberWithoutRoomIsRounded) {
    open(vectors);
    EXPECT_EQ(shown("turn", "scale", "[0.5, 1]"), "0.5");
    EXPECT_EQ(shown("turn", "scale", "[12.5, 1]"), "12.5");
    const std::string narrow = shown("turn", "scale", "[3.14159265, 1]");
    EXPECT_TRUE(narrow.starts_with("3.1")) << narrow;
    EXPECT_NEAR(std::stod(narrow), 3.14159265, 0.05);
    const std::string small = shown("turn", "scale", "[0.015, 1]");
    EXPECT_NEAR(std::stod(small), 0.015, 1e-9) << small;
    for (const char* value : {"[0.33333333, 1]", "[-0.123456, 1]", "[123.456, 1]"}) {
        const std::string text = shown("turn", "scale", value);
        EXPECT_EQ(text.find("..."), text.npos) << text;
        EXPECT_NEAR(std::stod(text), std::stod(value + 1), std::fabs(std::stod(value + 1)) * 0.05);
    }
}

}  // namespace
}  // namespace wrinkle::editor
