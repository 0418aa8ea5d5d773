// wrinkle plugins: lists the found plugins; tests one or writes its manifest.
#include <memory>

#include "base/overwrite.h"
#include "cli/certify.h"
#include "cli/output.h"
#include "cli/session.h"
#include "registry/describe.h"

namespace wrinkle::cli {
namespace {

struct PluginsCommand {
    CommonOptions common;
    CertifyOptions certify;
    std::string manifest;

    int run() const {
        if (!certify.file.empty()) return certify_plugin(certify);
        if (!manifest.empty()) return make_manifest();
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        if (!write_result("-", to_text(nodes.plugins))) return exit_environment;
        return report(diagnostics, common.diagnostics);
    }

    int make_manifest() const {
        Diagnostics diagnostics;
        const auto listing = read_from_code(manifest, diagnostics);
        if (!listing) return report(diagnostics, "text");
        const std::string file = manifest_of(manifest);
        const std::string read[] = {manifest}, made[] = {file};
        if (const std::string why = overwrite_fault(made, read); !why.empty()) {
            print_error(why);
            return exit_usage;
        }
        const bool written =
            write_result(file, to_json(*listing)) && write_result("-", file + "\n");
        return written ? exit_success : exit_environment;
    }
};

}  // namespace

void declare_plugins(CLI::App& app, Run& run) {
    auto command = std::make_shared<PluginsCommand>();
    CLI::App& sub =
        *app.add_subcommand("plugins", "Says which plugins were found, loaded or refused, and why");
    declare_plugin_path(sub, command->common);
    declare_certify(sub, command->certify);
    sub.add_option("--manifest", command->manifest,
                   "Writes FILE.json beside a plugin: its nodes are listed without its code")
        ->type_name("FILE.so");
    sub.callback([command, &run] { run = [command] { return command->run(); }; });
}

}  // namespace wrinkle::cli
