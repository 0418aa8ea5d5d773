// Script of user actions, played through the input queue, for tests with and without a window. One
// step per line; a line that begins with '#' is a comment. NAME, FROM and TO are target names
// (targets.h), optionally with an offset in pixels from the middle: "canvas+-200,150".
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/view/input/input_queue.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

// Steps:
//
//   click NAME      right NAME      double NAME      drag FROM TO      wheel NAME AMOUNT
//   stroke MODIFIERS left|right FROM TO ...    a drag over all points with keys held; "-": none
//   key Ctrl+Z      type TEXT       wait [FRAMES]    shot FILE.png
//   say TEXT                        prints to standard output, to show the progress
//   drop FILE... NAME               drops files; relative paths begin at the graph's folder
//   finish                          waits for tasks, cost counts and image checks
//   await CONDITION                 waits until a condition of `assert` is true
//   section NAME                    begins a section of the timings (editor/view/timings.h)
//   lose driver                     simulates a lost GL context
//   assert nodes N | wires N | errors N | dirty | clean | node ID | no-node ID | wire FROM TO |
//          no-wire FROM TO | value NODE.PORT JSON | code TEXT | status TEXT | target NAME |
//          no-target NAME | stale | picture | other | thumbnail NODE | actions N
//
// `actions N`: at most N user actions so far. Each click, wheel, drag, stroke, drop and chord of
// keys is one action, as is each typed text with the Enter that commits it; `say` counts as well.
// `stale`: the preview shows an older graph. `other`: it compares two sides.
//
// A step begins when the input of the previous step is consumed, build and preview are those of the
// newest document, and a few more frames have been drawn.
class Script {
public:
    enum class Progress : uint8_t { running, done, failed };
    // Operations that need a window.
    struct Screen {
        std::function<bool(const std::string& file)> shot;  // returns false on failure
        std::function<void()> lose_driver;
    };

    explicit Script(std::string_view text);

    // Called once a frame, before the queue is applied.
    Progress step(const State& state, InputQueue& queue, const Screen& screen);
    // Error message with its line: "line 3: nothing on the screen is called 'node:x'".
    const std::string& why() const { return why_; }

private:
    struct Line {
        size_t number;
        std::vector<std::string> words;
    };
    // The functions that return bool return false, with the reason in why_, if the step fails.
    bool run(const Line& line, const State& state, InputQueue& queue, const Screen& screen);
    bool point(const Line& line, const State& state, InputQueue& queue);
    bool see(const Line& line, const State& state, const Screen& screen);
    bool drag(const std::vector<std::string>& words, const State& state, InputQueue& queue);
    bool drop(const std::vector<std::string>& words, const State& state, InputQueue& queue);
    void count(const std::string& step, const std::vector<std::string>& words);
    bool stroke(const std::vector<std::string>& words, const State& state, InputQueue& queue);
    bool fail(std::string why);
    bool point_at(const std::string& name, const State& state, InputQueue& queue);

    std::vector<Line> lines_;
    size_t next_ = 0;
    int settle_ = 0;  // frames to draw before the next step
    size_t actions_ = 0;
    bool typing_ = false;     // typed text is not committed yet
    bool finishing_ = false;  // waiting for background work
    std::string why_;
};

}  // namespace wrinkle::editor
