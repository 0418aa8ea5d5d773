#include "editor/model/document/ramp.h"

#include <algorithm>

#include "editor/model/document/field.h"
#include "editor/model/document/model.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

const Port* count_port(const NodeType& type) {
    const Port* port = input_port(&type, "stops");
    return port && port->kind == Port::Kind::count ? port : nullptr;
}

Document with_numbers(Document document, const std::string& node, const Port& port,
                      const std::array<double, 4>& numbers) {
    for (int lane = 0; lane < lanes_of_field(port); ++lane)
        document = with_number(document, node, port, lane, numbers[static_cast<size_t>(lane)]);
    return document;
}

// Gives the port `to` the wire or the value of the port `from` of `node`.
Document with_moved(const Document& document, const Node& node, const NodeType& type,
                    const std::string& from, const std::string& to) {
    const Input* input = node.find(from);
    if (input && input->kind == Input::Kind::link)
        return connect(document, input->link, node.id, to);
    return with_numbers(reset_value(document, node.id, to), node.id, *input_port(&type, to),
                        numbers_at(node, *input_port(&type, from)));
}

Document with_stop_moved(const Document& document, const Node& node, const NodeType& type,
                         size_t from, size_t to) {
    return with_moved(with_moved(document, node, type, position_port(from), position_port(to)),
                      node, type, color_port(from), color_port(to));
}

Document with_stop_reset(const Document& document, const Node& node, size_t stop) {
    return reset_value(reset_value(document, node.id, position_port(stop)), node.id,
                       color_port(stop));
}

Document with_count(const Document& document, const Node& node, const NodeType& type,
                    size_t count) {
    return with_number(document, node.id, *count_port(type), 0, static_cast<double>(count));
}

}  // namespace

std::string position_port(size_t stop) {
    return "position_" + std::to_string(stop + 1);
}

std::string color_port(size_t stop) {
    return "color_" + std::to_string(stop + 1);
}

bool is_ramp(const NodeType* type) {
    if (!type || !count_port(*type) || !input_port(type, "factor")) return false;
    for (size_t i = 0; i < max_stops(*type); ++i) {
        const Port* position = input_port(type, position_port(i));
        const Port* color = input_port(type, color_port(i));
        if (!position || position->type != PortType::float_) return false;
        if (!color || color->type != PortType::color_) return false;
    }
    return true;
}

bool is_stop_port(const NodeType& type, std::string_view port) {
    return is_ramp(&type) && (port.starts_with("position_") || port.starts_with("color_"));
}

size_t max_stops(const NodeType& type) {
    return static_cast<size_t>(count_port(type)->hard_max);
}

std::vector<RampStop> stops_of(const Node& node, const NodeType& type) {
    std::vector<RampStop> stops(static_cast<size_t>(numbers_at(node, *count_port(type))[0]));
    for (size_t i = 0; i < stops.size(); ++i) {
        const auto color = numbers_at(node, *input_port(&type, color_port(i)));
        stops[i].position = numbers_at(node, *input_port(&type, position_port(i)))[0];
        std::copy_n(color.begin(), 3, stops[i].color.begin());
    }
    return stops;
}

size_t index_of_stop(const std::vector<RampStop>& stops, double position) {
    const auto next =
        std::ranges::find_if(stops, [&](const RampStop& each) { return each.position > position; });
    return static_cast<size_t>(next - stops.begin());
}

Document with_stop(const Document& document, const Node& node, const NodeType& type,
                   const RampStop& stop) {
    const std::vector<RampStop> stops = stops_of(node, type);
    if (stops.size() >= max_stops(type)) return document;
    const size_t index = index_of_stop(stops, stop.position);
    Document result = with_count(document, node, type, stops.size() + 1);
    for (size_t i = stops.size(); i-- > index;)
        result = with_stop_moved(result, node, type, i, i + 1);
    result = with_stop_reset(result, node, index);
    result = with_numbers(result, node.id, *input_port(&type, position_port(index)),
                          {stop.position, 0, 0, 0});
    return with_stop_color(result, node, type, index, stop.color);
}

Document without_stop(const Document& document, const Node& node, const NodeType& type,
                      size_t stop) {
    const size_t count = stops_of(node, type).size();
    if (stop >= count || static_cast<double>(count) <= count_port(type)->hard_min) return document;
    Document result = document;
    for (size_t i = stop; i + 1 < count; ++i)
        result = with_stop_moved(result, node, type, i + 1, i);
    return with_count(with_stop_reset(result, node, count - 1), node, type, count - 1);
}

Document with_stop_at(const Document& document, const Node& node, const NodeType& type, size_t stop,
                      double position) {
    const std::vector<RampStop> stops = stops_of(node, type);
    const double low = stop == 0 ? 0 : stops[stop - 1].position;
    const double high = stop + 1 == stops.size() ? 1 : stops[stop + 1].position;
    return with_number(document, node.id, *input_port(&type, position_port(stop)), 0,
                       std::clamp(position, low, std::max(low, high)));
}

Document with_stop_color(const Document& document, const Node& node, const NodeType& type,
                         size_t stop, const std::array<double, 3>& color) {
    return with_numbers(document, node.id, *input_port(&type, color_port(stop)),
                        {color[0], color[1], color[2], 0});
}

}  // namespace wrinkle::editor
