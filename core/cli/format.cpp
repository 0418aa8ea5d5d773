// wrinkle format and wrinkle upgrade: rewrite graph files in place.
#include <cstdio>

#include "base/file.h"
#include "base/printable.h"
#include "cli/cli.h"
#include "cli/output.h"
#include "cli/session.h"
#include "graph/edit.h"
#include "graph/write.h"

namespace wrinkle::cli {
namespace {

// Returns the name of a port in the newest version: applies all renames from `first` on.
std::string newest_name(const NodeType& type, size_t first) {
    std::string name = type.renames[first].new_name;
    for (size_t i = first + 1; i < type.renames.size(); ++i)
        if (type.renames[i].old_name == name) name = type.renames[i].new_name;
    return name;
}

// Inputs and outputs have separate name spaces: a rename applies to the side that has the newest
// name and not the old one.
NodeUpgrade upgrade_of(const Node& node, const NodeType& type) {
    NodeUpgrade upgrade;
    upgrade.id = node.id;
    upgrade.version = static_cast<int>(type.version);
    for (size_t i = 0; i < type.renames.size(); ++i) {
        const Rename& rename = type.renames[i];
        if (static_cast<int>(rename.version) <= node.version) continue;
        const std::string name = newest_name(type, i);
        const auto concerns = [&](auto find) {
            return (type.*find)(name) != NodeType::none &&
                   (type.*find)(rename.old_name) == NodeType::none;
        };
        if (concerns(&NodeType::find_input))
            upgrade.inputs.push_back({rename.old_name, rename.new_name});
        if (concerns(&NodeType::find_output))
            upgrade.outputs.push_back({rename.old_name, rename.new_name});
    }
    return upgrade;
}

// Returns the document with nodes that call the inputs of their sub-graphs by current names.
Document with_current_names(const Document& document) {
    Diagnostics not_read;  // such a sub-graph's node stays
    const std::filesystem::path folder = std::filesystem::path(document.file).parent_path();
    Document changed = load_project(document, folder, {}, not_read).top();
    changed.edited = !changed.nodes.same(document.nodes);
    return changed;
}

// Upgrades every node to the newest version of its type.
Document upgraded(const Document& read, const Registry& registry) {
    const Document document = with_current_names(read);
    std::vector<NodeUpgrade> upgrades;
    for (const NodePtr& node : document.nodes) {
        const NodeType* type = registry.find(node->type);
        if (type && node->version < static_cast<int>(type->version))
            upgrades.push_back(upgrade_of(*node, *type));
    }
    return upgrade_nodes(document, upgrades);
}

struct RewriteCommand {
    CommonOptions common;
    std::vector<std::string> files;
    bool check_only = false;
    bool upgrade = false;

    int run() const {
        for (const std::string& file : files)
            if (file != "-" && !check_only && !stream_title(file).empty())
                return fail(exit_usage, file +
                                            " is a stream, which cannot be rewritten; "
                                            "- is stdin to stdout");
        Diagnostics diagnostics;
        Registry registry;
        if (upgrade) registry = std::move(load_nodes(common, diagnostics).registry);
        bool would_change = false;
        std::vector<Result> results;
        for (const std::string& file : graphs_among(files, diagnostics)) {
            if (report_no_graph(file, diagnostics)) continue;
            const auto text = read_text(file, diagnostics);
            if (!text) continue;
            Diagnostics own;
            const std::string stream = stream_title(file);
            const Document document = read_document(*text, stream.empty() ? file : stream, own);
            diagnostics.append(own);
            if (own.has_errors()) continue;
            const std::string result =
                upgrade ? write_document(upgraded(document, registry)) : canonical_text(document);
            if (!check_only) {
                results.push_back({file, result});
            } else if (result != *text) {
                would_change = true;
                std::printf("%s would change\n", printable(file).c_str());
            }
        }
        const int code = report(diagnostics, common.diagnostics);
        if (code != exit_success || would_change) return exit_input;
        return write_results(results);
    }
};

void declare(CLI::App& app, Run& run, const char* name, const char* summary, bool upgrade) {
    auto [sub, c] = add_command<RewriteCommand>(app, run, name, summary);
    c.upgrade = upgrade;
    sub.add_option("FILE", c.files, "Graphs, rewritten in place; - is stdin to stdout")->required();
    sub.add_flag("--check", c.check_only, "Write nothing; exit 1 when a file would change");
    declare_diagnostics(sub, c.common.diagnostics);
    if (upgrade) declare_plugin_path(sub, c.common);
}

}  // namespace

void declare_format(CLI::App& app, Run& run) {
    declare(app, run, "format", "Makes graph files canonical", false);
}

void declare_upgrade(CLI::App& app, Run& run) {
    declare(app, run, "upgrade", "Brings nodes to the newest version of their type", true);
}

}  // namespace wrinkle::cli
