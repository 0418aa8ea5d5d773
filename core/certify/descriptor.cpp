#include <algorithm>
#include <cctype>
#include <functional>

#include "base/text.h"
#include "certify/checks.h"

namespace wrinkle::certify {
namespace {

bool mentions(const std::string& doc, std::initializer_list<std::string_view> words) {
    const std::string lower = lower_case(doc);
    return std::ranges::any_of(
        words, [&](std::string_view word) { return lower.find(word) != lower.npos; });
}

bool is_angle(const Port& port) {
    return port.name == "angle" || port.name.ends_with("_angle") || port.name == "rotation";
}

using Fault = std::function<void(std::string message, std::string remedy)>;

void check_texts(const Port& port, const Fault& fault) {
    if (!is_name(port.name)) fault("its name is not lower_snake_case", "letters a-z, digits and _");
    if (port.kind == Port::Kind::choice && port.choices.size() < 2)
        fault("a choice of one", "give it two names, or remove it");
    if (port.doc.size() < 2)
        fault("it has no doc line", "say in one line what it is, with its unit");
    else if (port.doc == port.name)
        fault("its doc line only repeats its name", "say what it is, with its unit");
}

void check_unit(const Port& port, const Fault& fault) {
    if (port.is_option() || !port.unit.empty()) return;
    if (port.type == PortType::height_ && !mentions(port.doc, {"length unit"}))
        fault("a height without a unit", R"(unit("m"), or "length units" in its doc line)");
    if (port.type == PortType::float_ && is_angle(port) &&
        !mentions(port.doc, {"degree", "radian", "turn"}))
        fault("an angle without a unit",
              R"(unit("deg") or unit("rad"), or the word in its doc line)");
}

void check_ranges(const Port& port, const Fault& fault) {
    const auto range = [](double low, double high) {
        return shortest(low) + " to " + shortest(high);
    };
    if (port.soft_min > port.soft_max || port.hard_min > port.hard_max)
        return fault("a range ends before it begins", "the lower end first");
    if (!port.has_hard_range()) return;
    if (port.has_soft_range() && (port.soft_min < port.hard_min || port.soft_max > port.hard_max))
        fault("its slider goes from " + range(port.soft_min, port.soft_max) +
                  ", outside its limits " + range(port.hard_min, port.hard_max),
              "values outside are clamped: end the slider there");
    const double value = port.default_value[0];
    if (port.default_kind == Port::Default::constant &&
        (value < port.hard_min || value > port.hard_max))
        fault("its default " + shortest(value) + " is outside its limits " +
                  range(port.hard_min, port.hard_max),
              "a default within them");
}

}  // namespace

void check_descriptor(const NodeType& type, Report& report) {
    const auto fault = [&](std::string message, std::string remedy) {
        report.add({"descriptor", "", std::move(message), std::move(remedy), {}});
    };
    if (!is_name(type.id)) fault("its id is not lower_snake_case", "letters a-z, digits and _");
    if (type.title.empty()) fault("it has no title", "its name in the palette");
    if (type.family.empty()) fault("it has no family", "its category in the palette");
    if (type.doc.empty() || !type.doc.ends_with('.'))
        fault("its doc is not a sentence: " + json_quoted(type.doc),
              "one or two sentences that end with a full stop");
    const auto is_output = [](const Port& port) { return port.kind == Port::Kind::output; };
    if (std::ranges::none_of(type.ports, is_output))
        fault("it has no output", "declare one with .out<T>()");
    for (const Port& port : type.ports)
        for (const auto check : {check_texts, check_unit, check_ranges})
            check(port, [&](std::string message, std::string remedy) {
                report.add({"descriptor", port.name, std::move(message), std::move(remedy), {}});
            });
}

}  // namespace wrinkle::certify
