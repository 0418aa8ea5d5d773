#include "export/export.h"

#include "api/parts.h"
#include "base/text.h"
#include "compile/inputs.h"
#include "lower/types.h"
#include "mesh/load.h"
#include "mesh/shapes.h"

namespace wrinkle::api {
namespace {

// Returns a shape or the mesh of a file, and adds the file to `inputs`.
std::optional<Mesh> mesh_of(const std::string& name, Document& document,
                            std::vector<std::string>& inputs, bool& double_sided,
                            Diagnostics& problems) {
    if (std::optional<Mesh> shape = make_shape(name)) return shape;
    MeshFileOptions options;
    std::vector<std::filesystem::path> read;
    options.read = &read;
    options.double_sided = &double_sided;
    std::optional<Mesh> mesh = load_mesh(name, options, problems);
    inputs.push_back(name);
    for (const std::filesystem::path& path : read)
        inputs.push_back(path.string());
    if (mesh && double_sided) follow_double_sided(document, name, problems);
    return mesh;
}

std::vector<std::string> exported(const Graph::Parts& parts, const Host& host,
                                  const std::string& folder, const ExportOptions& options,
                                  Diagnostics& problems) {
    Project project = parts.project;
    std::vector<std::string> inputs;
    bool double_sided = false;
    const std::optional<Mesh> mesh =
        mesh_of(options.mesh, project.files[0].document, inputs, double_sided, problems);
    if (problems.has_errors()) return {};
    const Registry& registry = parts.library->registry;
    for (wrinkle::InputFile& file : inputs_of(project, Types(project, registry)))
        inputs.push_back(std::move(file.path));
    const std::string file = project.top().file;
    const ExportRequest request{std::move(project),
                                file,
                                registry,
                                options.name.empty() ? material_name(file) : options.name,
                                *mesh,
                                options.mesh,
                                double_sided,
                                options.size};
    return export_material(host, request, folder, inputs, problems);
}

}  // namespace

std::vector<std::string> hosts() noexcept {
    try {
        std::vector<std::string> names;
        for (const Host& host : wrinkle::hosts())
            names.emplace_back(host.name);
        return names;
    } catch (...) {
        return {};
    }
}

Exported Graph::export_to(const std::string& host, const std::string& folder,
                          const ExportOptions& options) const noexcept {
    Exported result;
    try {
        if (!parts_ || !parts_->whole) {
            result.problems = parts_ ? parts_->unusable : no_graph();
            return result;
        }
        Diagnostics problems = parts_->problems;
        const Host* found = find_host(host);
        if (!found)
            problems.error(RuleId::option, "there is no host '" + host + "'",
                           did_you_mean(host, hosts(), joined(hosts(), ", ")));
        if (options.size == 0 || options.size > max_export_size)
            problems.error(RuleId::option, "the size is " + std::to_string(options.size),
                           "1 to " + std::to_string(max_export_size));
        if (!problems.has_errors())
            result.files = exported(*parts_, *found, folder, options, problems);
        result.ok = !problems.has_errors();
        result.problems = problems_of(problems);
    } catch (...) {
        result = {};
        result.problems = caught();
    }
    return result;
}

}  // namespace wrinkle::api
