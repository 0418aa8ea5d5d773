// wrinkle import FOLDER|FILE.mtlx -o GRAPH: makes the graph of a material from a set of textures or
// from a MaterialX document.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/file.h"
#include "base/limits.h"
#include "base/mapped.h"
#include "base/text.h"
#include "cli/arguments.h"
#include "cli/cli.h"
#include "cli/meshes.h"
#include "cli/output.h"
#include "graph/write.h"
#include "import/material_graph.h"
#include "import/mtlx_material.h"
#include "materialx/document.h"
#include "mesh/uv_survey.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

struct ImportCommand {
    CommonOptions common;
    std::vector<std::string> inputs;
    std::string output, green, mesh, material;
    std::vector<double> texel;
    std::optional<double> height;

    int run() const {
        if (const std::string why = wrong_usage(); !why.empty()) return fail(exit_usage, why);
        Diagnostics problems;
        const std::string text = graph_text(problems);
        const int code = report(problems, common.diagnostics);
        return code == exit_success ? write_result(output, text) : code;
    }

    std::string wrong_usage() const {
        if (is_materialx()) {
            if (inputs.size() > 1) return "one MaterialX document is imported at a time";
            if (!green.empty() || !mesh.empty() || !texel.empty() || height)
                return "--green, --mesh, --texel and --height are options of textures";
        } else if (!material.empty()) {
            return "--material is an option of MaterialX documents";
        }
        if (texel.size() > 2) return "--texel takes one size or two";
        for (const double size : texel)
            if (!(size >= 1e-9 && size <= 1e6)) return "--texel takes sizes from 1e-9 to 1e6";
        if (height && !(std::abs(*height) <= 1e6)) return "--height takes a length up to 1e6";
        std::error_code error;
        if (output != "-" && fs::is_directory(output, error))
            return "-o " + output + " is a folder; name the graph in it";
        return {};
    }

    // Returns "" after an error.
    std::string graph_text(Diagnostics& problems) const {
        return is_materialx() ? text_of_materialx(problems) : text_of_textures(problems);
    }

    bool is_materialx() const {
        return std::ranges::any_of(
            inputs, [](const std::string& input) { return input.ends_with(".mtlx"); });
    }

    std::string text_of_materialx(Diagnostics& problems) const {
        const fs::path file = inputs.front();
        std::string why;
        const auto text = read_file(file, limit_of(Limit::file_bytes), why);
        if (!text) {
            problems.add(file_problem(Severity::error, RuleId::file_unreadable, inputs.front(), why,
                                      "a MaterialX document"));
            return {};
        }
        const auto document = materialx::read_document(*text, inputs.front(), problems);
        if (!document) return {};
        const fs::path folder = file.parent_path();
        const materialx::MaterialOptions options{folder.empty() ? "." : folder, graph_folder(),
                                                 material};
        auto made = materialx::material_graph(*document, options, problems);
        if (!made) return {};
        made->images.push_back(inputs.front());
        check_read(made->images, problems);
        return problems.has_errors() ? std::string() : canonical_text(made->graph);
    }

    std::string text_of_textures(Diagnostics& problems) const {
        auto set = textures::find_textures(mapped<fs::path>(inputs, std::identity()), problems);
        if (!set) return {};
        check_files(*set, problems);
        textures::GraphOptions options = graph_options(problems);
        if (problems.has_errors()) return {};
        textures::ExamineOptions examine;
        if (!green.empty()) examine.green = green == "dx" ? maps::Green::dx : maps::Green::gl;
        if (!examine_textures(*set, examine, problems)) return {};
        return canonical_text(material_graph(*set, options));
    }

    fs::path graph_folder() const {
        const fs::path folder = output == "-" ? fs::path() : fs::path(output).parent_path();
        return folder.empty() ? "." : folder;
    }

    // The graph must be able to read the images, and must not replace one of them.
    void check_files(const textures::TextureSet& set, Diagnostics& problems) const {
        std::vector<std::string> read;
        for (const auto& texture : set.channels)
            if (texture) read.push_back(texture->file.string());
        check_read(read, problems);
    }

    void check_read(const std::vector<std::string>& read, Diagnostics& problems) const {
        const fs::path root = root_folder();
        const auto is_outside = [&](const std::string& file) { return !inside(root, file); };
        const auto outside = std::ranges::find_if(read, is_outside);
        if (outside != read.end())
            problems.add(file_problem(
                Severity::error, RuleId::outside_root, *outside,
                "is not below " + real_path(root).string() + ", where the graph reads files",
                "write the graph into the folder of the images or one above it, or name such a "
                "folder as --root here and wherever the graph is read"));
        const std::string made[] = {output};
        if (const std::string why = overwrite_fault_of_run(made, read); !why.empty())
            problems.error(RuleId::output_path, why);
    }

    fs::path root_folder() const {
        return common.root.empty() ? graph_folder() : fs::path(common.root);
    }

    textures::GraphOptions graph_options(Diagnostics& problems) const {
        textures::GraphOptions options;
        options.folder = graph_folder();
        options.height = height;
        if (!texel.empty()) options.texel = {texel.front(), texel.back()};
        if (mesh.empty()) return options;
        const auto opened = open_mesh(mesh, common, problems);
        if (!opened) return options;
        const double length = uv_length(*opened);
        if (length > 0 && std::isfinite(length))
            options.uv_length = length;
        else
            problems.add(file_problem(Severity::error, RuleId::mesh_uvs, mesh,
                                      "has no uv, so no size of a texel",
                                      "a mesh with texture coordinates, or --texel"));
        return options;
    }
};

}  // namespace

void declare_import(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<ImportCommand>(app, run, "import",
                                               "The graph of a material made from its textures "
                                               "or from a MaterialX document");
    sub.add_option("INPUT", c.inputs,
                   "A folder with the textures of a material, its images, or a file .mtlx")
        ->required();
    sub.add_option("-o", c.output, "The graph to write; - is standard output")
        ->type_name("GRAPH")
        ->required();
    add_choice(sub, "--green", c.green, {"gl", "dx"},
               "Where green of the normal map points: up or down; default: by its name, else by "
               "its slopes");
    sub.add_option("--texel", c.texel,
                   "Width, or width and height, of a texel in length units of object space")
        ->delimiter(',')
        ->allow_extra_args(false)  // the next word may be an image
        ->type_name("W[,H]");
    declare_mesh(sub, c.mesh,
                 "The mesh that it is made for: gives the size of a texel, or with --texel how "
                 "often the textures repeat: ");
    sub.add_option("--height", c.height,
                   "Height of white over black in length units; default: by the normal map, else "
                   "0.02 of a repeat")
        ->type_name("H");
    sub.add_option("--material", c.material,
                   "The material of the MaterialX document; default: the only one")
        ->type_name("NAME");
    sub.add_option("--root", c.common.root,
                   "Where the images must lie; default: the folder of the graph")
        ->type_name("DIR");
    declare_diagnostics(sub, c.common.diagnostics);
}

}  // namespace wrinkle::cli
