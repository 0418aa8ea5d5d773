// wrinkle export FILE --to HOST -o FOLDER: writes a material for a host.
#include "export/export.h"

#include "base/text.h"
#include "cli/arguments.h"
#include "cli/cli.h"
#include "cli/meshes.h"
#include "cli/output.h"
#include "compile/shader.h"

namespace wrinkle::cli {
namespace {

struct ExportCommand {
    CommonOptions common;
    std::string file, to, output, name, mesh = "sphere";
    uint32_t size = 1024;
    bool list = false;

    int run() const {
        if (list) return write_result("-", listed());
        if (const std::string why = wrong_usage(); !why.empty()) return fail(exit_usage, why);
        Diagnostics problems;
        const auto files = export_files(problems);
        const bool unwritable = std::ranges::any_of(problems.list(), [](const Diagnostic& problem) {
            return problem.severity == Severity::error && problem.rule == RuleId::file_unwritable;
        });
        const int code = report(problems, common.diagnostics);
        if (code != exit_success) return unwritable ? int{exit_environment} : code;
        return write_result("-", joined(files, "\n") + "\n");
    }

    static std::string listed() {
        std::string text;
        for (const Host& host : hosts()) {
            text += std::string(host.name) + std::string(12 - host.name.size(), ' ');
            text += std::string(host.label) + ": " + std::string(host.doc) + "\n";
        }
        return text;
    }

    std::string wrong_usage() const {
        if (file.empty()) return "export takes a graph; export --list lists the hosts";
        if (to.empty()) return "export needs --to HOST; export --list lists the hosts";
        if (output.empty()) return "export needs -o FOLDER";
        if (output == "-") return "an export is a folder; it cannot go to standard output";
        std::error_code error;
        if (std::filesystem::exists(output, error) && !std::filesystem::is_directory(output, error))
            return "-o " + output + " is a file; name a folder";
        return check_mesh(mesh);
    }

    std::vector<std::string> export_files(Diagnostics& problems) const {
        std::vector<std::string> inputs;
        bool double_sided = false;
        const auto opened = open_mesh(mesh, common, problems, &inputs, &double_sided);
        const Nodes nodes = load_nodes(common, problems);
        const Overrides overrides = parse_overrides(common, problems);
        if (overrides.is_sweep())
            problems.error(RuleId::option, "a sweep makes several materials; export takes one");
        Project project = open_project(file, common, problems);
        if (double_sided) follow_double_sided(project.files[0].document, mesh, problems);
        if (problems.has_errors()) return {};
        project = project_of_run(project, nodes.registry, overrides, 0, problems);
        const auto read = input_paths(project, nodes.registry);
        inputs.insert(inputs.end(), read.begin(), read.end());
        if (problems.has_errors()) return {};
        const ExportRequest request{std::move(project), file,    nodes.registry,
                                    material(),         *opened, mesh,
                                    double_sided,       size};
        return export_material(*find_host(to), request, output, inputs_of_run(inputs), problems);
    }

    std::string material() const { return name.empty() ? material_name(file) : name; }
};

}  // namespace

void declare_export(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<ExportCommand>(
        app, run, "export", "A material as a host takes it: three.js, Godot, Blender, glTF ...");
    std::vector<std::string> names;
    for (const Host& host : hosts())
        names.emplace_back(host.name);
    sub.add_option("FILE", c.file, "A graph; - reads standard input");
    add_choice(sub, "--to", c.to, names, "The host; --list describes them");
    sub.add_option("-o", c.output, "The folder of the files, made if it does not exist")
        ->type_name("FOLDER");
    declare_mesh(sub, c.mesh, "The mesh that maps are baked for, and that is exported with them: ");
    sub.add_option("--size", c.size, "Side of baked maps, in texels")
        ->check(CLI::Range(1U, max_export_size))
        ->capture_default_str()
        ->type_name("N");
    sub.add_option("--name", c.name, "Name of the material; default: from the file's name")
        ->type_name("NAME");
    sub.add_flag("--list", c.list, "Lists the hosts and the files of each");
    declare_common(sub, c.common);
}

}  // namespace wrinkle::cli
