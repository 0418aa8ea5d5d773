// wrinkle compile FILE...: compiles graphs to shaders.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>

#include "base/file.h"
#include "cli/arguments.h"
#include "cli/cli.h"
#include "cli/compile_graph.h"
#include "cli/jobs.h"
#include "cli/output.h"
#include "cli/outputs.h"
#include "cli/session.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

// Result of compiling one graph.
struct Outcome {
    CompiledGraph graph;
    std::string unwritten;  // reason of a failed write; "" on success
    Rule rule;
};

struct CompileCommand {
    CommonOptions common;
    TextOptions text;
    Outputs outputs;
    const CLI::Option* output = nullptr;  // -o
    std::string cache_folder;
    uint64_t cache_size = Cache::default_limit;
    unsigned jobs = 0;  // 0: one per processor

    int run() {
        Diagnostics diagnostics;
        outputs.files = graphs_among(outputs.files, diagnostics);
        outputs.costs = text.cost;
        text.reflects = !outputs.reflect.empty();
        outputs.texts = !text.cost || output->count() > 0;
        if (const std::string why = wrong_usage(); !why.empty()) return fail(exit_usage, why);
        outputs.form = form_of(text);
        outputs.suffix = find_target(text.target)->suffix;
        outputs.function_suffix = function_suffix(*find_target(text.target));
        if (const std::string why = outputs.conflict(); !why.empty()) return fail(exit_usage, why);
        if (std::string why; !have_compilers(text, why)) return fail(exit_environment, why);
        const Nodes nodes = load_nodes(common, diagnostics);
        const Overrides overrides = parse_overrides(common, diagnostics);
        if (overrides.is_sweep())
            return fail(exit_usage, "compile takes no sweep; give --set one value");
        if (diagnostics.has_errors()) return report(diagnostics, common.diagnostics);
        std::optional<Cache> cache;
        if (!cache_folder.empty()) cache.emplace(cache_folder, cache_size);
        const Compilation with{common, text, nodes.registry, overrides, cache ? &*cache : nullptr};
        if (outputs.several()) refuse_overwriting(with, diagnostics);
        if (diagnostics.has_errors()) return report(diagnostics, common.diagnostics);
        const std::vector<Outcome> outcomes = compile_all(with);
        if (cache) cache->prune();
        return finish(outcomes, diagnostics);
    }

    std::string wrong_usage() const {
        if (outputs.files.empty()) return "compile needs a graph; - reads standard input";
        if (const std::string why = wrong_text(text); !why.empty()) return why;
        if (!outputs.depfile.is_complete()) return "-MF, -MT and -MP go with -MD";
        if (text.json && !text.cost) return "--json goes with --cost";
        return "";
    }

    // Reports an error if an output would overwrite an input of any graph. The first of several
    // graphs is written before the last is compiled, so the inputs of all graphs are collected
    // first, unless no output exists yet.
    void refuse_overwriting(const Compilation& with, Diagnostics& diagnostics) const {
        const std::vector<std::string> paths = outputs.all_paths();
        std::vector<std::string> read = outputs.files;
        read.insert(read.end(), with.overrides.presets.begin(), with.overrides.presets.end());
        std::error_code ignored;
        const auto exists = [&](const std::string& path) { return fs::exists(path, ignored); };
        if (std::ranges::any_of(paths, exists)) {
            std::vector<std::vector<std::string>> found(outputs.files.size());
            each_graph([&](size_t i) { found[i] = inputs_read(outputs.files[i], with); });
            for (const std::vector<std::string>& inputs : found)
                read.insert(read.end(), inputs.begin(), inputs.end());
        }
        if (const std::string why = overwrite_fault_of_run(paths, read); !why.empty())
            diagnostics.error(RuleId::output_path, why);
    }

    static std::vector<std::string> inputs_read(const std::string& file, const Compilation& with) {
        if (!stream_title(file).empty()) return {};  // a stream can be read only once
        Diagnostics later;
        return input_paths(open_project(file, with.common, later), with.registry);
    }

    // The files of a graph are written together or not at all, independently of other graphs. With
    // only one graph, its dependency file is part of that group. Graphs compiled concurrently share
    // the limits of one; a graph that exceeds its share is compiled again with the full limits.
    std::vector<Outcome> compile_all(const Compilation& with) const {
        std::vector<Outcome> outcomes(outputs.files.size());
        Compilation shared = with;
        shared.sharing = threads();
        each_graph([&](size_t i) { outcomes[i] = compile_one(outputs.files[i], shared); });
        for (size_t i = 0; i < outcomes.size() && shared.sharing > 1; ++i)
            if (outcomes[i].graph.over_limit) outcomes[i] = compile_one(outputs.files[i], with);
        return outcomes;
    }

    size_t threads() const { return thread_count(jobs, outputs.files.size()); }

    void each_graph(const std::function<void(size_t)>& use) const {
        for_each_item(outputs.files.size(), threads(), use);
    }

