// wrinkle nodes: lists the node types, or describes one.
#include <memory>

#include "base/text.h"
#include "cli/output.h"
#include "cli/session.h"
#include "registry/reference.h"

namespace wrinkle::cli {
namespace {

struct NodesCommand {
    CommonOptions common;
    std::string id;
    bool json = false, markdown = false, schema = false;

    int run() const {
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        const NodeType* type = id.empty() ? nullptr : nodes.registry.find(id);
        if (!id.empty() && !type) {
            diagnostics.error("there is no node type '" + id + "'",
                              did_you_mean(id, nodes.registry.ids(), "wrinkle nodes lists them"));
            return report(diagnostics, common.diagnostics);
        }
        if (!write_result("-", text(nodes.registry, type))) return exit_environment;
        return report(diagnostics, common.diagnostics);
    }

    std::string text(const Registry& registry, const NodeType* type) const {
        if (schema) return graph_schema(registry);
        if (json) return type ? page_json(*type) : list_json(registry);
        if (markdown) return type ? page_markdown(*type) : list_markdown(registry);
        return type ? page_text(*type) : list_text(registry);
    }
};

}  // namespace

void declare_nodes(CLI::App& app, Run& run) {
    auto command = std::make_shared<NodesCommand>();
    CLI::App& sub = *app.add_subcommand("nodes", "Lists the node types, or explains one");
    sub.add_option("ID", command->id, "A node type");
    auto* form = sub.add_option_group("form");
    form->add_flag("--json", command->json, "As JSON");
    form->add_flag("--markdown", command->markdown, "As a reference page");
    form->add_flag("--schema", command->schema, "The JSON Schema of graph files");
    form->require_option(0, 1);
    declare_common(sub, command->common, false);
    sub.callback([command, &run] { run = [command] { return command->run(); }; });
}

}  // namespace wrinkle::cli
