// wrinkle check FILE...: reports all problems of graphs.
#include "cli/material_run.h"
#include "cli/output.h"
#include "cli/session.h"

namespace wrinkle::cli {
namespace {

struct CheckCommand {
    CommonOptions common;
    std::vector<std::string> files;

    int run() const {
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        const Overrides overrides = parse_overrides(common, diagnostics);
        for (const std::string& file : graphs_among(files, diagnostics))
            check_file(nodes.registry, overrides, file, diagnostics);
        return report(diagnostics, common.diagnostics);
    }

    // Compiles the graph to find problems beyond the document, such as mismatched bases.
    void check_file(const Registry& registry, const Overrides& overrides, const std::string& file,
                    Diagnostics& diagnostics) const {
        Diagnostics own;
        const Project project = open_project(file, common, own);
        for (size_t run = 0; run < overrides.runs; ++run) {
            const Project changed = with_overrides(project, registry, overrides.list, run, own);
            MaterialOptions options;
            options.vertex_tangents = !common.no_tangents;
            compile_or_check(changed, registry, options, own);
            if (own.has_errors()) break;
        }
        diagnostics.append_once(own);
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
