// wrinkle plugins: lists the found plugins; tests one or writes its manifest.
//
// --test tests a plugin's nodes for the properties of the built-in nodes (core/certify) and prints
// a report. Exit code: 1 if there are findings or the plugin is refused; else 3 if the GPU check
// could not run and --no-gpu was not given; else 0.
#include <algorithm>
#include <cstdio>
#include <optional>
#include <set>

#include "base/file.h"
#include "base/printable.h"
#include "certify/certify.h"
#include "cli/cli.h"
#include "cli/output.h"
#include "cli/session.h"
#include "gpu/context.h"
#include "nodes/all.h"
#include "registry/describe.h"

namespace wrinkle::cli {
namespace {

struct CertifyOptions {
    std::string file;
    bool no_gpu = false;
    std::vector<std::string> allow;    // checks with suppressed findings
    std::string diagnostics = "text";  // json: the findings as diagnostics on standard error too
};

using TypeList = std::vector<const NodeType*>;

// The plugin and the built-in nodes, which drive inputs in the test graphs.
struct Loaded {
    Registry registry;
    std::vector<PluginReport> reports;
    bool fine() const { return !reports.empty() && reports.front().is_taken(); }
};

Loaded load(const std::string& file, bool built_in, Diagnostics& diagnostics) {
    Loaded loaded;
    if (built_in) loaded.registry.add_plugin(built_in_nodes(), Registry::built_in, diagnostics);
    const std::vector<std::string> paths{file};
    loaded.reports = load_plugins(loaded.registry, paths, diagnostics);
    return loaded;
}

// Loads the plugin. A plugin that defines a built-in id is refused, unless it defines all built-in
// nodes and thus replaces them.
Loaded load(const std::string& file, Diagnostics& diagnostics) {
    Diagnostics refused, ignored;
    Loaded loaded = load(file, true, refused);
    if (!loaded.fine()) {
        Loaded alone = load(file, false, ignored);
        Registry built_in;
        built_in.add_plugin(built_in_nodes(), Registry::built_in, ignored);
        const auto ids = built_in.ids();
        const auto is_there = [&](const std::string& id) { return alone.registry.find(id); };
        if (alone.fine() && std::ranges::all_of(ids, is_there)) return alone;
    }
    diagnostics.append(refused);
    return loaded;
}

TypeList types_of(const Loaded& loaded) {
    TypeList types;
    for (const NodeType& type : loaded.registry.list())
        if (type.origin != Registry::built_in) types.push_back(&type);
    return types;
}

// Returns a current GL context; std::nullopt and the reason in `missing` on failure.
std::optional<gpu::Context> current_context(std::string& missing) {
    Diagnostics diagnostics;
    auto context = gpu::Context::offscreen(diagnostics);
    if (context && context->make_current()) return context;
    missing = diagnostics.list().empty() ? "the context cannot be used"
                                         : diagnostics.list().front().message;
    return {};
}

// `missing`: reason for the absent GPU.
int summary(size_t nodes, size_t failed, const std::string& missing, bool gpu_wanted) {
    if (missing.empty())
        std::printf("GPU: %s\n", gpu::Context::renderer_name().c_str());
    else
        std::printf("GPU: NOT RUN, CPU and GPU were not compared (%s)\n", missing.c_str());
    std::printf("%zu ok, %zu failed\n", nodes - failed, failed);
    if (failed > 0) return exit_input;
    return missing.empty() || !gpu_wanted ? exit_success : exit_environment;
}

void declare_certify(CLI::App& command, CertifyOptions& options) {
    CLI::Option* file =
        command
            .add_option("--test", options.file,
                        "Tests the nodes of this plugin as the built-in ones are tested")
            ->type_name("FILE.so");
    command.add_flag("--no-gpu", options.no_gpu, "With --test: CPU and GPU are not compared")
        ->needs(file);
    const auto names = certify::check_names();
    command
        .add_option("--allow", options.allow,
                    "With --test: findings of this check are intended and not reported")
        ->check(CLI::IsMember(std::set<std::string>(names.begin(), names.end())))
        ->allow_extra_args(false)
        ->take_all()
        ->needs(file);
    add_choice(command, "--diagnostics", options.diagnostics, diagnostic_formats,
               "How the findings of --test are printed")
        ->needs(file);
}

int certify_plugin(const CertifyOptions& options) {
    Diagnostics diagnostics;
    const Loaded loaded = load(options.file, diagnostics);
    if (!loaded.fine()) return report(diagnostics, options.diagnostics);
    std::string why;
    const auto pictures = certify::make_image_folder(why);
    if (!pictures) return fail(exit_environment, why);
    std::string missing = options.no_gpu ? "--no-gpu" : "";
    const auto gpu = options.no_gpu ? std::nullopt : current_context(missing);
    const certify::CertifyContext bench{loaded.registry, *pictures, gpu.has_value(), {}};
    const TypeList types = types_of(loaded);
    const PluginReport& plugin = loaded.reports.front();
    std::printf("%s\n    %s %s\n", printable(options.file).c_str(), plugin.id.c_str(),
                plugin.version.c_str());
    size_t failed = 0;
    for (const NodeType* type : types) {
        std::fflush(stdout);
        certify::Report found = certify::certify(*type, bench);
        const auto meant = [&](const certify::Finding& finding) {
            return std::ranges::find(options.allow, finding.check) != options.allow.end();
        };
        std::erase_if(found.findings, meant);
        failed += found.findings.empty() ? 0 : 1;
        std::fputs(certify::to_text(found, bench.gpu).c_str(), stdout);
        for (const certify::Finding& finding : found.findings)
            diagnostics.add(to_diagnostic(finding, found, options.file));
    }
    const int code = summary(types.size(), failed, missing, !options.no_gpu);
    if (options.diagnostics != "text") report(diagnostics, options.diagnostics);
    return code;
}

struct PluginsCommand {
    CommonOptions common;
    CertifyOptions certify;
    std::string manifest;

    int run() const {
        if (!certify.file.empty()) return certify_plugin(certify);
        if (!manifest.empty()) return make_manifest();
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        const int code = write_result("-", to_text(nodes.plugins));
        return code == exit_success ? report(diagnostics, common.diagnostics) : code;
    }

    int make_manifest() const {
        Diagnostics diagnostics;
        const auto listing = read_from_code(manifest, diagnostics);
        if (!listing) return report(diagnostics, "text");
        const std::string file = manifest_of(manifest);
        const std::string read[] = {manifest}, made[] = {file};
        if (const std::string why = overwrite_fault(made, read); !why.empty())
            return fail(exit_usage, why);
        return write_results({{file, to_json(*listing)}, {"-", file + "\n"}});
    }
};

}  // namespace

void declare_plugins(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<PluginsCommand>(
        app, run, "plugins", "Says which plugins were found, loaded or refused, and why");
    declare_plugin_path(sub, c.common);
    declare_certify(sub, c.certify);
    sub.add_option("--manifest", c.manifest,
                   "Writes FILE.json beside a plugin: its nodes are listed without its code")
        ->type_name("FILE.so");
}

}  // namespace wrinkle::cli
