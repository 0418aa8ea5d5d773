// wrinkle inputs FILE...: lists the input files of graphs, for build systems, and the inputs and
// presets that graphs declare.
#include <set>

#include "base/printable.h"
#include "base/text.h"
#include "cli/cli.h"
#include "cli/exposed.h"
#include "cli/output.h"
#include "cli/session.h"
#include "compile/inputs.h"

namespace wrinkle::cli {
namespace {

struct InputsCommand {
    CommonOptions common;
    std::vector<std::string> files;
    bool json = false, exposed = false;

    int run() const {
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        std::string entries, declared;
        std::vector<std::string> all;
        std::set<std::string> seen;
        const std::vector<std::string> graphs = graphs_among(files, diagnostics);
        for (const std::string& file : graphs) {
            Diagnostics own;
            const Project project = open_project(file, common, own);
            diagnostics.append(own);
            const Types types(project, nodes.registry);
            const auto inputs = inputs_of(project, types);
            entries += (entries.empty() ? "\n  " : ",\n  ") + entry(file, inputs) + ",\n   " +
                       exposed_json(project, types) + "}";
            declared +=
                (graphs.size() > 1 ? printable(file) + "\n" : "") + exposed_text(project, types);
            for (const InputFile& input : inputs)
                if (seen.insert(input.path).second) all.push_back(input.path);
        }
        const int code = report(diagnostics, common.diagnostics);
        if (code != exit_success) return code;
        if (json) return write_result("-", "{\"version\": 1, \"graphs\": [" + entries + "\n]}\n");
        if (exposed) return write_result("-", declared);
        for (const std::string& path : all)
            if (printable(path) != path) {
                const std::string name = "the name '" + path + "'";
                return fail(exit_input, name + " cannot be a line of a list; --json lists it");
            }
        return write_result("-", joined(all, "", [](auto& path) { return path + "\n"; }));
    }

    static std::string entry(const std::string& file, const std::vector<InputFile>& inputs) {
        return "{\"file\": " + json_quoted(file) + ", \"inputs\": [" +
               joined(inputs, ",",
                      [](const InputFile& input) {
                          return "\n    {\"path\": " + json_quoted(input.path) + ", \"kind\": \"" +
                                 std::string(name_of(input.kind)) + "\"}";
                      }) +
               "]";
    }
};

}  // namespace

void declare_inputs(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<InputsCommand>(
        app, run, "inputs", "Lists every file that graphs read, or the inputs that they declare");
    sub.add_option("FILE", c.files, "Graphs; - reads standard input")->required();
    sub.add_flag("--exposed", c.exposed,
                 "The inputs that a graph declares and its presets, not files");
    sub.add_flag("--json", c.json,
                 "As JSON: for each graph its files with their kind, its inputs and its presets");
    declare_common(sub, c.common, false);
}

}  // namespace wrinkle::cli
