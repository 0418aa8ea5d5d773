// The writers of the hosts (Host::write), one file each.
#pragma once

#include "export/export.h"

namespace wrinkle {

bool write_gltf(const ExportRequest& request, const std::filesystem::path& folder,
                Diagnostics& diagnostics);
bool write_three(const ExportRequest& request, const std::filesystem::path& folder,
                 Diagnostics& diagnostics);
bool write_unity(const ExportRequest& request, const std::filesystem::path& folder,
                 Diagnostics& diagnostics);
bool write_unreal(const ExportRequest& request, const std::filesystem::path& folder,
                  Diagnostics& diagnostics);
bool write_blender(const ExportRequest& request, const std::filesystem::path& folder,
                   Diagnostics& diagnostics);
bool write_godot(const ExportRequest& request, const std::filesystem::path& folder,
                 Diagnostics& diagnostics);
bool write_godot3(const ExportRequest& request, const std::filesystem::path& folder,
                  Diagnostics& diagnostics);
bool write_materialx(const ExportRequest& request, const std::filesystem::path& folder,
                     Diagnostics& diagnostics);

}  // namespace wrinkle
