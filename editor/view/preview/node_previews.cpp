#include "editor/view/preview/node_previews.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "base/srgb.h"
#include "cpu/evaluate.h"
#include "editor/model/document/request.h"
#include "graph/edit.h"
#include "lower/material.h"

namespace wrinkle::editor {
namespace {

constexpr size_t texel_count = size_t{NodePreviews::width} * NodePreviews::height;
constexpr double texel = 1.0 / NodePreviews::height;

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

std::array<double, 4> value_at(InputNeed need, uint32_t x, uint32_t y) {
    const bool is_value = need.variant == Variant::value;
    const double u = is_value ? (x + 0.5) * texel : need.variant == Variant::dx ? texel : 0;
    const double v = is_value ? (y + 0.5) * texel : need.variant == Variant::dy ? texel : 0;
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

PointSet patch(const Program& program) {
    PointSet points;
    points.count = texel_count;
    for (const InputNeed& need : needed_inputs(program)) {
        const auto lanes = size_t{info(info(need.input).type).lanes};
        std::vector<double>& values = points.at(need.input, need.variant);
        for (uint32_t y = 0; y < NodePreviews::height; ++y)
            for (uint32_t x = 0; x < NodePreviews::width; ++x) {
                const auto lane = value_at(need, x, y);
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

// Color of a texel from its components; `low` and `range` are those of all texels.
glm::dvec3 color_of(PortType type, const double* lane, double low, double range) {
    switch (type) {
        case PortType::gradient_:
            return normal_color({-lane[0], -lane[1], 1 - lane[2]});
        case PortType::derivative_:
            return normal_color({-lane[0], -lane[1], 1});
        case PortType::normal_:
            return normal_color({lane[0], lane[1], lane[2]});
        case PortType::height_:
        case PortType::float_:
            return glm::dvec3((lane[0] - low) / range);
        case PortType::vec2_:
            return {fraction(lane[0]), fraction(lane[1]), 0};
        default:
            return {lane[0], lane[1], lane[2]};
    }
}

void append(std::vector<uint8_t>& texels, PortType type, const std::vector<double>& values) {
    const size_t lanes = values.size() / texel_count;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    // A constant image is shown by its value.
    const bool flat = !(*most > *least);
    const double low = flat ? 0 : *least, range = flat ? 1 : *most - *least;
    for (size_t i = 0; i < texel_count; ++i) {
        glm::dvec3 color = color_of(type, values.data() + i * lanes, low, range);
        if (!std::isfinite(color.x + color.y + color.z)) color = {1, 0, 1};
        if (type == PortType::color_)
            for (int c = 0; c < 3; ++c)
                color[c] = srgb_from_linear(std::clamp(color[c], 0.0, 1.0));
        for (int c = 0; c < 3; ++c)
            texels.push_back(static_cast<uint8_t>(std::clamp(color[c], 0.0, 1.0) * 255 + 0.5));
        texels.push_back(255);
    }
}

}  // namespace

NodePreviews NodePainter::operator()(const NodePreviewJob& job) {
    NodePreviews previews;
    previews.version = job.version;
    if (std::exchange(images_, job.images) != job.images) textures_.forget();
    std::vector<std::string> wanted;
    for (const NodePtr& node : job.document.nodes)
        if (job.nodes.contains(node->id)) wanted.push_back(node->id);
    // Compiles all nodes in one program. If that fails, compiles each half separately, so that one
    // broken node does not hide others.
    std::vector<std::vector<std::string>> groups{std::move(wanted)};
    while (!groups.empty()) {
        const std::vector<std::string> group = std::move(groups.back());
        groups.pop_back();
        if (draw_group(job, group, previews) || group.size() < 2) continue;
        const auto middle = group.begin() + static_cast<std::ptrdiff_t>(group.size() / 2);
        groups.emplace_back(middle, group.end());
        groups.emplace_back(group.begin(), middle);
    }
    return previews;
}

bool NodePainter::draw_group(const NodePreviewJob& job, const std::vector<std::string>& nodes,
                             NodePreviews& previews) {
    Document document = job.document;
    const std::vector<Shown> shown = show_nodes(document, job.model, nodes);
    if (shown.empty()) return true;
    MaterialOptions options;
    options.given_differentials = true;
    options.runs_calls = "the pictures";
    Diagnostics problems;
    const Project project = project_to_compile(job.model, document, problems);
    const Compiled compiled = compile_material(project, *job.model.registry, options, problems);
    if (!compiled.ok) return false;
    std::string why;
    const Program program = compile_program(compiled.module, why);
    if (!why.empty()) return false;
    Results results = make_results(program, texel_count);
    Diagnostics said_elsewhere;
    for (const Resource& resource : compiled.module.resources)
        textures_.read(texels_of(resource), said_elsewhere);
    evaluate<float>(program, patch(program), textures_.textures_of(compiled.module.resources), 0,
                    texel_count, results);
    for (size_t i = 0; i < program.outputs.size(); ++i) {
        const auto found = std::ranges::find(shown, program.outputs[i].name, &Shown::output);
        if (found == shown.end()) continue;
        previews.places[found->node] = static_cast<uint32_t>(previews.places.size());
        append(previews.texels, static_cast<PortType>(program.outputs[i].port_type),
               results.values[i]);
    }
    return true;
}

}  // namespace wrinkle::editor
