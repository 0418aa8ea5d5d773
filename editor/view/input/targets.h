// Screen rectangles of interface elements by name: "node:base", "pin:base.gradient",
// "field:softer.amount", "menu:save". The code that draws an element adds it in each frame; targets
// on the canvas, possibly thousands, are computed on lookup. Scripts and tests use the names. Pins
// of inputs are "pin:sum.a", pins of outputs "out:sum.gradient", because an input and an output may
// have the same name.
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
    // Looks up names that were not added; returns std::nullopt if unknown.
    using Source = std::function<std::optional<TargetRect>(const std::string& name)>;
    void set_canvas(Source canvas) { canvas_ = std::move(canvas); }
    const std::map<std::string, TargetRect>& all() const { return rects_; }

private:
    std::map<std::string, TargetRect> rects_;
    Source canvas_;
};

}  // namespace wrinkle::editor
