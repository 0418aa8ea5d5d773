// wrinkle compile FILE...: graphs to GLSL.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include "base/text.h"
#include "cli/cost.h"
#include "cli/depfile.h"
#include "cli/material_run.h"
#include "cli/output.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;

namespace {

struct CompileCommand {
    CommonOptions common;
    std::vector<std::string> files;
    std::string output = "-";
    std::string target = std::string(targets().front().name);
    std::string form = "function", params = "baked", differentials = "screen";
    std::string name, stage = "fragment", reflect;
    bool strict = false;
    Depfile depfile;

    int run() const {
        if (const int usage = check_usage()) return usage;
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        const Overrides overrides = parse_overrides(common, diagnostics);
        if (overrides.is_sweep()) {
            complain("compile takes no sweep; give --set one value");
            return exit_usage;
        }
        std::vector<Result> results;
        std::vector<fs::path> inputs;
        for (const std::string& file : files)
            compile(file, nodes.registry, overrides, results, inputs, diagnostics);
        const int code = report(diagnostics, common.diagnostics);
        if (code != exit_fine) return code;
        if (depfile.wanted) results.push_back({depfile_path(), depfile_text(results, inputs)});
        std::error_code ignored;  // writing says why
        if (files.size() > 1) fs::create_directories(output, ignored);
        return write_results(results) ? exit_fine : exit_environment;
    }

    int usage(const std::string& sentence) const {
        complain(sentence);
        return exit_usage;
    }

    int check_usage() const {
        if (files.empty()) return usage("compile needs a graph; - reads standard input");
        if (!find_target(target))
            return usage("there is no target '" + target + "'; --list-targets lists them");
        if (form == "shader" && differentials == "given")
            return usage("the shader form takes its differentials from the screen");
        if (!depfile.wanted && !(depfile.path + depfile.target).empty())
            return usage("-MF and -MT go with -MD");
        if (files.size() == 1) return check_places();
        if (output == "-") return usage("several graphs need a folder: -o FOLDER");
        if (!reflect.empty()) return usage("--reflect goes with one graph");
        std::set<std::string> stems;
        for (const std::string& file : files)
            if (!stems.insert(fs::path(file).stem().string()).second)
                return usage("two graphs have the stem '" + fs::path(file).stem().string() +
                             "', and would be written to one file");
        return check_places();
    }

    // Each place, a file or standard output, takes one text.
    int check_places() const {
        std::vector<std::string> places{output};
        if (form == "shader" && output != "-") places = {output + ".vert", output + ".frag"};
        if (!reflect.empty()) places.push_back(reflect);
        if (depfile.wanted) places.push_back(depfile_path());
        std::sort(places.begin(), places.end());
        const auto twice = std::adjacent_find(places.begin(), places.end());
        if (twice == places.end()) return exit_fine;
        return usage(*twice == "-" ? "standard output takes one text; name a file for the others"
                                   : "two texts would be written to " + *twice);
    }

    void compile(const std::string& file, const Registry& registry, const Overrides& overrides,
                 std::vector<Result>& results, std::vector<fs::path>& inputs,
                 Diagnostics& diagnostics) const {
        Diagnostics own;
        const Project project = open_project(file, common, own);
        const Project changed = with_overrides(project, registry, overrides.list, 0, own);
        MaterialOptions options;
        options.uniform_parameters = params == "uniform";
        options.given_differentials = differentials == "given";
        options.vertex_tangents = !common.no_tangents;
        const Compiled compiled = compile_or_check(changed, registry, options, own);
        if (compiled.ok) {
            EmitOptions emit_options;
            emit_options.form = form == "shader" ? Form::shader : Form::function;
            emit_options.differentials =
                differentials == "given" ? Differentials::given : Differentials::screen;
            emit_options.name = name.empty() ? material_name(file) : name;
            emit_options.target = find_target(target);
            const Shader shader = emit(compiled.module, emit_options);
            report_emit(shader, compiled, changed, own);
            judge_texture_units(shader.reflection, file, strict, own);
            add_results(file, shader, results);
            add_inputs(project, compiled.module, inputs);
        }
        diagnostics.append(own);
    }

    // The function form is one file, the shader form two; of standard output one stage.
    void add_results(const std::string& file, const Shader& shader,
                     std::vector<Result>& results) const {
        const bool folder = files.size() > 1;
        const std::string base =
            folder ? (fs::path(output) / fs::path(file).stem()).string() : output;
        if (form == "function") {
            results.push_back({folder ? base + ".glsl" : base, shader.source});
        } else if (output == "-") {
            results.push_back({"-", stage == "vertex" ? shader.vertex : shader.fragment});
        } else {
            results.push_back({base + ".vert", shader.vertex});
            results.push_back({base + ".frag", shader.fragment});
        }
        if (!reflect.empty()) results.push_back({reflect, to_json(shader.reflection)});
    }

    void add_inputs(const Project& project, const Module& module,
                    std::vector<fs::path>& inputs) const {
        std::error_code ignored;
        for (const Project::File& each : project.files)
            if (!each.path.empty() && fs::is_regular_file(each.path, ignored))
                inputs.push_back(each.path);
        for (const Resource& resource : module.resources)
            inputs.push_back(resource.file);
    }

    std::string depfile_path() const {
        return !depfile.path.empty() ? depfile.path : output == "-" ? "-" : output + ".d";
    }

    std::string depfile_text(const std::vector<Result>& results,
                             const std::vector<fs::path>& inputs) const {
        std::vector<std::string> made;
        if (!depfile.target.empty())
            made.push_back(depfile.target);
        else
            for (const Result& result : results)
                made.push_back(result.path);
        return make_rule(made, inputs);
    }
};

}  // namespace

void declare_compile(CLI::App& app, Run& run) {
    auto command = std::make_shared<CompileCommand>();
    CompileCommand& c = *command;
    CLI::App& sub = *app.add_subcommand("compile", "Graphs to GLSL");
    sub.add_option("FILE", c.files, "Graphs; - reads standard input");
    sub.add_option("-o", c.output,
                   "The file; of the shader form OUT.vert and OUT.frag; of several "
                   "graphs a folder")
        ->type_name("OUT")
        ->capture_default_str();
    sub.add_option("--target", c.target, "The language to write")->capture_default_str();
    sub.add_option("--form", c.form, "Functions for your shader, or a complete pair")
        ->check(CLI::IsMember({"function", "shader"}))
        ->capture_default_str();
    sub.add_option("--params", c.params, "Numbers as literals or as uniforms")
        ->check(CLI::IsMember({"baked", "uniform"}))
        ->capture_default_str();
    sub.add_option("--differentials", c.differentials,
                   "Taken from the screen or passed by the caller")
        ->check(CLI::IsMember({"screen", "given"}))
        ->capture_default_str();
    sub.add_option("--name", c.name, "NAME in the text; default: the file's stem");
    sub.add_option("--stage", c.stage, "Which stage goes to standard output")
        ->check(CLI::IsMember({"vertex", "fragment"}))
        ->capture_default_str();
    sub.add_option("--reflect", c.reflect, "Writes what a caller must know as JSON")
        ->type_name("FILE");
    sub.add_flag("--strict", c.strict,
                 "More images than a shader has texture units for certain are an error");
    declare_depfile(sub, c.depfile);
    declare_common(sub, c.common);
    sub.callback([command, &run] { run = [command] { return command->run(); }; });
}

}  // namespace wrinkle::cli
