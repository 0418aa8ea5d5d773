#include "lower/override.h"

#include <array>
#include <charconv>
#include <cmath>

#include "base/text.h"
#include "graph/edit.h"
#include "graph/renamed.h"
#include "json/parse.h"
#include "lower/literal.h"
#include "lower/types.h"

namespace wrinkle {
namespace {

using json::Kind;

constexpr uint32_t max_sweep = 10'000;

bool to_number(std::string_view text, double& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
}

// Returns the values of "A:B:N"; an empty list if the text is not a sweep, one null if it is an
// invalid one.
std::vector<json::Value> sweep(std::string_view text) {
    const std::vector<std::string_view> parts = split(text, ':');
    double first = 0, last = 0, count = 0;
    if (parts.size() != 3 || !to_number(parts[0], first) || !to_number(parts[1], last)) return {};
    if (!to_number(parts[2], count) || count < 2 || count > max_sweep ||
        count != static_cast<uint32_t>(count))
        return {json::Value{}};
    std::vector<json::Value> values;
    const auto steps = static_cast<uint32_t>(count) - 1;
    for (uint32_t i = 0; i <= steps; ++i) {
        const double product = (last - first) * i;  // product first: 1:2:11 has 1.3, not 1.2999...
        const double value = std::isfinite(product)
                                 ? first + product / steps
                                 : std::lerp(first, last, static_cast<double>(i) / steps);
        values.push_back(json::Value::number(i == steps ? last : value));
    }
    return values;
}

// JSON, or a bare word as a string.
json::Value parse_value(std::string_view text) {
    Diagnostics ignored;
    const json::Parsed parsed = json::parse(std::string(text), "--set", ignored);
    return parsed.complete && !ignored.has_errors() ? parsed.root : json::Value::string(text);
}

// Returns the value without the location where it was read, because it is not in a file.
json::Value detached(const json::Value& value) {
    switch (value.kind()) {
        case Kind::boolean:
            return json::Value::boolean(value.as_boolean());
        case Kind::number:
            return json::Value::number(value.as_number());
        case Kind::string:
            return json::Value::string(value.as_string());
        default:
            return value;
    }
}

// Returns "; type tile.scale=[0.5,0.5]" for a vector given in another form, or as one number.
std::string array_to_type(const Override& change, const Port& port) {
    const size_t equals = change.text.find('=');
    const auto lanes = static_cast<size_t>(port.is_value() ? lanes_of(port.type) : 0);
    std::vector<std::string> numbers;
    for (std::string_view part : split(std::string_view(change.text).substr(equals + 1), ',')) {
        constexpr std::string_view around = " ()[]{}";
        part.remove_prefix(std::min(part.find_first_not_of(around), part.size()));
        part = part.substr(0, part.find_last_not_of(around) + 1);
        double number = 0;
        if (!to_number(part, number)) return {};
        numbers.emplace_back(part);
    }
    if (numbers.size() == 1) numbers.resize(lanes, numbers[0]);
    if (lanes < 2 || numbers.size() != lanes) return {};
    std::string array;
    for (const std::string& number : numbers)
        array += (array.empty() ? "[" : ",") + number;
    return "; type " + change.text.substr(0, equals) + "=" + array + "]";
}

// Returns the current name of an input that may be called by a former one.
std::string input_name(const Document& document, const std::string& name) {
    const std::string current(FormerNames(document.inputs).current(name));
    return current.empty() ? name : current;
}

struct Applier {
    Project project;
    const Registry& registry;
    Diagnostics& diagnostics;

    void apply(const Override& change, size_t run) {
        const json::Value& value = change.values[change.is_sweep() ? run : 0];
        if (change.target.is_input())
            graph_input(change, value);
        else
            port(change, value);
    }

    Document& document() { return project.files[0].document; }

    void refuse(const Override& change, const std::string& message, std::string expected) {
        diagnostics.error(RuleId::option, "--set " + change.text + ": " + message,
                          std::move(expected));
    }

    bool fits(const Override& change, const json::Value& value, const Port& port) {
        bool fine = true;
        for (const LiteralProblem& problem : literal_problems(value, port)) {
            if (problem.severity == Severity::warning) continue;
            refuse(change, "the value " + problem.message,
                   problem.expected + array_to_type(change, port));
            fine = false;
        }
        return fine;
    }

    void graph_input(const Override& change, const json::Value& value) {
        const std::string name = input_name(document(), change.target.port);
        const size_t index = document().inputs.index_of(name);
        if (index == Table<GraphInput>::npos)
            return refuse(change, "the graph has no input '" + change.target.port + "'",
                          did_you_mean(change.target.port, keys_of(document().inputs)));
        if (!fits(change, value, Types(project, registry).graph_input(0, index))) return;
        GraphInput changed = document().inputs[index];
        changed.default_value = value;
        document() = set_graph_input(document(), std::move(changed));
    }

    void port(const Override& change, const json::Value& value) {
        const Link& target = change.target;
        const size_t index = document().nodes.index_of(target.node);
        if (index == Table<NodePtr>::npos)
            return refuse(change, "there is no node '" + target.node + "'",
                          did_you_mean(target.node, keys_of(document().nodes)));
        const Types types(project, registry);  // owner of the types of sub-graphs
        const NodeType* type = types.of(0, index);
        if (!type) return;  // check() names the unknown type
        const Project::File* inner = project.subgraph(0, target.node);
        const std::string name = inner ? input_name(inner->document, target.port) : target.port;
        const uint32_t found = type->find_input(name);
        if (found == NodeType::none)
            return refuse(change, "node '" + target.node + "' has no port '" + target.port + "'",
                          did_you_mean(target.port, port_names(*type, false)));
        if (fits(change, value, type->ports[found]))
            document() = set_value(document(), target.node, name, value);
    }
};

}  // namespace

std::optional<Override> parse_override(std::string_view text, Diagnostics& diagnostics) {
    const auto refuse = [&](std::string message, std::string expected) {
        diagnostics.error(RuleId::option, "--set " + std::string(text) + ": " + message,
                          std::move(expected));
        return std::nullopt;
    };
    const size_t equals = text.find('=');
    const size_t dot = text.substr(0, equals).rfind('.');
    if (equals == text.npos || dot == text.npos || dot == 0 || dot + 1 == equals)
        return refuse("this sets nothing", "expected NODE.PORT=VALUE or input.NAME=VALUE");
    Override result;
    result.text = text;
    result.target.node = text.substr(0, dot);
    result.target.port = text.substr(dot + 1, equals - dot - 1);
    const std::string_view value = text.substr(equals + 1);
    if (value.empty()) return refuse("the value is empty", "expected JSON or a word");
    if (!is_utf8(value)) return refuse("the value is not valid UTF-8", "");
    result.values = sweep(value);
    if (result.values.empty()) result.values.push_back(detached(parse_value(value)));
    if (result.values.size() == 1 && result.values[0].is(Kind::null))
        return refuse("the value is neither JSON nor a sweep",
                      "a sweep is A:B:N, N from 2 to " + std::to_string(max_sweep));
    return result;
}

Project with_overrides(const Project& project, const Registry& registry,
                       std::span<const Override> overrides, size_t run, Diagnostics& diagnostics) {
    Applier applier{project, registry, diagnostics};
    for (const Override& change : overrides)
        applier.apply(change, run);
    return std::move(applier.project);
}

}  // namespace wrinkle
