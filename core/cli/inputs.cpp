// wrinkle inputs FILE...: lists the input files of graphs, for build systems.
#include <set>

#include "base/printable.h"
#include "base/text.h"
#include "cli/output.h"
#include "cli/session.h"
#include "compile/inputs.h"

namespace wrinkle::cli {
namespace {

struct InputsCommand {
    CommonOptions common;
    std::vector<std::string> files;
    bool json = false;

    int run() const {
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        std::string entries;
        std::vector<std::string> all;
        std::set<std::string> seen;
        for (const std::string& file : graphs_among(files, diagnostics)) {
            Diagnostics own;
            const Project project = open_project(file, common, own);
            diagnostics.append(own);
            const auto inputs = inputs_of(project, Types(project, nodes.registry));
            entries += (entries.empty() ? "\n  " : ",\n  ") + entry(file, inputs);
            for (const InputFile& input : inputs)
                if (seen.insert(input.path).second) all.push_back(input.path);
        }
        const int code = report(diagnostics, common.diagnostics);
        if (code != exit_success) return code;
        for (const std::string& path : all)
            if (!json && printable(path) != path) {
                const std::string name = "the name '" + path + "'";
                return fail(exit_input, name + " cannot be a line of a list; --json lists it");
            }
        return write_result("-", json ? "{\"version\": 1, \"graphs\": [" + entries + "\n]}\n"
                                      : joined(all, "", [](auto& path) { return path + "\n"; }));
    }

    static std::string entry(const std::string& file, const std::vector<InputFile>& inputs) {
        return "{\"file\": " + json_quoted(file) + ", \"inputs\": [" +
               joined(inputs, ",",
                      [](const InputFile& input) {
                          return "\n    {\"path\": " + json_quoted(input.path) + ", \"kind\": \"" +
                                 std::string(name_of(input.kind)) + "\"}";
                      }) +
               "]}";
    }
};

}  // namespace

void declare_inputs(CLI::App& app, Run& run) {
    auto [sub, c] =
        add_command<InputsCommand>(app, run, "inputs", "Lists every file that graphs read");
    sub.add_option("FILE", c.files, "Graphs; - reads standard input")->required();
    sub.add_flag("--json", c.json, "As JSON: for each graph its inputs with their kind");
    declare_common(sub, c.common, false);
}

}  // namespace wrinkle::cli
