#include "export/export.h"

#include <algorithm>
#include <array>

#include "base/file.h"
#include "base/file_log.h"
#include "base/mapped.h"
#include "base/text.h"
#include "export/files.h"
#include "export/hosts.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

constexpr std::array host_table = {
    Host{"gltf", "glTF 2.0", "One .glb of the mesh, its baked maps and the KHR material extensions",
         write_gltf},
    Host{"materialx", "MaterialX",
         "A .mtlx of an open_pbr_surface: standard nodes, and baked maps of other outputs",
         write_materialx},
    Host{"three", "three.js",
         "A module with a MeshPhysicalMaterial that runs the graph's function, and a page",
         write_three},
    Host{"godot", "Godot 4", "A .gdshader, its material, textures and a project that shows them",
         write_godot},
    Host{"godot3", "Godot 3", "A .shader, its material, textures and a project that shows them",
         write_godot3},
    Host{"blender", "Blender", "A script that builds the material from baked maps, and the mesh",
         write_blender},
    Host{"unity", "Unity (URP)",
         "A shader with the graph's function, its material, textures and import settings",
         write_unity},
    Host{"unreal", "Unreal Engine",
         "Baked maps, an editor script that builds the material, and the graph's function",
         write_unreal},
};

// A new folder in the parent of `folder`, so that its files can be renamed into it; removed at the
// end.
class Staging {
public:
    Staging(const fs::path& folder, std::error_code& error)
        : name_(Temporary::beside(folder, error)) {
        if (!name_) return;
        remove_dead(folder.parent_path());
        path_ = name_->path().string() + extension;
        fs::create_directory(path_, error);
    }
    Staging(const Staging&) = delete;
    Staging& operator=(const Staging&) = delete;
    ~Staging() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove_all(path_, ignored);
    }
    const fs::path& path() const { return path_; }

private:
    // Removes the folders of killed programs: the file that reserves the name is missing.
    static void remove_dead(const fs::path& folder) {
        std::error_code error;
        std::vector<fs::path> dead;
        for (fs::directory_iterator at(folder, error), end; !error && at != end;
             at.increment(error))
            if (Temporary::is_name(at->path().filename().native()) &&
                at->path().extension() == extension &&
                !fs::exists(fs::path(at->path()).replace_extension(), error))
                dead.push_back(at->path());
        for (const fs::path& path : dead)
            fs::remove_all(path, error);
    }

    static constexpr const char* extension = ".files";
    std::optional<Temporary> name_;  // reserves the name
    fs::path path_;
};

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

std::vector<std::string> files_below(const fs::path& folder) {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files.push_back(entry.path().lexically_relative(folder).string());
    std::ranges::sort(files);
    return files;
}

bool same_bytes(const fs::path& a, const fs::path& b) {
    std::error_code error;
    if (fs::file_size(a, error) != fs::file_size(b, error) || error) return false;
    std::string ignored;
    const auto first = read_file(a, ~uint64_t{0}, ignored);
    return first && first == read_file(b, ~uint64_t{0}, ignored);
}

std::error_code move_file(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::create_directories(to.parent_path(), error);
    if (error || same_bytes(from, to)) return error;
    fs::rename(from, link_target(to), error);
    if (!error) log_output(to), log_replaced(to);
    return error;
}

// Messages name the files of the export, not those of the staging folder.
bool write_staged(const Host& host, const ExportRequest& request, const fs::path& staging,
                  const fs::path& folder, Diagnostics& diagnostics) {
    Diagnostics found;
    const bool written = host.write(request, staging, found);
    for (Diagnostic problem : found.list()) {
        replace_all(problem.message, staging.string(), folder.string());
        replace_all(problem.where.file, staging.string(), folder.string());
        diagnostics.add(std::move(problem));
    }
    return written;
}

}  // namespace

std::span<const Host> hosts() {
    return host_table;
}

const Host* find_host(std::string_view name) {
    const auto found = std::ranges::find(host_table, name, &Host::name);
    return found == host_table.end() ? nullptr : &*found;
}

std::vector<std::string> export_material(const Host& host, const ExportRequest& request,
                                         const fs::path& folder,
                                         std::span<const std::string> inputs,
                                         Diagnostics& diagnostics) {
    if (!is_identifier(request.name)) {
        diagnostics.error(RuleId::option,
                          "--name is " + json_quoted(request.name) +
                              "; an identifier is needed: letters, digits and single _, no digit "
                              "in front");
        return {};
    }
    if (request.project.top().outputs.empty()) {
        diagnostics.add(file_problem(Severity::error, RuleId::no_output, request.graph,
                                     "the graph has no outputs", "an entry in \"outputs\""));
        return {};
    }
    std::error_code error;
    const auto refused = [&](const fs::path& path) {
        report_unwritable(path, error, diagnostics);
        return std::vector<std::string>();
    };
    fs::path target = real_path(folder, error);
    if (!target.has_filename()) target = target.parent_path();
    if (!error) fs::create_directories(target.parent_path(), error);
    if (error) return refused(folder);
    const Staging staging(target, error);
    if (error) return refused(folder);
    if (!write_staged(host, request, staging.path(), folder, diagnostics)) return {};
    const std::vector<std::string> files = files_below(staging.path());
    const auto output_of = [&](const std::string& file) { return (folder / file).string(); };
    const std::string fault = overwrite_fault(mapped<std::string>(files, output_of), inputs);
    if (!fault.empty()) {
        diagnostics.error(RuleId::output_path, fault);
        return {};
    }
    for (const std::string& file : files)
        if ((error = move_file(staging.path() / file, target / file)))
            return refused(folder / file);
    return files;
}

}  // namespace wrinkle
