#include "cli/session.h"

#include <cstdio>
#include <filesystem>

#include "base/file.h"
#include "base/limits.h"
#include "base/mapped.h"
#include "cli/cli.h"
#include "cli/output.h"
#include "compile/inputs.h"
#include "emit/target.h"
#include "lower/preset.h"
#include "nodes/all.h"

namespace wrinkle::cli {
namespace {

void list_targets() {
    std::string text;
    for (const Target& each : targets())
        text += std::string(each.name) + "  " + std::string(each.doc) + "\n";
    throw CLI::RuntimeError(write_result("-", text));
}

bool is_graph(std::string_view file) {
    return !file.ends_with(test_suffix) && !file.ends_with(preset_suffix);
}

}  // namespace

void declare_plugin_path(CLI::App& command, CommonOptions& options) {
    command
        .add_option("--plugin-path", options.plugin_paths,
                    "A plugin, or a folder of plugins; comes before WRINKLE_PLUGIN_PATH and the "
                    "user's and the system's folder")
        ->type_name("DIR")
        ->allow_extra_args(false)  // one value each: the next word may be a file
        ->take_all();
}

void declare_common(CLI::App& command, CommonOptions& options, bool with_set) {
    if (with_set) {
        command
            .add_option("--preset", options.presets,
                        "Values of the graph's inputs: a preset of the graph, or a file "
                        "NAME.preset.json; before every --set")
            ->type_name("NAME|FILE")
            ->allow_extra_args(false)  // one value each: the next word may be a file
            ->take_all();
        command
            .add_option("--set", options.set,
                        "NODE.PORT=VALUE or input.NAME=VALUE; A:B:N is a sweep of N values")
            ->type_name("SETTING=VALUE")
            ->allow_extra_args(false)  // one value each: the next word may be a file
            ->take_all();
    }
    command
        .add_option("--root", options.root,
                    "Where the files a graph or mesh names must lie; default: its own folder")
        ->type_name("DIR");
    declare_plugin_path(command, options);
    command.add_flag_callback("--list-targets", list_targets,
                              "Lists the languages that compile writes");
    command.add_flag("--no-tangents", options.no_tangents,
                     "Meshes have no vertex tangents: frames of uv0 are derived");
    declare_diagnostics(command, options.diagnostics);
}

Nodes load_nodes(const CommonOptions& options, Diagnostics& diagnostics) {
    Nodes nodes;
    report_limits(diagnostics);
    nodes.registry.add_plugin(built_in_nodes(), Registry::built_in, diagnostics);
    nodes.plugins = load_plugins(nodes.registry, plugin_places(options.plugin_paths), diagnostics,
                                 {.cache = plugin_cache()});
    return nodes;
}

std::optional<std::string> read_text(const std::string& file, Diagnostics& diagnostics) {
    const std::string stream = stream_title(file);
    std::string why;
    auto text = stream.empty() ? read_file(file, why) : read_stream(file, why);
    if (!text)
        diagnostics.add(file_problem(Severity::error, RuleId::file_unreadable,
                                     stream.empty() ? file : stream, why, ""));
    return text;
}

void report_at(const json::Value& value, RuleId rule, std::string message, std::string expected,
               Diagnostics& diagnostics, Severity severity) {
    if (diagnostics.dropped() > 0) return diagnostics.add({});
    Diagnostic problem = diagnose(value, "", rule, std::move(message), std::move(expected));
    problem.severity = severity;
    diagnostics.add(std::move(problem));
}

bool report_no_graph(const std::string& file, Diagnostics& diagnostics) {
    if (is_graph(file)) return false;
    const bool test = file.ends_with(test_suffix);
    diagnostics.add(
        file_problem(Severity::error, RuleId::wrong_file, file,
                     test ? "is a regression test, not a graph" : "is a preset, not a graph",
                     test ? "wrinkle test runs it" : "name the graph that it belongs to"));
    return true;
}

std::vector<std::string> graphs_among(const std::vector<std::string>& files,
                                      Diagnostics& diagnostics) {
    std::vector<std::string> graphs, others;
    for (const std::string& file : files)
        (is_graph(file) ? graphs : others).push_back(file);
    if (graphs.empty() || others.empty()) return files;
    constexpr size_t max_names = 3;
    std::string names;
    for (size_t i = 0; i < others.size() && i < max_names; ++i)
        names += (i ? ", " : "") + others[i];
    if (others.size() > max_names)
        names += " and " + std::to_string(others.size() - max_names) + " more";
    diagnostics.add(file_problem(Severity::warning, RuleId::wrong_file, "",
                                 "left out, as tests and presets are not graphs: " + names, ""));
    return graphs;
}

Project open_project(const std::string& file, const CommonOptions& options,
                     Diagnostics& diagnostics) {
    ProjectOptions project;
    project.root = options.root;
    const std::string stream = stream_title(file);
    Document none;
    none.file = file;
    if (report_no_graph(file, diagnostics))
        return load_project(std::move(none), ".", project, diagnostics);
    if (stream.empty()) return load_project(file, project, diagnostics);
    Document top;
    top.file = stream;
    if (auto text = read_text(file, diagnostics))
        top = read_document(std::move(*text), stream, diagnostics, project.limits);
    return load_project(std::move(top), ".", project, diagnostics);
}

Overrides parse_overrides(const CommonOptions& options, Diagnostics& diagnostics) {
    Overrides overrides;
    overrides.presets = options.presets;
    for (const std::string& text : options.set) {
        auto parsed = parse_override(text, diagnostics);
        if (!parsed) continue;
        if (parsed->is_sweep()) {
            const size_t length = parsed->values.size();
            if (overrides.runs > 1 && overrides.runs != length)
                diagnostics.error(RuleId::option,
                                  "--set " + text + ": the sweeps have " +
                                      std::to_string(overrides.runs) + " and " +
                                      std::to_string(length) + " values",
                                  "sweeps of one call run side by side; give them one length");
            overrides.runs = length;
        }
        overrides.list.push_back(std::move(*parsed));
    }
    return overrides;
}

Project project_of_run(const Project& project, const Registry& registry, const Overrides& overrides,
                       size_t run, Diagnostics& diagnostics) {
    Project changed = project;
    for (const std::string& preset : overrides.presets)
        changed = with_preset(changed, preset, diagnostics);
    return with_overrides(changed, registry, overrides.list, run, diagnostics);
}

std::vector<std::string> input_paths(const Project& project, const Registry& registry) {
    return mapped<std::string>(inputs_of(project, Types(project, registry)), &InputFile::path);
}

std::string path_of_run(const std::string& path, const Overrides& overrides, size_t run) {
    if (!overrides.is_sweep()) return path;
    char number[16];
    std::snprintf(number, sizeof number, ".%03zu", run);
    const std::string extension = std::filesystem::path(path).extension().string();
    return path.substr(0, path.size() - extension.size()) + number + extension;
}

}  // namespace wrinkle::cli
