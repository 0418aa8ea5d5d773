// wrinkle nodes: lists the node types, or describes one.
#include "base/text.h"
#include "cli/cli.h"
#include "cli/output.h"
#include "cli/session.h"
#include "registry/reference.h"

namespace wrinkle::cli {
namespace {

// The remedy for an unknown id: a similar id, or the types with that word in their id or title.
std::string types_like(const std::string& word, const Registry& registry) {
    std::string found;
    for (const NodeType& type : registry.list())
        if (lower_case(type.id + " " + type.title).find(lower_case(word)) != std::string::npos)
            found += (found.empty() ? "with that word: " : ", ") + type.id;
    return did_you_mean(word, registry.ids(), found.empty() ? "wrinkle nodes lists them" : found);
}

struct NodesCommand {
    CommonOptions common;
    std::string id;
    bool json = false, markdown = false, schema = false;

    int run() const {
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        const NodeType* type = id.empty() ? nullptr : nodes.registry.find(id);
        if (!id.empty() && !type) {
            diagnostics.error(RuleId::unknown_node_type, "there is no node type '" + id + "'",
                              types_like(id, nodes.registry));
            return report(diagnostics, common.diagnostics);
        }
        const int code = write_result("-", text(nodes.registry, type));
        return code == exit_success ? report(diagnostics, common.diagnostics) : code;
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
    auto [sub, c] =
        add_command<NodesCommand>(app, run, "nodes", "Lists the node types, or explains one");
    sub.add_option("ID", c.id, "A node type; a word lists those that contain it");
    auto* form = sub.add_option_group("form");
    form->add_flag("--json", c.json, "As JSON");
    form->add_flag("--markdown", c.markdown, "As a reference page");
    form->add_flag("--schema", c.schema, "The JSON Schema of graph files");
    form->require_option(0, 1);
    declare_common(sub, c.common, false);
}

}  // namespace wrinkle::cli
