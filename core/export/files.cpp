#include "export/files.h"

#include "bake/mesh_check.h"
#include "base/file.h"
#include "ir/op.h"

namespace wrinkle {
namespace fs = std::filesystem;

void report_unwritable(const fs::path& path, std::error_code error, Diagnostics& diagnostics) {
    diagnostics.add(file_problem(Severity::error, RuleId::file_unwritable, path.string(),
                                 "cannot be written: " + error.message(),
                                 "a folder that can be written to and has room"));
}

bool write_export_file(const fs::path& path, std::string_view bytes, Diagnostics& diagnostics) {
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) return report_unwritable(path, error, diagnostics), false;
    std::string why;
    if (write_file(path, bytes, why)) return true;
    diagnostics.add(file_problem(Severity::error, RuleId::file_unwritable, path.filename().string(),
                                 why, "a folder that can be written to and has room"));
    return false;
}

bool write_readme(const ExportRequest& request, std::string_view host, std::string_view text,
                  const fs::path& folder, Diagnostics& diagnostics) {
    std::string readme = request.name + " for " + std::string(host);
    readme += "\n" + std::string(readme.size(), '=') + "\n\n" + std::string(text);
    return write_export_file(folder / "README.txt", readme, diagnostics);
}

void warn_unsupported(const ExportRequest& request, std::string_view host, std::string_view output,
                      Diagnostics& diagnostics) {
    diagnostics.add(file_problem(
        Severity::warning, RuleId::host_lacks, request.graph,
        "the output '" + std::string(output) + "' has no counterpart in " + std::string(host),
        "it is left out of the export"));
}

void warn_of_mesh(const ExportRequest& request, const Reflection& reflection,
                  Diagnostics& diagnostics) {
    for (const MemberInfo& member : reflection.members) {
        const std::string name(info(member.input).name);
        const bool read = name.starts_with("uv") || member.input == SurfaceInput::color0_;
        if (read && !attribute_of(request.mesh, member.input).values)
            diagnostics.add(file_problem(Severity::warning, RuleId::mesh_attribute,
                                         request.mesh_name, "the mesh lacks '" + name + "'",
                                         "the graph reads it; hosts read zeros"));
    }
}

}  // namespace wrinkle
