// wrinkle format and wrinkle upgrade: graph files rewritten in place.
#include <cstdio>
#include <memory>

#include "cli/output.h"
#include "cli/session.h"
#include "graph/edit.h"
#include "graph/write.h"

namespace wrinkle::cli {
namespace {

// Brings every node whose type has a newer version to it: ports that were renamed since are
// renamed.
Document upgraded(Document document, const Registry& registry) {
    const Document original = document;
    for (const NodePtr& node : original.nodes) {
        const NodeType* type = registry.find(node->type);
        if (!type || node->version >= static_cast<int>(type->version)) continue;
        for (const Rename& rename : type->renames)
            if (static_cast<int>(rename.version) > node->version)
                document = rename_port(document, node->id, rename.old_name, rename.new_name);
        document = set_type(document, node->id, node->type, static_cast<int>(type->version));
    }
    return document;
}

struct RewriteCommand {
    CommonOptions common;
    std::vector<std::string> files;
    bool check_only = false;
    bool upgrade = false;

    int run() const {
        Diagnostics diagnostics;
        Registry registry;
        if (upgrade) registry = std::move(load_nodes(common, diagnostics).registry);
        bool would_change = false, written = true;
        for (const std::string& file : files) {
            const auto text = read_text(file, diagnostics);
            if (!text) continue;
            Diagnostics own;
            const Document document = read_document(*text, file == "-" ? "<stdin>" : file, own);
            diagnostics.append(own);
            if (own.has_errors()) continue;
            const std::string result =
                upgrade ? write_document(upgraded(document, registry)) : canonical_text(document);
            if (!check_only) {
                written = write_result(file, result) && written;
            } else if (result != *text) {
                would_change = true;
                std::printf("%s would change\n", file.c_str());
            }
        }
        const int code = report(diagnostics, common.diagnostics);
        if (!written) return exit_environment;
        return code != exit_fine ? code : would_change ? exit_input : exit_fine;
    }
};

void declare(CLI::App& app, Run& run, const char* name, const char* summary, bool upgrade) {
    auto command = std::make_shared<RewriteCommand>();
    command->upgrade = upgrade;
    CLI::App& sub = *app.add_subcommand(name, summary);
    sub.add_option("FILE", command->files, "Graphs, rewritten in place; - is stdin to stdout")
        ->required();
    sub.add_flag("--check", command->check_only, "Write nothing; exit 1 when a file would change");
    sub.add_option("--diagnostics", command->common.diagnostics, "How problems are printed")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    if (upgrade) declare_plugin_path(sub, command->common);
    sub.callback([command, &run] { run = [command] { return command->run(); }; });
}

}  // namespace

void declare_format(CLI::App& app, Run& run) {
    declare(app, run, "format", "Makes graph files canonical", false);
}

void declare_upgrade(CLI::App& app, Run& run) {
    declare(app, run, "upgrade", "Brings nodes to the newest version of their type", true);
}

}  // namespace wrinkle::cli
