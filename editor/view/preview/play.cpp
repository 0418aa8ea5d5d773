#include "editor/view/preview/play.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "editor/model/document/inputs.h"
#include "editor/view/preview/feed.h"

namespace wrinkle::editor {
namespace {

constexpr const char* time_input = "time";
constexpr double turn_time = 20;  // seconds of a full turn
constexpr double usual_end = 10;
constexpr double longest_step = 0.1;  // so that a pause between frames is not a jump

}  // namespace

bool has_time(const State& state) {
    const Port* port = port_of_input(state.model, time_input);
    return port && port->is_value() && port->type == PortType::float_ &&
           reads_input(state.follow, time_input);
}

double time_end(const State& state) {
    const Port* port = port_of_input(state.model, time_input);
    return port && port->has_soft_range() && port->soft_max > 0 ? port->soft_max : usual_end;
}

void advance(State& state, double delta) {
    Play& play = state.play;
    delta = std::min(delta, longest_step);
    if (play.turning)
        state.view.preview_view.yaw += static_cast<float>(delta * 2 * std::numbers::pi / turn_time);
    if (!has_time(state)) {
        play.running = false;
        return;
    }
    if (play.running) play.seconds = std::fmod(play.seconds.value_or(0) + delta, time_end(state));
}

void send_time(State& state) {
    Play& play = state.play;
    if (!has_time(state)) return;
    const uint64_t program = state.follow.drawn.version;
    if (play.seconds == play.sent && (!play.seconds || play.program == program)) return;
    send_number(state, time_input, play.seconds);
    play.sent = play.seconds;
    play.program = program;
}

}  // namespace wrinkle::editor
