#include "cli/exposed.h"

#include "base/printable.h"
#include "base/text.h"
#include "graph/subgraph.h"
#include "json/write.h"
#include "lower/exposed.h"
#include "registry/reference.h"

namespace wrinkle::cli {
namespace {

std::string preset_json(const Preset& preset) {
    const auto member = [](const auto& value) {
        return json_quoted(value.first) + ": " + value.second;
    };
    return "\n    {\"name\": " + json_quoted(preset.name) + ", \"inputs\": {" +
           joined(preset_values(preset), ", ", member) + "}}";
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
    const auto quoted = [](const json::Member& name) {
        return json_quoted(name.value.as_string());
    };
    if (input.renamed.size() > 0) add("was " + joined(input.renamed.children(), ", ", quoted));
    return parts.empty() ? "" : "(" + joined(parts, ", ") + ")";
}

}  // namespace

std::string exposed_json(const Project& project, const Types& types) {
    std::string inputs;
    const Document& top = project.top();
    for (size_t i = 0; i < top.inputs.size(); ++i)
        inputs +=
            (i ? ",\n    " : "\n    ") + exposed_input(top.inputs[i], types.graph_input(0, i));
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
                           padded(exposed_default(input, port), 12);
        for (const std::string& part : {port.doc, details(input, port)})
            if (!part.empty()) line += " " + part;
        text += printable(line.substr(0, line.find_last_not_of(' ') + 1)) + "\n";
    }
    if (!top.presets.empty()) text += "presets\n";
    for (const Preset& preset : top.presets) {
        const auto value = [](const auto& each) { return each.first + "=" + each.second; };
        text += printable("    " + padded(preset.name, 16) + " " +
                          joined(preset_values(preset), ", ", value)) +
                "\n";
    }
    return text;
}

}  // namespace wrinkle::cli
