#include <algorithm>
#include <cctype>

#include "base/text.h"
#include "certify/checks.h"

namespace wrinkle::certify {
namespace {

bool mentions(const std::string& doc, std::initializer_list<std::string_view> words) {
    std::string lower = doc;
    for (char& c : lower)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return lower.find(word) != lower.npos; });
}

bool is_angle(const Port& port) {
    return port.name == "angle" || port.name.ends_with("_angle") || port.name == "rotation";
}

// Checks one port of a node.
class PortCheck {
public:
    PortCheck(const Port& port, Report& report) : port_(port), report_(report) {}

    void run() {
        names();
        doc();
        if (!port_.is_option()) unit();
        ranges();
    }

private:
    void fault(std::string message, std::string remedy) {
        report_.add({"descriptor", port_.name, std::move(message), std::move(remedy), {}});
    }

    void names() {
        if (!is_name(port_.name))
            fault("its name is not lower_snake_case", "letters a-z, digits and _");
        if (port_.kind == Port::Kind::choice && port_.choices.size() < 2)
            fault("a choice of one", "give it two names, or remove it");
    }

    void doc() {
        if (port_.doc.size() < 2)
            fault("it has no doc line", "say in one line what it is, with its unit");
        else if (port_.doc == port_.name)
            fault("its doc line only repeats its name", "say what it is, with its unit");
    }

    void unit() {
        if (!port_.unit.empty()) return;
        if (port_.type == PortType::height_ && !mentions(port_.doc, {"length unit"}))
            fault("a height without a unit", R"(unit("m"), or "length units" in its doc line)");
        if (port_.type == PortType::float_ && is_angle(port_) &&
            !mentions(port_.doc, {"degree", "radian", "turn"}))
            fault("an angle without a unit",
                  R"(unit("deg") or unit("rad"), or the word in its doc line)");
    }

    void ranges() {
        const auto range = [](double low, double high) {
            return shortest(low) + " to " + shortest(high);
        };
        if (port_.soft_min > port_.soft_max || port_.hard_min > port_.hard_max)
            return fault("a range ends before it begins", "the lower end first");
        if (!port_.has_hard_range()) return;
        if (port_.has_soft_range() &&
            (port_.soft_min < port_.hard_min || port_.soft_max > port_.hard_max))
            fault("its slider goes from " + range(port_.soft_min, port_.soft_max) +
                      ", outside its limits " + range(port_.hard_min, port_.hard_max),
                  "what lies outside is clamped: make the slider end there");
        const double value = port_.default_value[0];
        if (port_.default_kind == Port::Default::constant &&
            (value < port_.hard_min || value > port_.hard_max))
            fault("its default " + shortest(value) + " is outside its limits " +
                      range(port_.hard_min, port_.hard_max),
                  "a default within them");
    }

    const Port& port_;
    Report& report_;
};

}  // namespace

void check_descriptor(const NodeType& type, Report& report) {
    const auto fault = [&](std::string message, std::string remedy) {
        report.add({"descriptor", "", std::move(message), std::move(remedy), {}});
    };
    if (!is_name(type.id)) fault("its id is not lower_snake_case", "letters a-z, digits and _");
    if (type.title.empty()) fault("it has no title", "what a user reads in the palette");
    if (type.family.empty()) fault("it has no family", "where it stands in the palette");
    if (type.doc.empty() || !type.doc.ends_with('.'))
        fault("its doc is no sentence: " + json_quoted(type.doc),
              "one or two sentences that end with a full stop");
    const auto is_output = [](const Port& port) { return port.kind == Port::Kind::output; };
    if (std::none_of(type.ports.begin(), type.ports.end(), is_output))
        fault("it has no output", "declare one with .out<T>()");
    for (const Port& port : type.ports)
        PortCheck(port, report).run();
}

}  // namespace wrinkle::certify
