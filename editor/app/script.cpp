#include "editor/app/script.h"

#include <cstdio>
#include <cstdlib>
#include <optional>

#include "base/text.h"
#include "editor/view/refresh.h"
#include "json/parse.h"

namespace wrinkle::editor {
namespace {

constexpr int settle_frames = 3;

std::vector<std::string> words_of(std::string_view line) {
    std::vector<std::string> words;
    for (const std::string_view word : split(line, ' '))
        if (!word.empty()) words.emplace_back(word);
    return words;
}

std::string rest(const std::vector<std::string>& words, size_t from) {
    std::string text;
    for (size_t i = from; i < words.size(); ++i)
        text += (i > from ? " " : "") + words[i];
    return text;
}

struct Spot {
    float x = 0, y = 0;
};

// Returns the position of "canvas+10,-20": the target's middle plus an offset in pixels;
// std::nullopt if there is no such target.
std::optional<Spot> spot_of(const std::string& name, const Targets& targets) {
    if (const auto rect = targets.find(name)) return Spot{rect->middle_x(), rect->middle_y()};
    const size_t plus = name.rfind('+'), comma = name.rfind(',');
    if (plus == name.npos || comma == name.npos || comma < plus) return std::nullopt;
    const auto rect = targets.find(name.substr(0, plus));
    if (!rect) return std::nullopt;
    const float dx = std::strtof(name.c_str() + plus + 1, nullptr);
    const float dy = std::strtof(name.c_str() + comma + 1, nullptr);
    return Spot{rect->middle_x() + dx, rect->middle_y() + dy};
}

Link link_of(const std::string& text) {
    const size_t dot = text.find('.');
    if (dot == text.npos) return {"", text};
    return {text.substr(0, dot), text.substr(dot + 1)};
}

bool has_wire(const State& state, const std::string& from, const std::string& to) {
    const Wire* wire = state.layout.wire_to(link_of(to));
    return wire && wire->from.text() == from;
}

bool has_value(const State& state, const std::string& place, const std::string& wanted) {
    const Link at = link_of(place);
    const Node* node = state.document().find(at.node);
    const Input* input = node ? node->find(at.port) : nullptr;
    if (!input) return wanted == "default";
    Diagnostics none;
    return json::parse(wanted, "", none).root == input->value;
}

size_t number(const std::string& text) {
    return static_cast<size_t>(std::strtoull(text.c_str(), nullptr, 10));
}

// Returns std::nullopt for an unknown assertion.
std::optional<bool> holds(const State& state, const std::vector<std::string>& w) {
    const std::string& what = w[1];
    if (what == "dirty") return state.dirty();
    if (what == "clean") return !state.dirty();
    if (what == "stale") return state.preview_stale;
    if (what == "picture")
        return state.preview && state.preview->shown().texture != 0 && !state.preview_stale;
    if (what == "other") return state.preview && state.preview->shown().other != 0;
    if (w.size() < 3) return std::nullopt;
    if (what == "nodes") return state.document().nodes.size() == number(w[2]);
    if (what == "wires") return state.layout.wires.size() == number(w[2]);
    if (what == "errors") return state.built.problems.error_count() == number(w[2]);
    if (what == "node") return state.document().find(w[2]) != nullptr;
    if (what == "no-node") return state.document().find(w[2]) == nullptr;
    if (what == "thumbnail") return state.node_feed.previews.places.contains(w[2]);
    if (what == "status") return state.status.find(rest(w, 2)) != std::string::npos;
    if (what == "target") return state.targets.find(w[2]).has_value();
    if (what == "no-target") return !state.targets.find(w[2]);
    if (what == "code")
        return state.built.uniform &&
               state.built.uniform->source.find(rest(w, 2)) != std::string::npos;
    if (w.size() < 4) return std::nullopt;
    if (what == "wire") return has_wire(state, w[2], w[3]);
    if (what == "no-wire") return !has_wire(state, w[2], w[3]);
    if (what == "value") return has_value(state, w[2], rest(w, 3));
    return std::nullopt;
}

bool begin_section(const State& state, const std::string& name) {
    if (state.timings) state.timings->section(name, state.counters.builds, state.counters.programs);
    return true;
}

void click(InputQueue& queue, int button = 0) {
    queue.button(button, true);
    queue.button(button, false);
}

bool say(const std::string& words) {
    std::printf("%s\n", words.c_str());
    return std::fflush(stdout) == 0;
}

}  // namespace

Script::Script(std::string_view text) {
    size_t line_number = 0;
    for (const std::string_view line : split(text, '\n')) {
        ++line_number;
        auto words = words_of(line);
        if (!words.empty() && words[0][0] != '#') lines_.push_back({line_number, std::move(words)});
    }
}

bool Script::fail(std::string why) {
    why_ = "line " + std::to_string(lines_[next_].number) + ": " + std::move(why);
    return false;
}

bool Script::point_at(const std::string& name, const State& state, InputQueue& queue) {
    const auto spot = spot_of(name, state.targets);
    if (!spot) return fail("nothing on the screen is called '" + name + "'");
    queue.motion(spot->x, spot->y);
    return true;
}

bool Script::drag(const std::vector<std::string>& w, const State& state, InputQueue& queue) {
    if (w.size() < 3) return fail("drag needs a beginning and an end");
    const auto from = spot_of(w[1], state.targets), to = spot_of(w[2], state.targets);
    if (!from || !to) return fail("nothing on the screen is called '" + (from ? w[2] : w[1]) + "'");
    queue.motion(from->x, from->y);
    queue.button(0, true);
    queue.motion((from->x + to->x) / 2, (from->y + to->y) / 2);
    queue.motion(to->x, to->y);
    queue.button(0, false);
    return true;
}

bool Script::drop(const std::vector<std::string>& w, const State& state, InputQueue& queue) {
    if (w.size() < 3) return fail("drop needs files and a place");
    const auto spot = spot_of(w.back(), state.targets);
    if (!spot) return fail("nothing on the screen is called '" + w.back() + "'");
    std::vector<std::string> files;
    for (size_t i = 1; i + 1 < w.size(); ++i)
        files.push_back((state.folder() / w[i]).string());
    queue.drop(spot->x, spot->y, std::move(files));
    return true;
}

void Script::count(const std::string& step, const std::vector<std::string>& words) {
    const bool commits = typing_ && step == "key" && words[1] == "Enter";
    const bool waits = step == "wait" || step == "assert" || step == "await" || step == "shot" ||
                       step == "section" || step == "lose";
    if (!commits && !waits) ++actions_;
    if (!waits) typing_ = step == "type";
}

bool Script::stroke(const std::vector<std::string>& w, const State& state, InputQueue& queue) {
    if (w.size() < 5) return fail("stroke needs keys, a button and two places");
    const int button = w[2] == "right" ? 1 : 0;
    std::vector<Spot> spots;
    for (size_t i = 3; i < w.size(); ++i) {
        const auto spot = spot_of(w[i], state.targets);
        if (!spot) return fail("nothing on the screen is called '" + w[i] + "'");
        spots.push_back(*spot);
    }
    const auto keys = split(w[1], '+');
    const auto hold = [&](bool down) {
        for (const std::string_view key : keys)
            if (key != "-") queue.key(key_named(key), down);
    };
    queue.motion(spots[0].x, spots[0].y);
    hold(true);
    queue.button(button, true);
    for (const Spot& spot : spots) {
        queue.motion(spot.x, spot.y);
        queue.key(0, false);  // not a key: the next motion waits for the next frame
    }
    queue.button(button, false);
    hold(false);
    return true;
}

// Steps at one target: clicks and wheel.
bool Script::point(const Line& line, const State& state, InputQueue& queue) {
    const auto& w = line.words;
    if (!point_at(w[1], state, queue)) return false;
    if (w[0] == "wheel") {
        queue.wheel(0, w.size() > 2 ? std::strtof(w[2].c_str(), nullptr) : 1);
        return true;
    }
    click(queue, w[0] == "right" ? 1 : 0);
    if (w[0] == "double") click(queue);
    return true;
}

bool Script::run(const Line& line, const State& state, InputQueue& queue, const Screen& screen) {
    const auto& w = line.words;
    const std::string& what = w[0];
    if (what == "wait") {
        settle_ = w.size() > 1 ? static_cast<int>(number(w[1])) : settle_frames;
        return true;
    }
    if (what == "finish") return finishing_ = true;
    if (w.size() < 2) return fail("'" + what + "' needs to know what");
    count(what, w);
    if (what == "click" || what == "right" || what == "double" || what == "wheel")
        return point(line, state, queue);
    if (what == "drag") return drag(w, state, queue);
    if (what == "drop") return drop(w, state, queue);
    if (what == "stroke") return stroke(w, state, queue);
    if (what == "key") return queue.chord(w[1]) || fail("there is no key '" + w[1] + "'");
    if (what == "type") {
        queue.type(rest(w, 1));
        return true;
    }
    return see(line, state, screen);
}

// Steps that are not user input.
bool Script::see(const Line& line, const State& state, const Screen& screen) {
    const auto& w = line.words;
    const std::string& what = w[0];
    if (what == "section") return begin_section(state, w[1]);
    if (what == "say") return say(rest(w, 1));
    if (what == "shot")
        return (screen.shot && screen.shot(w[1])) || fail("no screenshot could be written");
    if (what == "lose") {
        if (!screen.lose_driver || w[1] != "driver") return fail("there is no such thing to lose");
        screen.lose_driver();
        return true;
    }
    if (what != "assert" && what != "await") return fail("'" + what + "' is not a step");
    if (w[1] == "actions" && w.size() > 2)
        return actions_ <= number(w[2]) || fail(std::to_string(actions_) + " actions");
    const auto result = holds(state, w);
    if (!result) return fail("'" + rest(w, 1) + "' is nothing that can be asserted");
    return *result || fail("not so: " + rest(w, 1) + " (status: " + state.status + ")");
}

Script::Progress Script::step(const State& state, InputQueue& queue, const Screen& screen) {
    if (!queue.empty()) {
        settle_ = settle_frames;
        return Progress::running;
    }
    if (!is_settled(state)) return Progress::running;
    const bool works = state.tasks.running || state.follow.is_counting() || state.images.busy();
    if (finishing_ && works) return Progress::running;
    finishing_ = false;
    if (settle_-- > 0) return Progress::running;
    if (next_ == lines_.size()) return Progress::done;
    settle_ = settle_frames;
    const auto& words = lines_[next_].words;
    if (words[0] == "await" && words.size() > 1 && holds(state, words) == false)
        return Progress::running;
    if (!run(lines_[next_], state, queue, screen)) return Progress::failed;
    ++next_;
    return Progress::running;
}

}  // namespace wrinkle::editor
