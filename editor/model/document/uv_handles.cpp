#include "editor/model/document/uv_handles.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "editor/model/document/field.h"
#include "editor/model/document/model.h"

namespace wrinkle::editor {
namespace {

constexpr double grid = 0.05, degree_step = 15;

glm::dvec2 turned(glm::dvec2 v, double degrees) {
    const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

// The ports of a node that have handles, and their values.
struct Placement {
    const Node& node;
    const NodeType& type;
    const Port* center = free_port("center", PortType::vec2_);
    const Port* box = relative_port("size", PortType::vec2_);
    const Port* distance = find_distance();
    const Port* angle = find_angle();

    bool has_wire(std::string_view name) const {
        const Input* input = node.find(name);
        return input && input->kind != Input::Kind::literal;
    }
    const Port* free_port(std::string_view name, PortType of) const {
        const Port* port = input_port(&type, name);
        return port && port->is_value() && port->type == of && !has_wire(name) ? port : nullptr;
    }
    // A port with a handle that is relative to the center and turns.
    const Port* relative_port(std::string_view name, PortType of) const {
        return center && !has_wire("rotation") ? free_port(name, of) : nullptr;
    }
    const Port* find_distance() const {
        if (const Port* size = input_port(&type, "size"); size && size->type == PortType::vec2_)
            return nullptr;
        const Port* size = relative_port("size", PortType::float_);
        return size ? size : relative_port("radius", PortType::float_);
    }
    const Port* find_angle() const {
        for (const std::string_view name : {"rotation", "angle"}) {
            const Port* port = center ? input_port(&type, name) : nullptr;
            if (port && port->unit == "deg") return free_port(name, PortType::float_);
        }
        return nullptr;
    }

    glm::dvec2 point(const Port& port) const {
        const auto numbers = numbers_at(node, port);
        return {numbers[0], numbers[1]};
    }
    double number(const Port& port) const { return numbers_at(node, port)[0]; }
    glm::dvec2 middle() const { return center ? point(*center) : glm::dvec2(0); }
    double rotation() const {
        const Port* port = free_port("rotation", PortType::float_);
        return port ? number(*port) : 0;
    }
    glm::dvec2 placed(glm::dvec2 local) const { return middle() + turned(local, rotation()); }
    // Distance of the handle of the angle from the center.
    double arm() const {
        const double extent = box ? point(*box).y / 2 : distance ? number(*distance) : 0.2;
        return std::fabs(extent) * 1.25 + 0.02;
    }
};

bool reads_surface_uv(const Node& node, const NodeType& type) {
    const Input* uv = node.find("uv");
    return input_port(&type, "uv") &&
           (!uv || uv->kind == Input::Kind::literal || uv->link.is_surface());
}

double to_grid(double value, double step, bool snaps) {
    return snaps ? std::round(value / step) * step : value;
}

double angle_at(const Placement& placement, glm::dvec2 to, bool snaps) {
    const double before = placement.number(*placement.angle);
    const glm::dvec2 arm = to - placement.middle();
    if (arm == glm::dvec2(0)) return before;
    const double wanted = glm::degrees(std::atan2(arm.y, arm.x)) - 90;
    return to_grid(before + std::remainder(wanted - before, 360), degree_step, snaps);
}

}  // namespace

std::vector<UvHandle> uv_handles(const Node& node, const NodeType& type) {
    if (!reads_surface_uv(node, type)) return {};
    const Placement placement{node, type};
    using Kind = UvHandle::Kind;
    std::vector<UvHandle> handles;
    for (const std::string_view name : {"center", "a", "b"})
        if (const Port* port = placement.free_port(name, PortType::vec2_))
            handles.push_back({Kind::point, port->name, placement.point(*port)});
    if (const Port* box = placement.box)
        handles.push_back({Kind::corner, box->name, placement.placed(placement.point(*box) * 0.5)});
    if (const Port* distance = placement.distance)
        handles.push_back(
            {Kind::distance, distance->name, placement.placed({placement.number(*distance), 0})});
    if (const Port* angle = placement.angle) {
        const glm::dvec2 arm = turned({0, placement.arm()}, placement.number(*angle));
        handles.push_back({Kind::angle, angle->name, placement.middle() + arm});
    }
    return handles;
}

Document with_handle_at(const Document& document, const Node& node, const NodeType& type,
                        std::string_view port, glm::dvec2 to, bool snaps) {
    const Placement placement{node, type};
    const auto with = [&](const Document& before, const Port& set, int lane, double value) {
        return with_number(before, node.id, set, lane, value);
    };
    const auto with_point = [&](const Port& set, glm::dvec2 point) {
        return with(with(document, set, 0, to_grid(point.x, grid, snaps)), set, 1,
                    to_grid(point.y, grid, snaps));
    };
    const glm::dvec2 local = turned(to - placement.middle(), -placement.rotation());
    const auto is = [&](const Port* each) { return each && each->name == port; };
    if (is(placement.box)) return with_point(*placement.box, glm::abs(local) * 2.0);
    if (is(placement.distance))
        return with(document, *placement.distance, 0, to_grid(glm::length(local), grid, snaps));
    if (is(placement.angle))
        return with(document, *placement.angle, 0, angle_at(placement, to, snaps));
    const Port* point = placement.free_port(port, PortType::vec2_);
    return point ? with_point(*point, to) : document;
}

std::vector<glm::dvec2> box_of_handles(const Node& node, const NodeType& type) {
    const Placement placement{node, type};
    if (!placement.box || !reads_surface_uv(node, type)) return {};
    const glm::dvec2 half = placement.point(*placement.box) * 0.5;
    return {placement.placed(half), placement.placed({-half.x, half.y}), placement.placed(-half),
            placement.placed({half.x, -half.y})};
}

}  // namespace wrinkle::editor
