#include "cli/exposed.h"

#include "base/printable.h"
#include "base/text.h"
#include "graph/subgraph.h"
#include "json/write.h"
#include "registry/reference.h"

namespace wrinkle::cli {
namespace {

// Returns the default as JSON; "" if the input has none.
std::string default_of(const GraphInput& input, const Port& port) {
    if (port.is_value() && lanes_of(port.type) > 0) return default_json(port);
    const bool absent = input.default_value.is(json::Kind::null);
    return absent ? "" : json::one_line(input.default_value);
}

std::string input_json(const GraphInput& input, const Port& port) {
    std::string text = "{\"name\": " + json_quoted(input.name);
    const auto add = [&](const char* key, const std::string& json) {
        if (!json.empty()) text += ", " + json_quoted(key) + ": " + json;
    };
    const auto add_text = [&](const char* key, const std::string& word) {
        if (!word.empty()) add(key, json_quoted(word));
    };
    add_text("type", input.type);
    add("default", default_of(input, port));
    if (!port.choices.empty()) add("choices", json::string_array(port.choices));
    if (port.has_soft_range()) add("slider", range_json(port.soft_min, port.soft_max));
    if (port.has_hard_range()) add("limits", range_json(port.hard_min, port.hard_max));
    if (!input.step.is(json::Kind::null)) add("step", json::one_line(input.step));
    add_text("unit", port.unit);
    add_text("label", input.label);
    add_text("group", input.group);
    add_text("widget", input.widget);
    add_text("when", input.when);
    add_text("doc", port.doc);
    add("built_in", port.is_option() ? "true" : "false");
    return text + "}";
}

std::string preset_json(const Preset& preset) {
    const auto member = [](const Extra& value) {
        return json_quoted(value.key) + ": " + json::one_line(value.value);
    };
    return "\n    {\"name\": " + json_quoted(preset.name) + ", \"inputs\": {" +
           joined(preset.values, ", ", member) + "}}";
}

std::string details(const GraphInput& input, const Port& port) {
    std::vector<std::string> parts;
    const auto add = [&](const std::string& part) {
        if (!part.empty()) parts.push_back(part);
    };
    const auto range = [](double least, double most) {
        return shortest(least) + " to " + shortest(most);
    };
    if (!input.label.empty()) add(json_quoted(input.label));
    if (!input.group.empty()) add("group " + json_quoted(input.group));
    add(port.unit);
    add(joined(port.choices, " | "));
    if (port.has_soft_range()) add("slider " + range(port.soft_min, port.soft_max));
    if (port.has_hard_range()) add(range(port.hard_min, port.hard_max));
    if (!input.when.empty()) add("when " + input.when);
    if (port.is_option()) add("built in");
    return parts.empty() ? "" : "(" + joined(parts, ", ") + ")";
}

}  // namespace

std::string exposed_json(const Project& project, const Types& types) {
    std::string inputs;
    const Document& top = project.top();
    for (size_t i = 0; i < top.inputs.size(); ++i)
        inputs += (i ? ",\n    " : "\n    ") + input_json(top.inputs[i], types.graph_input(0, i));
    return "\"exposed\": [" + inputs + "], \"presets\": [" + joined(top.presets, ",", preset_json) +
           "]";
}

std::string exposed_text(const Project& project, const Types& types) {
    std::string text;
    const Document& top = project.top();
    for (size_t i = 0; i < top.inputs.size(); ++i) {
        const GraphInput& input = top.inputs[i];
        const Port& port = types.graph_input(0, i);
        std::string line = "    " + padded(input.name, 16) + " " + padded(input.type, 7) + " " +
                           padded(default_of(input, port), 12);
        for (const std::string& part : {port.doc, details(input, port)})
            if (!part.empty()) line += " " + part;
        text += printable(line.substr(0, line.find_last_not_of(' ') + 1)) + "\n";
    }
    if (!top.presets.empty()) text += "presets\n";
    for (const Preset& preset : top.presets) {
        const auto value = [](const Extra& each) {
            return each.key + "=" + json::one_line(each.value);
        };
        text +=
            printable("    " + padded(preset.name, 16) + " " + joined(preset.values, ", ", value)) +
            "\n";
    }
    return text;
}

}  // namespace wrinkle::cli
