#include "editor/model/document/knots.h"

#include <algorithm>

#include "editor/model/document/field.h"
#include "editor/model/document/model.h"

namespace wrinkle::editor {
namespace {

// Returns the position between those of the neighbours.
double between(const std::vector<double>& positions, size_t index, double position) {
    const double low = index == 0 ? 0 : positions[index - 1];
    const double high = index + 1 == positions.size() ? 1 : positions[index + 1];
    return std::clamp(position, low, std::max(low, high));
}

}  // namespace

RepeatedPorts ramp_ports(const NodeType* type) {
    if (!input_port(type, "factor")) return {};
    return find_repeated(type, "stops",
                         {{"position", PortType::float_}, {"color", PortType::color_}});
}

RepeatedPorts curve_ports(const NodeType* type) {
    if (!input_port(type, "value")) return {};
    return find_repeated(type, "points", {{"point", PortType::vec2_}});
}

bool is_knot_port(const NodeType& type, std::string_view port) {
    if (port.starts_with("position_") || port.starts_with("color_")) return is_ramp(&type);
    return port.starts_with("point_") && is_curve(&type);
}

std::string_view mapped_port(const NodeType& type) {
    return is_ramp(&type) ? "factor" : "value";
}

std::vector<RampStop> stops_of(const Node& node, const NodeType& type) {
    const RepeatedPorts ports = ramp_ports(&type);
    std::vector<RampStop> stops(ports.count_in(node));
    for (size_t i = 0; i < stops.size(); ++i) {
        const auto color = numbers_at(node, ports.port("color", i));
        stops[i].position = numbers_at(node, ports.port("position", i))[0];
        std::copy_n(color.begin(), 3, stops[i].color.begin());
    }
    return stops;
}

std::vector<glm::dvec2> points_of(const Node& node, const NodeType& type) {
    const RepeatedPorts ports = curve_ports(&type);
    std::vector<glm::dvec2> points(ports.count_in(node));
    for (size_t i = 0; i < points.size(); ++i) {
        const auto numbers = numbers_at(node, ports.port("point", i));
        points[i] = {numbers[0], numbers[1]};
    }
    return points;
}

std::vector<double> positions_of(const std::vector<RampStop>& stops) {
    std::vector<double> positions;
    for (const RampStop& stop : stops)
        positions.push_back(stop.position);
    return positions;
}

std::vector<double> positions_of(const std::vector<glm::dvec2>& points) {
    std::vector<double> positions;
    for (const glm::dvec2& point : points)
        positions.push_back(point.x);
    return positions;
}

size_t index_after(const std::vector<double>& positions, double position) {
    const auto next = std::ranges::find_if(positions, [&](double each) { return each > position; });
    return static_cast<size_t>(next - positions.begin());
}

Document with_stop(const Document& document, const Node& node, const NodeType& type,
                   const RampStop& stop) {
    const RepeatedPorts ports = ramp_ports(&type);
    if (ports.count_in(node) >= ports.most()) return document;
    const size_t index = index_after(positions_of(stops_of(node, type)), stop.position);
    const Document result = with_numbers(with_item(document, node, ports, index), node.id,
                                         ports.port("position", index), {stop.position, 0, 0, 0});
    return with_stop_color(result, node, type, index, stop.color);
}

Document with_point(const Document& document, const Node& node, const NodeType& type,
                    glm::dvec2 point) {
    const RepeatedPorts ports = curve_ports(&type);
    if (ports.count_in(node) >= ports.most()) return document;
    const size_t index = index_after(positions_of(points_of(node, type)), point.x);
    return with_numbers(with_item(document, node, ports, index), node.id,
                        ports.port("point", index), {point.x, point.y, 0, 0});
}

Document with_stop_at(const Document& document, const Node& node, const NodeType& type, size_t stop,
                      double position) {
    const double to = between(positions_of(stops_of(node, type)), stop, position);
    return with_numbers(document, node.id, ramp_ports(&type).port("position", stop), {to, 0, 0, 0});
}

Document with_point_at(const Document& document, const Node& node, const NodeType& type,
                       size_t point, glm::dvec2 to) {
    const double x = between(positions_of(points_of(node, type)), point, to.x);
    return with_numbers(document, node.id, curve_ports(&type).port("point", point),
                        {x, to.y, 0, 0});
}

Document with_stop_color(const Document& document, const Node& node, const NodeType& type,
                         size_t stop, const std::array<double, 3>& color) {
    return with_numbers(document, node.id, ramp_ports(&type).port("color", stop),
                        {color[0], color[1], color[2], 0});
}

}  // namespace wrinkle::editor
