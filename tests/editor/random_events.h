// Random user input: mostly meaningful gestures (wires dragged from pin to pin, values dragged and
// typed, nodes moved and added, commands by their keys), interleaved with arbitrary keys, buttons
// and motion that overlap each other.
#pragma once

#include <random>
#include <string>

#include "editor/view/input/input_queue.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

class RandomEvents {
public:
    RandomEvents(State& state, InputQueue& queue, unsigned seed)
        : state_(state), queue_(queue), random_(seed) {}

    void next();               // one gesture
    void reset_interaction();  // releases all keys and buttons
    size_t count() const { return count_; }

private:
    size_t pick(size_t count) { return random_() % count; }
    float part(float whole) { return static_cast<float>(pick(1000)) / 1000 * whole; }

    void motion(float x, float y);
    void button(int button, bool down);
    void chord(std::string_view keys);
    void type(const std::string& text);

    bool aim(const std::string& name);  // moves to a target; false if it is not on the screen
    void move_by(float x, float y);
    std::string any_node();
    std::string any_port(const std::string& node, Port::Kind kind);
    std::string any_text();

    void wire();
    void drag_value();
    void type_value();
    void move_node();
    void click_node();
    void add_node();
    void command();
    void by_the_way();
    void anything();

    State& state_;
    InputQueue& queue_;
    std::mt19937 random_;
    size_t count_ = 0;
    float x_ = 0, y_ = 0;  // the pointer
};

}  // namespace wrinkle::editor
