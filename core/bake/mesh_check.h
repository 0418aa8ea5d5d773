// Whether a mesh can be baked onto. Errors and warnings name it as the user does.
#pragma once

#include <span>
#include <string>

#include "bake/maps.h"
#include "base/diagnostics.h"
#include "mesh/uv_survey.h"

namespace wrinkle {

bool has_uv_layout(const Mesh& mesh, const std::string& name, Diagnostics& diagnostics);

// An error where nothing lies in the square that is baked, or with `udim` in any that has a number;
// warnings name what the uvs will not do.
bool check_uvs(const UvSurvey& uvs, bool udim, const std::string& name, Diagnostics& diagnostics);

// Whether it has what the programs read.
bool check_inputs(const Mesh& mesh, std::span<const BakePlan> plans, const std::string& name,
                  Diagnostics& diagnostics);

}  // namespace wrinkle