    Outcome compile_one(const std::string& file, const Compilation& with) const {
        Outcome outcome{compile_graph(file, with), "", {}};
        CompiledGraph& graph = outcome.graph;
        if (graph.diagnostics.has_errors()) return outcome;
        std::vector<Result> results;
        if (!outputs.texts) graph.texts.clear();
        for (Text& each : graph.texts)
            if (!outputs.is_standard_output() || each.stage.empty() || each.stage == outputs.stage)
                results.push_back({outputs.source_path(file, each.suffix), std::move(each.bytes)});
        Result reflection{outputs.reflection_path(file), std::move(graph.reflection)};
        for (const Result& result : results)
            outcome.rule.made.push_back(result.path);
        if (!outputs.reflect.empty()) outcome.rule.made.push_back(reflection.path);
        for (InputFile& input : graph.inputs)
            outcome.rule.from.push_back(std::move(input.path));
        if (!may_be_written(outcome)) return outcome;
        if (outputs.depfile.wanted && !outputs.several())
            results.push_back(
                {outputs.depfile_path(), make_rules({outcome.rule}, outputs.depfile)});
        if (!outputs.reflect.empty()) results.push_back(std::move(reflection));  // written last
        if (outputs.several()) make_folders(results);
        write_results(results, outcome.unwritten);
        return outcome;
    }

    // Checks the outputs before any file of the graph is written; reports errors.
    bool may_be_written(Outcome& outcome) const {
        std::string why;
        if (outputs.depfile.wanted) why = depfile_fault({outcome.rule}, outputs.depfile);
        if (why.empty() && !outputs.several())
            why = overwrite_fault_of_run(outputs.all_paths(), outcome.rule.from);
        if (!why.empty()) outcome.graph.diagnostics.error(RuleId::output_path, why);
        return why.empty();
    }

    static void make_folders(const std::vector<Result>& results) {
        std::error_code ignored;  // write_results() reports the error
        for (const Result& result : results)
            fs::create_directories(fs::path(result.path).parent_path(), ignored);
    }

    // Reports the results in the order of the graphs and returns the exit code.
    int finish(const std::vector<Outcome>& outcomes, Diagnostics& diagnostics) const {
        std::vector<Rule> rules;
        for (const Outcome& outcome : outcomes) {
            diagnostics.append(outcome.graph.diagnostics);
            rules.push_back(outcome.rule);
        }
        const bool fine = !diagnostics.has_errors();
        bool written = true;
        const auto unwritten = [&](const std::string& why) {
            written = written && why.empty();
            if (!why.empty()) diagnostics.error(RuleId::file_unwritable, why);
        };
        for (const Outcome& outcome : outcomes)
            unwritten(outcome.unwritten);
        if (outputs.depfile.wanted && outputs.several() && fine && written) {
            std::string why;
            write_results({{outputs.depfile_path(), make_rules(rules, outputs.depfile)}}, why);
            unwritten(why);
        }
        const int code = report(diagnostics, common.diagnostics);
        return print_costs(outcomes) && written ? code : int{exit_environment};
    }

    bool print_costs(const std::vector<Outcome>& outcomes) const {
        std::vector<GraphCost> costs;
        for (size_t i = 0; i < outcomes.size(); ++i)
            if (const std::string& cost = outcomes[i].graph.cost; !cost.empty())
                costs.push_back({outputs.files[i], cost});
        return costs.empty() || write_result("-", printed_costs(costs, outputs.several(),
                                                                text.json)) == exit_success;
    }
};

void declare_cache(CLI::App& sub, CompileCommand& c) {
    sub.add_option("-j,--jobs", c.jobs, "How many graphs at a time; default: one a processor")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
    sub.add_option("--cache", c.cache_folder,
                   "Keeps what was made in this folder, and takes it from there")
        ->type_name("DIR");
    sub.add_option("--cache-size", c.cache_size,
                   "How much the cache may hold, such as 500MB; default: 1GB")
        ->type_name("SIZE")
        ->transform(CLI::AsSizeValue(false));
}

void declare_judgement(CLI::App& sub, TextOptions& text) {
    sub.add_flag("--strict", text.strict,
                 "More images or outputs than every machine has room for are an error");
    sub.add_flag("--cost", text.cost,
                 "Prints what the graph and each of its nodes cost; without -o nothing else");
    sub.add_flag("--json", text.json, "The costs as JSON");
}

}  // namespace

void declare_compile(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<CompileCommand>(
        app, run, "compile", "Graphs to GLSL, HLSL, Metal, WGSL, Godot or SPIR-V");
    sub.add_option("FILE", c.outputs.files, "Graphs; - reads standard input");
    c.output = sub.add_option("-o", c.outputs.output,
                              "The file; of the shader form OUT.vert and OUT.frag; of several "
                              "graphs a folder")
                   ->type_name("OUT")
                   ->capture_default_str();
    declare_text(sub, c.text);
    declare_judgement(sub, c.text);
    add_choice(sub, "--stage", c.outputs.stage, {"vertex", "fragment"},
               "Which stage goes to standard output");
    sub.add_option("--reflect", c.outputs.reflect,
                   "Writes what a caller must know as JSON; of several graphs into a folder")
        ->type_name("FILE");
    declare_depfile(sub, c.outputs.depfile);
    declare_cache(sub, c);
    declare_common(sub, c.common);
}

}  // namespace wrinkle::cli
