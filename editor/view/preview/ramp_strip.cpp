#include "editor/view/preview/ramp_strip.h"

#include "editor/view/preview/flat_values.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

constexpr uint32_t strip_texels = 96;

// A graph of the ramp with u as its factor.
Document strip_document(const Node& node) {
    Node ramp = node, split;
    ramp.id = "ramp";
    std::erase_if(ramp.inputs,
                  [](const Input& input) { return input.kind != Input::Kind::literal; });
    split.id = "split";
    split.type = "separate_vec2";
    Document document = add_node(add_node({}, std::move(split)), std::move(ramp));
    document = connect(document, {"surface", "uv0"}, "split", "vector");
    return connect(document, {"split", "x"}, "ramp", "factor");
}

}  // namespace

std::vector<glm::dvec3> ramp_strip(const Node& node, const Registry& registry) {
    const Document document = strip_document(node);
    const FlatArea area{0, 0, 1.0 / strip_texels, strip_texels, 1};
    TextureStore no_textures;
    std::vector<FlatValues> drawn;
    std::vector<glm::dvec3> colors;
    if (!evaluate_flat(make_model(document, {}, registry), document, {"ramp"}, area, no_textures,
                       drawn))
        return colors;
    for (const FlatValues& each : drawn)
        for (size_t i = 0; i < each.values.size(); i += each.lanes)
            colors.push_back(flat_color(each.type, each.values.data() + i, {}));
    return colors;
}

void draw_strip(ImDrawList& list, ImVec2 low, ImVec2 high, std::span<const glm::dvec3> colors) {
    const float wide = (high.x - low.x) / static_cast<float>(colors.size());
    for (size_t i = 0; i < colors.size(); ++i) {
        const float x = low.x + wide * static_cast<float>(i);
        const auto byte = [&](double part) { return static_cast<int>(part * 255 + 0.5); };
        list.AddRectFilled({x, low.y}, {x + wide, high.y},
                           IM_COL32(byte(colors[i].r), byte(colors[i].g), byte(colors[i].b), 255));
    }
}

}  // namespace wrinkle::editor
