// A list of things a hand would do, played through the input queue: for tests in a window and
// without one. One line each; '#' begins a comment. NAME is a name of targets.h, with an offset in
// pixels from its middle where wanted: "canvas+-200,150".
//
//   click NAME      right NAME      double NAME      drag FROM TO      wheel NAME AMOUNT
//   stroke MODIFIERS left|right FROM TO ...    a drag with keys held, "-" for none, over all places
//   key Ctrl+Z      type TEXT       wait [FRAMES]    shot FILE.png
//   say TEXT        (to standard output: so far it has come)
//   drop FILE... NAME               files by their path, a relative one from the graph's folder
//   finish                          waits for what runs in the background
//   await CONDITION                 waits until it holds, one that `assert` knows
//   section NAME                    of the timings (editor/timings.h)
//   lose driver                     as if the graphics driver had dropped all that it had
//   assert nodes N | wires N | errors N | dirty | clean | node ID | no-node ID | wire FROM TO |
//          no-wire FROM TO | value NODE.PORT JSON | code TEXT | status TEXT | target NAME |
//          no-target NAME | stale | picture | other | thumbnail NODE | actions N
//
// Actions are what a hand has done: each click, drag, drop, chord of keys, and each text that was
// typed and committed with Enter counts as one. The assertion holds for N and less.
//
// A step begins when the input of the former one has been used up, the texts and the picture are of
// the newest document, and everything has been drawn. `other`: the preview compares two sides.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/input/input_queue.h"
#include "editor/state.h"

namespace wrinkle::editor {

class Script {
public:
    enum class Progress : uint8_t { running, done, failed };
    // What only a window can do.
    struct Screen {
        std::function<bool(const std::string& file)> shot;  // false when it cannot
        std::function<void()> lose_driver;
    };

    explicit Script(std::string_view text);

    // Once a frame, before the queue is applied.
    Progress step(const State& state, InputQueue& queue, const Screen& screen);
    // Says what went wrong and in which line: "line 3: nothing on the screen is called 'node:x'".
    const std::string& why() const { return why_; }

private:
    struct Line {
        size_t number;
        std::vector<std::string> words;
    };
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
    int settle_ = 0;
    size_t actions_ = 0;
    bool typing_ = false;     // the text is not committed yet
    bool finishing_ = false;  // what runs in the background is waited for
    std::string why_;
};

}  // namespace wrinkle::editor
