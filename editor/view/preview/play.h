// Motion in the preview: a turntable, and seconds for an input of the graph named `time`, a float.
// The seconds are sent to the running program only: the document, its presets, the 2D view and
// exports have the value of the input.
#pragma once

#include <cstdint>
#include <optional>

namespace wrinkle::editor {

struct State;

struct Play {
    bool turning = false;                // the camera orbits, once in 20 s
    bool running = false;                // the seconds increase
    std::optional<double> seconds = {};  // nullopt: the value of the input

    // The seconds that were sent last, and the version of the program that got them.
    std::optional<double> sent = {};
    uint64_t program = 0;

    bool moves() const { return turning || running; }  // each frame differs from the last one
};

// Returns true if the preview shows a program that reads the input.
bool has_time(const State& state);
// Returns the seconds after which the time begins again: the end of the input's slider, 10 without
// one.
double time_end(const State& state);
// Advances by `delta` seconds. Called once each frame.
void advance(State& state, double delta);
// Sends the time to the program that the preview shows, if it has another one.
void send_time(State& state);

}  // namespace wrinkle::editor
