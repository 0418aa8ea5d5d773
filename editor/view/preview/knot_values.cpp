#include "editor/view/preview/knot_values.h"

#include <algorithm>

#include "editor/model/document/knots.h"
#include "editor/view/look/draw.h"
#include "editor/view/preview/flat_values.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

constexpr uint32_t sample_count = 96;

// A graph of the node with u as its mapped input.
Document graph_of(const Node& node, std::string_view mapped) {
    Node copy = node, split;
    copy.id = "knots";
    std::erase_if(copy.inputs,
                  [](const Input& input) { return input.kind != Input::Kind::literal; });
    split.id = "split";
    split.type = "separate_vec2";
    Document document = add_node(add_node({}, std::move(split)), std::move(copy));
    document = connect(document, {"surface", "uv0"}, "split", "vector");
    return connect(document, {"split", "x"}, "knots", mapped);
}

FlatValues values_of(const Node& node, const Registry& registry) {
    const Document document = graph_of(node, mapped_port(*registry.find(node.type)));
    const FlatArea area{0, 0, 1.0 / sample_count, sample_count, 1};
    TextureStore no_textures;
    std::vector<FlatValues> values;
    evaluate_flat(make_model(document, {}, registry), document, {"knots"}, area, no_textures,
                  values);
    return values.empty() ? FlatValues() : std::move(values.front());
}

}  // namespace

std::vector<glm::dvec3> ramp_colors(const Node& node, const Registry& registry) {
    const FlatValues values = values_of(node, registry);
    std::vector<glm::dvec3> colors;
    for (size_t i = 0; i < values.values.size(); i += values.lanes)
        colors.push_back(flat_color(values.type, values.values.data() + i, {}));
    return colors;
}

std::vector<double> curve_values(const Node& node, const Registry& registry) {
    return values_of(node, registry).values;
}

Range range_of_curve(const std::vector<double>& values, const std::vector<glm::dvec2>& points) {
    Range range{0, 1};
    const auto add = [&](double value) {
        range = {std::min(range.least, value), std::max(range.most, value)};
    };
    std::ranges::for_each(values, add);
    for (const glm::dvec2& point : points)
        add(point.y);
    return range;
}

void draw_ramp_colors(ImDrawList& list, ImVec2 low, ImVec2 high,
                      std::span<const glm::dvec3> colors) {
    const float wide = (high.x - low.x) / static_cast<float>(colors.size());
    for (size_t i = 0; i < colors.size(); ++i) {
        const float x = low.x + wide * static_cast<float>(i);
        const auto byte = [&](double part) { return static_cast<int>(part * 255 + 0.5); };
        list.AddRectFilled({x, low.y}, {x + wide, high.y},
                           IM_COL32(byte(colors[i].r), byte(colors[i].g), byte(colors[i].b), 255));
    }
}

void draw_curve_values(ImDrawList& list, ImVec2 low, ImVec2 high, std::span<const double> values,
                       const Range& range, ImU32 color) {
    const float wide = (high.x - low.x) / static_cast<float>(values.size());
    std::vector<ImVec2> line;
    for (size_t i = 0; i < values.size(); ++i) {
        const double part = (values[i] - range.least) / (range.most - range.least);
        const auto up = static_cast<float>(std::clamp(part, 0.0, 1.0));
        line.push_back(
            {low.x + wide * (static_cast<float>(i) + 0.5F), high.y - (high.y - low.y) * up});
    }
    list.AddPolyline(line.data(), static_cast<int>(line.size()), color, 0, 2);
}

}  // namespace wrinkle::editor
