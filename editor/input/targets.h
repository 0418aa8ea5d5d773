// Where the things on the screen are, by name: "node:base", "pin:base.gradient",
// "field:softer.amount", "menu:save". Filled anew on every frame by whoever draws them; those of
// the canvas, which may hold thousands, are worked out when asked for. Scripts and tests point at
// names. Inputs and outputs of a node are told apart: "pin:sum.a" and "out:sum.gradient" would
// collide otherwise, so an output's pin is "out:".
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace wrinkle::editor {

struct TargetRect {
    float x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // screen pixels
    float middle_x() const { return (x0 + x1) * 0.5F; }
    float middle_y() const { return (y0 + y1) * 0.5F; }
};

class Targets {
public:
    void clear() { rects_.clear(); }
    void add(std::string name, TargetRect rect) { rects_[std::move(name)] = rect; }
    std::optional<TargetRect> find(const std::string& name) const {
        const auto found = rects_.find(name);
        if (found != rects_.end()) return found->second;
        return canvas_ ? canvas_(name) : std::nullopt;
    }
    // Knows the names that are not listed.
    using Source = std::function<std::optional<TargetRect>(const std::string& name)>;
    void set_canvas(Source canvas) { canvas_ = std::move(canvas); }
    const std::map<std::string, TargetRect>& all() const { return rects_; }

private:
    std::map<std::string, TargetRect> rects_;
    Source canvas_;
};

}  // namespace wrinkle::editor
