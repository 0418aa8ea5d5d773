// wrinkle check FILE...: reports all problems of graphs.
#include "cli/cli.h"
#include "cli/conflict_file.h"
#include "cli/material_run.h"
#include "cli/output.h"

namespace wrinkle::cli {
namespace {

struct CheckCommand {
    CommonOptions common;
    std::vector<std::string> files;

    int run() const {
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        const Overrides overrides = parse_overrides(common, diagnostics);
        // Compiles the graphs to find problems beyond the document, such as mismatched bases.
        for (const std::string& file : graphs_among(files, diagnostics)) {
            compile_runs(
                file, common, nodes.registry, overrides, {},
                [](size_t, const MaterialRun&, Diagnostics&) {}, diagnostics);
            report_conflicts(file, diagnostics);
        }
        return report(diagnostics, common.diagnostics);
    }
};

}  // namespace

void declare_check(CLI::App& app, Run& run) {
    auto [sub, c] =
        add_command<CheckCommand>(app, run, "check", "Reports every problem of graphs at once");
    sub.add_option("FILE", c.files, "Graphs; - reads standard input")->required();
    declare_common(sub, c.common);
}

}  // namespace wrinkle::cli
