#include "registry/reference.h"

#include <cmath>
#include <span>

#include "base/text.h"
#include "json/write.h"

namespace wrinkle {
namespace {

void append(std::string& text, const std::string& detail) {
    if (!detail.empty()) text += (text.empty() ? "" : ", ") + detail;
}

std::string range_text(double least, double most) {
    if (!std::isfinite(least)) return "at most " + shortest(most);
    if (!std::isfinite(most)) return "at least " + shortest(least);
    return shortest(least) + " to " + shortest(most);
}

// Returns the link to the default, or to the domain of a field: "surface.uv0".
std::string surface_link(const Port& port) {
    return "surface." + std::string(surface_properties()[port.default_surface].name);
}

}  // namespace

std::string range_json(double least, double most) {
    const auto end = [](double x) { return std::isfinite(x) ? shortest(x) : std::string("null"); };
    return "[" + end(least) + ", " + end(most) + "]";
}

std::string_view kind_word(Port::Kind kind) {
    constexpr std::string_view words[] = {"input", "output", "choice", "count", "flag", "field"};
    return words[static_cast<size_t>(kind) - 1];
}

std::string kind_text(const Port& port) {
    if (port.is_option()) return std::string(kind_word(port.kind));
    const std::string type(name_of(port.type));
    return port.kind == Port::Kind::field ? "field of " + type : type;
}

std::string default_json(const Port& port) {
    if (port.default_kind == Port::Default::none || port.kind == Port::Kind::output) return "";
    if (port.default_kind == Port::Default::surface)
        return "{\"from\": " + json_quoted(surface_link(port)) + "}";
    if (port.is_value() && lanes_of(port.type) == 0) return "";
    const double first = port.default_value[0];
    if (port.kind == Port::Kind::choice)
        return json_quoted(port.choices[static_cast<size_t>(first)]);
    if (port.kind == Port::Kind::flag) return first != 0 ? "true" : "false";
    if (port.kind == Port::Kind::count || lanes_of(port.type) == 1) return shortest(first);
    const std::span lanes(port.default_value.data(), static_cast<size_t>(lanes_of(port.type)));
    return "[" + joined(lanes, ", ", [](double lane) { return shortest(lane); }) + "]";
}

std::string details_text(const Port& port) {
    std::string text;
    append(text, port.unit);
    append(text, joined(port.choices, " | "));
    if (port.kind == Port::Kind::output) return text;
    if (port.default_kind == Port::Default::surface)
        append(text, "default " + surface_link(port));
    else if (port.default_kind == Port::Default::constant)
        append(text, "default " + default_json(port));
    else if (port.default_kind == Port::Default::absent)
        append(text, "absent");
    else if (port.is_required())
        append(text, "required");
    if (port.has_hard_range()) append(text, range_text(port.hard_min, port.hard_max));
    if (port.is_value() && port.type == PortType::image_)
        append(text, "a bare path is " + std::string(name_of(port.encoding)));
    return text;
}

std::string port_json(const Port& port) {
    std::string text =
        "{\"name\": " + json_quoted(port.name) + ", \"kind\": " + json_quoted(kind_word(port.kind));
    if (!port.is_option()) text += ", \"type\": " + json_quoted(name_of(port.type));
    text += ", \"doc\": " + json_quoted(port.doc);
    if (!port.unit.empty()) text += ", \"unit\": " + json_quoted(port.unit);
    const std::string value = default_json(port);
    if (!value.empty()) text += ", \"default\": " + value;
    if (port.default_kind == Port::Default::absent) text += ", \"absent\": true";
    if (port.is_required()) text += ", \"required\": true";
    if (port.has_soft_range()) text += ", \"slider\": " + range_json(port.soft_min, port.soft_max);
    if (port.has_hard_range()) text += ", \"range\": " + range_json(port.hard_min, port.hard_max);
    if (port.kind == Port::Kind::field) text += ", \"domain\": " + json_quoted(surface_link(port));
    if (!port.choices.empty()) text += ", \"choices\": " + json::string_array(port.choices);
    if (port.is_value() && port.type == PortType::image_)
        text += ", \"encoding\": " + json_quoted(name_of(port.encoding));
    return text + "}";
}

}  // namespace wrinkle
