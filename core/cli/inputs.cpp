// wrinkle inputs FILE...: what a build system must watch.
#include "cli/inputs.h"

#include <memory>
#include <set>

#include "base/text.h"
#include "cli/output.h"
#include "cli/session.h"
#include "lower/named_images.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

// A path made short is another place where a folder on the way is a link.
std::string spelled(const fs::path& wanted, const fs::path& real) {
    const fs::path shorter = wanted.lexically_normal();
    std::error_code error;
    const bool same = !fs::exists(real, error) || fs::equivalent(shorter, real, error);
    return same && !error ? shorter.string() : real.string();
}

class Collector {
public:
    void add(InputFile::Kind kind, std::string path) {
        if (seen_.insert(path).second) files.push_back({kind, std::move(path)});
    }

    std::vector<InputFile> files;

private:
    std::set<std::string> seen_;
};

struct InputsCommand {
    CommonOptions common;
    std::vector<std::string> files;
    bool json = false;

    int run() const {
        Diagnostics diagnostics;
        const Nodes nodes = load_nodes(common, diagnostics);
        std::string entries;
        Collector all;
        for (const std::string& file : files) {
            Diagnostics own;
            const Project project = open_project(file, common, own);
            diagnostics.append(own);
            const auto inputs = inputs_of(project, Types(project, nodes.registry));
            entries += (entries.empty() ? "\n  " : ",\n  ") + entry(file, inputs);
            for (const InputFile& input : inputs)
                all.add(input.kind, input.path);
        }
        const int code = report(diagnostics, common.diagnostics);
        if (code != exit_fine) return code;
        const std::string text =
            json ? "{\"version\": 1, \"graphs\": [" + entries + "\n]}\n" : lines(all.files);
        return write_result("-", text) ? exit_fine : exit_environment;
    }

    static std::string entry(const std::string& file, const std::vector<InputFile>& inputs) {
        std::string text = "{\"file\": " + json_quoted(file) + ", \"inputs\": [";
        const char* separator = "\n    ";
        for (const InputFile& input : inputs) {
            text += separator + ("{\"path\": " + json_quoted(input.path)) + ", \"kind\": \"" +
                    std::string(name_of(input.kind)) + "\"}";
            separator = ",\n    ";
        }
        return text + "]}";
    }

    static std::string lines(const std::vector<InputFile>& inputs) {
        std::string text;
        for (const InputFile& input : inputs)
            text += input.path + "\n";
        return text;
    }
};

}  // namespace

std::string_view name_of(InputFile::Kind kind) {
    return kind == InputFile::Kind::graph   ? "graph"
           : kind == InputFile::Kind::image ? "image"
                                            : "plugin";
}

std::vector<InputFile> inputs_of(const Project& project, const Types& types) {
    Collector found;
    std::error_code ignored;
    for (const Project::File& file : project.files)
        if (&file != project.files.data() || fs::is_regular_file(file.path, ignored))
            found.add(InputFile::Kind::graph, spelled(file.document.file, file.path));
    for (size_t f = 0; f < project.files.size(); ++f) {
        const fs::path folder = fs::path(project.files[f].document.file).parent_path();
        std::set<std::string> names;  // many nodes may read one image
        for (const NamedImage& image : named_images(project, types, f))
            if (image.path && names.insert(image.name).second)
                found.add(InputFile::Kind::image, spelled(folder / image.name, *image.path));
    }
    for (size_t f = 0; f < project.files.size(); ++f)
        for (size_t i = 0; i < project.files[f].document.nodes.size(); ++i) {
            const NodeType* type = types.of(f, i);
            if (type && type->code) found.add(InputFile::Kind::plugin, type->origin);
        }
    return std::move(found.files);
}

void declare_inputs(CLI::App& app, Run& run) {
    auto command = std::make_shared<InputsCommand>();
    CLI::App& sub = *app.add_subcommand("inputs", "Lists every file that graphs read");
    sub.add_option("FILE", command->files, "Graphs; - reads standard input")->required();
    sub.add_flag("--json", command->json, "As JSON: for each graph its inputs with their kind");
    declare_common(sub, command->common, false);
    sub.callback([command, &run] { run = [command] { return command->run(); }; });
}

}  // namespace wrinkle::cli
