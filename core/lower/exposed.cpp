#include "lower/exposed.h"

#include "base/text.h"
#include "json/write.h"
#include "registry/reference.h"

namespace wrinkle {

std::string exposed_default(const GraphInput& input, const Port& port) {
    if (port.is_value() && lanes_of(port.type) > 0) return default_json(port);
    const bool absent = input.default_value.is(json::Kind::null);
    return absent ? "" : json::one_line(input.default_value);
}

std::string exposed_input(const GraphInput& input, const Port& port, const std::string& uniform) {
    std::string text = "{\"name\": " + json_quoted(input.name);
    const auto add = [&](const char* key, const std::string& json) {
        if (!json.empty()) text += ", " + json_quoted(key) + ": " + json;
    };
    const auto add_text = [&](const char* key, const std::string& word) {
        if (!word.empty()) add(key, json_quoted(word));
    };
    add_text("type", input.type);
    add("default", exposed_default(input, port));
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
    if (!input.renamed.is(json::Kind::null)) add("renamed", json::one_line(input.renamed));
    add_text("uniform", uniform);
    add("built_in", port.is_option() ? "true" : "false");
    return text + "}";
}

std::vector<std::pair<std::string, std::string>> preset_values(const Preset& preset) {
    std::vector<std::pair<std::string, std::string>> values;
    for (const Extra& each : preset.values)
        values.emplace_back(each.key, json::one_line(each.value));
    return values;
}

}  // namespace wrinkle
