// Checks of the keys of a graph input against its type and the other inputs.
#include <algorithm>
#include <array>
#include <unordered_map>

#include "base/text.h"
#include "graph/condition.h"
#include "graph/document.h"
#include "graph/renamed.h"
#include "lower/check.h"
#include "lower/literal.h"

namespace wrinkle {
namespace {

constexpr std::array<std::string_view, 8> widgets = {"slider", "number",   "angle", "seed",
                                                     "color",  "position", "ramp",  "curve"};

class KeyChecker {
public:
    KeyChecker(const Document& document, const GraphInput& input, Diagnostics& diagnostics)
        : document_(document), input_(input), diagnostics_(diagnostics) {}

    void numeric_keys(const Port& port) const {
        const bool is_number = port.is_value() && lanes_of(port.type) > 0;
        if (port.kind == Port::Kind::count || (is_number && port.type != PortType::normal_)) return;
        for (const std::string_view key : {"slider", "limits", "step"})
            if (is_present(key))
                report(key, "does not fit the type " + input_.type,
                       "float, vec2, vec3, vec4, color, height and count have it");
    }

    void choices(const Port& port) const {
        if (port.kind != Port::Kind::choice && is_present("choices"))
            report("choices", "does not fit the type " + input_.type, "choice has it");
    }

    void widget() const {
        const std::vector<std::string> names(widgets.begin(), widgets.end());
        if (input_.widget.empty() || std::ranges::count(names, input_.widget) > 0) return;
        report("widget", "is " + json_quoted(input_.widget) + ", which this program does not have",
               did_you_mean(input_.widget, names, "expected " + one_of(names)), Severity::warning);
    }

    void group() const {
        const auto is_empty = [](std::string_view part) { return trimmed(part).empty(); };
        if (!input_.group.empty() && std::ranges::any_of(split(input_.group, '/'), is_empty))
            report("group", "has an empty part", "expected \"Wear\" or \"Wear/Edges\"");
    }

    void when() const {
        if (input_.when.empty()) return;
        const auto condition = parse_condition(input_.when);
        if (!condition)
            return report("when", "is " + json_quoted(input_.when) + ", which is not a condition",
                          "expected \"input.NAME\", \"!input.NAME\" or \"input.NAME > 0\"");
        if (document_.inputs.find(condition->input)) return;
        const std::vector<std::string> names = keys_of(document_.inputs);
        const std::string current(FormerNames(document_.inputs).current(condition->input));
        report("when", "names the input '" + condition->input + "', which does not exist",
               current.empty()
                   ? did_you_mean(condition->input, names, "the graph has " + joined(names, ", "))
                   : "it is called '" + current + "' now");
    }

private:
    bool is_present(std::string_view key) const {
        return std::ranges::count(present_keys(input_), key, &Extra::key) > 0;
    }
    void report(std::string_view key, const std::string& what, std::string expected,
                Severity severity = Severity::error) const {
        Diagnostic problem =
            diagnose_key(document_, input_, key, RuleId::input_key,
                         "input '" + input_.name + "': \"" + std::string(key) + "\" " + what,
                         std::move(expected));
        problem.severity = severity;
        diagnostics_.add(std::move(problem));
    }

    const Document& document_;
    const GraphInput& input_;
    Diagnostics& diagnostics_;
};

// Located at the name if it is part of the text as read, else at the input.
Diagnostic diagnose_former(const Document& document, const GraphInput& input,
                           const json::Value& former, const std::string& what,
                           const std::string& remedy) {
    const std::string message = "input '" + input.name + "': \"renamed\" has '" +
                                std::string(former.as_string()) + "', which is " + what;
    return former.has_location()
               ? diagnose(former, "", RuleId::former_name, message, remedy)
               : diagnose_key(document, input, "renamed", RuleId::former_name, message, remedy);
}

}  // namespace

void check_keys(const Document& document, const GraphInput& input, const Port& port,
                Diagnostics& diagnostics) {
    const KeyChecker checker(document, input, diagnostics);
    checker.numeric_keys(port);
    checker.choices(port);
    checker.widget();
    checker.group();
    checker.when();
}

void check_renamed(const Document& document, Diagnostics& diagnostics) {
    std::unordered_map<std::string_view, std::string_view> owners;
    for (const GraphInput& input : document.inputs)
        for (const json::Member& former : input.renamed.children()) {
            const std::string_view name = former.value.as_string();
            const auto [owner, is_new] = owners.emplace(name, input.name);
            std::string what, remedy = "remove it from \"renamed\"";
            if (name == input.name)
                what = "its present name";
            else if (document.inputs.find(name))
                what = "the name of another input", remedy += ", or give that input another name";
            else if (!is_new)
                what = "also a former name of '" + std::string(owner->second) + "'",
                remedy = set_once;
            else
                continue;
            diagnostics.add(diagnose_former(document, input, former.value, what, remedy));
        }
}

std::string set_twice(std::string_view name, const Table<GraphInput>& inputs) {
    const std::string current(FormerNames(inputs).current(name));
    return current.empty() ? "" : "is a former name of '" + current + "', which is set too";
}

}  // namespace wrinkle
