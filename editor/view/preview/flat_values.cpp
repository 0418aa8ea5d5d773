#include "editor/view/preview/flat_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/srgb.h"
#include "cpu/evaluate.h"
#include "editor/model/document/request.h"
#include "graph/edit.h"
#include "ir/side_tables.h"
#include "lower/material.h"

namespace wrinkle::editor {
namespace {

struct Shown {
    std::string node;
    std::string output;  // output of the document made for it
};

// Replaces the outputs by one for each wanted node that has a visible output.
std::vector<Shown> show_nodes(Document& document, const Model& model,
                              const std::vector<std::string>& wanted) {
    document.outputs = Table<Output>();
    std::vector<Shown> shown;
    for (const std::string& node : wanted) {
        const Port* port = shown_port(model.type_of(node));
        if (!port || port->type == PortType::material_) continue;
        shown.push_back({node, "picture" + std::to_string(shown.size())});
        document = set_output(document, shown.back().output, {node, port->name});
    }
    return shown;
}

std::array<double, 4> value_at(const FlatArea& area, InputNeed need, uint32_t x, uint32_t y) {
    const bool is_value = need.variant == Variant::value;
    const double u = is_value                      ? area.u + (x + 0.5) * area.texel
                     : need.variant == Variant::dx ? area.texel
                                                   : 0;
    const double v = is_value                      ? area.v + (y + 0.5) * area.texel
                     : need.variant == Variant::dy ? area.texel
                                                   : 0;
    const double one = is_value ? 1 : 0;
    switch (need.input) {
        case SurfaceInput::position_:
            return {is_value ? u - 1 : u, is_value ? v - 0.5 : v, 0, 0};
        case SurfaceInput::normal_:
        case SurfaceInput::view_:
            return {0, 0, one, 0};
        case SurfaceInput::tangent_:
            return {one, 0, 0, one};
        case SurfaceInput::color0_:
            return {one, one, one, one};
        case SurfaceInput::facing_:
            return {one, 0, 0, 0};
        default:
            return {u, v, 0, 0};
    }
}

PointSet points_of(const Program& program, const FlatArea& area) {
    PointSet points;
    points.count = size_t{area.width} * area.height;
    for (const InputNeed& need : needed_inputs(program)) {
        const auto lanes = size_t{info(info(need.input).type).lanes};
        std::vector<double>& values = points.at(need.input, need.variant);
        for (uint32_t y = 0; y < area.height; ++y)
            for (uint32_t x = 0; x < area.width; ++x) {
                const auto lane = value_at(area, need, x, y);
                values.insert(values.end(), lane.begin(), lane.begin() + lanes);
            }
    }
    return points;
}

glm::dvec3 normal_color(glm::dvec3 normal) {
    return 0.5 + 0.5 * glm::normalize(normal);
}

double fraction(double value) {
    return value - std::floor(value);
}

glm::dvec3 linear_color(PortType type, const double* lane, const Range& range) {
    switch (type) {
        case PortType::gradient_:
            return normal_color({-lane[0], -lane[1], 1 - lane[2]});
        case PortType::derivative_:
            return normal_color({-lane[0], -lane[1], 1});
        case PortType::normal_:
            return normal_color({lane[0], lane[1], lane[2]});
        case PortType::height_:
        case PortType::float_:
            return glm::dvec3((lane[0] - range.least) / (range.most - range.least));
        case PortType::vec2_:
            return {fraction(lane[0]), fraction(lane[1]), 0};
        default:
            return {lane[0], lane[1], lane[2]};
    }
}

struct Evaluated {
    std::string name;
    FlatValues values;  // without a node
};

// Evaluates all outputs of a document. Returns false if it does not compile.
bool evaluate_outputs(const Model& model, const Document& document, const FlatArea& area,
                      TextureStore& textures, std::vector<Evaluated>& result) {
    MaterialOptions options;
    options.given_differentials = true;
    options.runs_calls = "the 2D view";
    Diagnostics problems;
    const Project project = project_to_compile(model, document, problems);
    const Compiled compiled = compile_material(project, *model.registry, options, problems);
    if (!compiled.ok) return false;
    std::string why;
    const Program program = compile_program(compiled.module, why);
    if (!why.empty()) return false;
    const size_t count = size_t{area.width} * area.height;
    Results results = make_results(program, count);
    Diagnostics said_elsewhere;
    for (const Resource& resource : compiled.module.resources)
        textures.read(texels_of(resource), said_elsewhere);
    evaluate<float>(program, points_of(program, area),
                    textures.textures_of(compiled.module.resources), 0, count, results);
    for (size_t i = 0; i < program.outputs.size(); ++i) {
        std::vector<double>& values = results.values[i];
        const size_t lanes = values.size() / std::max(count, size_t{1});
        result.push_back(
            {program.outputs[i].name,
             {{}, static_cast<PortType>(program.outputs[i].port_type), lanes, std::move(values)}});
    }
    return true;
}

}  // namespace

bool evaluate_flat(const Model& model, const Document& document,
                   const std::vector<std::string>& nodes, const FlatArea& area,
                   TextureStore& textures, std::vector<FlatValues>& result) {
    Document with_outputs = document;
    const std::vector<Shown> shown = show_nodes(with_outputs, model, nodes);
    if (shown.empty()) return true;
    std::vector<Evaluated> outputs;
    if (!evaluate_outputs(model, with_outputs, area, textures, outputs)) return false;
    for (Evaluated& output : outputs)
        if (const auto found = std::ranges::find(shown, output.name, &Shown::output);
            found != shown.end()) {
            output.values.node = found->node;
            result.push_back(std::move(output.values));
        }
    return true;
}

std::optional<FlatValues> evaluate_flat(const Model& model, const Document& document,
                                        const std::string& node, const std::string& channel,
                                        const FlatArea& area, TextureStore& textures) {
    std::vector<FlatValues> one;
    if (!evaluate_flat(model, document, {node}, area, textures, one)) return std::nullopt;
    if (!one.empty()) return std::move(one.front());
    const Port* port = shown_port(model.type_of(node));
    if (!port || port->type != PortType::material_) return std::nullopt;
    Document with_material = document;
    with_material.outputs = Table<Output>();
    with_material = set_output(with_material, "material", {node, port->name});
    std::vector<Evaluated> outputs;
    if (!evaluate_outputs(model, with_material, area, textures, outputs) || outputs.empty())
        return std::nullopt;
    auto shown = std::ranges::find(outputs, channel, &Evaluated::name);
    if (shown == outputs.end()) shown = std::ranges::find(outputs, "color", &Evaluated::name);
    if (shown == outputs.end()) shown = outputs.begin();
    FlatValues values = std::move(shown->values);
    values.node = node;
    values.channel = shown->name;
    for (const Evaluated& output : outputs)
        values.channels.push_back(output.name);
    return values;
}

Range range_of_values(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return values.empty() || !(*most > *least) ? Range{0, 1} : Range{*least, *most};
}

glm::dvec3 flat_color(PortType type, const double* lanes, const Range& range) {
    glm::dvec3 color = linear_color(type, lanes, range);
    if (!std::isfinite(color.x + color.y + color.z)) return {1, 0, 1};
    if (type == PortType::color_)
        for (int c = 0; c < 3; ++c)
            color[c] = srgb_from_linear(std::clamp(color[c], 0.0, 1.0));
    return color;
}

void append_texel(std::vector<uint8_t>& texels, glm::dvec3 color) {
    for (int c = 0; c < 3; ++c)
        texels.push_back(static_cast<uint8_t>(std::clamp(color[c], 0.0, 1.0) * 255 + 0.5));
    texels.push_back(255);
}

std::vector<uint8_t> texels_of(const FlatValues& values) {
    std::vector<uint8_t> texels;
    const Range range = range_of_values(values.values);
    for (size_t i = 0; i + values.lanes <= values.values.size(); i += values.lanes)
        append_texel(texels, flat_color(values.type, values.values.data() + i, range));
    return texels;
}

}  // namespace wrinkle::editor
