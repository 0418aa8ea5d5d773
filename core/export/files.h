// Files of an export: errors of writing, the README.txt that every host has, and warnings.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "emit/reflection.h"
#include "export/export.h"

namespace wrinkle {

void report_unwritable(const std::filesystem::path& path, std::error_code error,
                       Diagnostics& diagnostics);

// Writes a file of an export; creates its folder. Returns false and appends an error on failure.
bool write_export_file(const std::filesystem::path& path, std::string_view bytes,
                       Diagnostics& diagnostics);

// Writes README.txt: a title with the names of material and host, then `text`.
bool write_readme(const ExportRequest& request, std::string_view host, std::string_view text,
                  const std::filesystem::path& folder, Diagnostics& diagnostics);

// Appends a warning: the host has no counterpart of an output, "fuzz_weight", of the graph.
void warn_unsupported(const ExportRequest& request, std::string_view host, std::string_view output,
                      Diagnostics& diagnostics);

// Appends a warning for each uv set, and for colors, that a shader reads and the exported mesh
// lacks.
void warn_of_mesh(const ExportRequest& request, const Reflection& reflection,
                  Diagnostics& diagnostics);

}  // namespace wrinkle
