// Checks that a mesh can be baked onto. Errors and warnings use the mesh name given by the user.
#pragma once

#include <span>
#include <string>

#include "bake/maps.h"
#include "base/diagnostics.h"
#include "mesh/uv_survey.h"

namespace wrinkle {

bool has_uv_layout(const Mesh& mesh, const std::string& name, Diagnostics& diagnostics);

// Returns false and appends an error if no triangle is in the baked unit square, or with `udim` in
// any UDIM tile. Warns about triangles without uv area, outside of these squares, or mirrored.
bool check_uvs(const UvSurvey& uvs, bool udim, const std::string& name, Diagnostics& diagnostics);

// Returns false and appends an error if the mesh lacks an attribute that a program reads.
bool check_inputs(const Mesh& mesh, std::span<const BakePlan> plans, const std::string& name,
                  Diagnostics& diagnostics);

}  // namespace wrinkle
