#include "lower/preset.h"

#include "base/file.h"
#include "base/text.h"
#include "graph/edit.h"
#include "graph/renamed.h"
#include "json/parse.h"
#include "lower/check.h"
#include "lower/literal.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;
using json::Kind;

// Reads a preset file; reports each problem with its location.
class PresetReader {
public:
    PresetReader(const Project& project, Diagnostics& diagnostics)
        : project_(project), diagnostics_(diagnostics) {}

    Preset read(const std::string& file) {
        Preset preset;
        preset.name = file;
        std::string why;
        auto bytes = read_file(file, why);
        if (!bytes)
            return diagnostics_.add(
                       file_problem(Severity::error, RuleId::file_unreadable, file, why, "")),
                   preset;
        const json::Parsed parsed = json::parse(std::move(*bytes), file, diagnostics_);
        if (!parsed.complete || !expect(parsed.root, Kind::object, "the preset")) return preset;
        for (const json::Member& member : parsed.root.children())
            read_member(member, preset);
        for (const std::string_view key : {"wrinkle_preset", "graph"})
            if (!parsed.root.has(key))
                report(parsed.root, RuleId::missing_key, "the preset has no " + json_quoted(key),
                       key == "graph" ? "expected \"graph\": the path of its graph"
                                      : "expected \"wrinkle_preset\": 1");
        return preset;
    }

private:
    void read_member(const json::Member& member, Preset& preset) {
        const auto& [key, value] = member;
        static const std::array<std::string, 4> keys = {"wrinkle_preset", "graph", "inputs",
                                                        "$schema"};
        if (key == "wrinkle_preset") {
            if (!expect(value, Kind::number, "\"wrinkle_preset\"") || value.as_number() == 1)
                return;
            report(value, RuleId::format_version,
                   "the format version is " + std::string(value.spelling()),
                   "this program reads version 1");
        } else if (key == "graph") {
            if (expect(value, Kind::string, "\"graph\"")) check_graph(value, preset.name);
        } else if (key == "inputs") {
            if (!expect(value, Kind::object, "\"inputs\"")) return;
            for (const json::Member& input : value.children())
                preset.values.push_back({std::string(input.key), input.value});
        } else if (key != "$schema") {
            report(value, RuleId::unknown_key, "unknown key " + json_quoted(key),
                   did_you_mean(key, keys, "expected " + one_of(keys)));
        }
    }

    // A graph from a stream is of every preset.
    void check_graph(const json::Value& value, const std::string& file) {
        std::error_code ignored;
        const fs::path top = project_.files[0].path;
        if (!fs::is_regular_file(top, ignored)) return;
        const fs::path named = fs::path(file).parent_path() / value.as_string();
        if (real_path(named) == top) return;
        report(value, RuleId::wrong_file,
               "the preset is of " + json_quoted(value.as_string()) + ", not of " +
                   json_quoted(project_.top().file),
               "expected a preset of this graph");
    }

    bool expect(const json::Value& value, Kind kind, const std::string& what) {
        if (value.is(kind)) return true;
        report(value, RuleId::wrong_kind, what + " is " + json::kind_name(value.kind()),
               std::string("expected ") + json::kind_name(kind));
        return false;
    }
    void report(const json::Value& value, RuleId rule, std::string message, std::string expected) {
        diagnostics_.add(diagnose(value, "", rule, std::move(message), std::move(expected)));
    }

    const Project& project_;
    Diagnostics& diagnostics_;
};

// Returns a path of a preset file relative to the graph's folder; absolute paths are unchanged.
std::string moved(std::string_view path, const std::string& preset, const fs::path& graph) {
    const fs::path folder = real_path(fs::path(preset).parent_path());
    return (folder / path).lexically_normal().lexically_relative(graph.parent_path()).string();
}

// Returns an image of a preset file with its path relative to the graph's folder.
json::Value moved_image(const json::Value& image, const std::string& preset,
                        const fs::path& graph) {
    const std::string_view path = literal_image(image).file;
    if (path.empty() || fs::path(path).is_absolute()) return image;
    const std::string there = moved(path, preset, graph);
    if (there == path) return image;
    const json::Value file = json::Value::string(there);
    if (image.is(Kind::string)) return file;
    std::vector<std::pair<std::string, json::Value>> members;
    for (const auto& [key, value] : image.children())
        members.emplace_back(key, key == "file" ? file : value);
    return json::Value::object(members);
}

// Reports a value of a preset file for `key`, which no input has as its name.
Diagnostic no_input(const Document& top, const std::string& key, const json::Value& value) {
    const std::string twice = set_twice(key, top.inputs);
    if (!twice.empty())
        return diagnose(value, "", RuleId::former_name, "input '" + key + "' " + twice, set_once);
    return diagnose(
        value, "", RuleId::unknown_input, "the graph has no input '" + key + "'",
        did_you_mean(key, keys_of(top.inputs), "it has " + joined(keys_of(top.inputs), ", ")));
}

}  // namespace

bool is_preset_file(const Project& project, const std::string& name) {
    return name.ends_with(".json") && !project.top().presets.find(name);
}

Preset preset_of_file(const Project& project, const std::string& file, Diagnostics& diagnostics) {
    const Document& top = project.top();
    Preset preset =
        with_current_names(PresetReader(project, diagnostics).read(file), FormerNames(top.inputs));
    std::erase_if(preset.values, [&](const Extra& value) {
        if (top.inputs.find(value.key)) return false;
        const bool only_counted = diagnostics.dropped() > 0;
        diagnostics.add(only_counted ? Diagnostic{} : no_input(top, value.key, value.value));
        return true;
    });
    for (auto& [key, value] : preset.values)
        if (port_type_named(top.inputs.find(key)->type) == PortType::image_)
            value = moved_image(value, file, project.files[0].path);
    return preset;
}

Project with_preset(const Project& project, const std::string& name, Diagnostics& diagnostics) {
    Project changed = project;
    Document& top = changed.files[0].document;
    const bool in_file = is_preset_file(project, name);
    const Preset* known = top.presets.find(name);
    if (!known && !in_file) {
        const std::vector<std::string> names = keys_of(top.presets);
        diagnostics.add(diagnose(top, RuleId::unknown_preset,
                                 "the graph has no preset '" + name + "'",
                                 did_you_mean(name, names,
                                              names.empty() ? "a file ends in .json"
                                                            : "it has " + joined(names, ", "))));
        return changed;
    }
    const Preset preset = in_file ? preset_of_file(project, name, diagnostics) : *known;
    if (in_file) changed.preset_files.push_back(name);
    for (const auto& [key, value] : preset.values) {
        const GraphInput* input = top.inputs.find(key);
        if (!input) continue;  // check() reports it
        GraphInput set = *input;
        set.default_value = value;
        top = set_graph_input(top, std::move(set));
    }
    return changed;
}

}  // namespace wrinkle
