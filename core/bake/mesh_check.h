// Attributes of a mesh as inputs of a program, and checks before a bake. Errors and warnings use
// the mesh name given by the user.
#pragma once

#include <span>
#include <string>

#include "bake/maps.h"
#include "base/diagnostics.h"
#include "mesh/uv_survey.h"

namespace wrinkle {

// The values of an input at the vertices: lane k of vertex i is values[i * stride + k].
struct MeshAttribute {
    const float* values = nullptr;
    uint32_t stride = 0;
};

// Returns null values for an attribute that the mesh lacks. The view vector is the normal.
MeshAttribute attribute_of(const Mesh& mesh, SurfaceInput input);

// Returns the name of an input that the program needs and the mesh lacks, such as "uv1"; else "".
std::string missing_input(const Mesh& mesh, const Program& program);

// Returns false and appends an error if the mesh lacks uv0.
bool has_uv_layout(const Mesh& mesh, const std::string& name, Diagnostics& diagnostics);

// Returns false and appends an error if no triangle is in the baked unit square, or with `udim` in
// any UDIM tile. Warns about triangles without uv area, outside of these squares, or mirrored.
bool check_uvs(const UvSurvey& uvs, bool udim, const std::string& name, Diagnostics& diagnostics);

// Returns false and appends an error if the mesh lacks an attribute that a program reads.
bool check_inputs(const Mesh& mesh, std::span<const BakePlan> plans, const std::string& name,
                  Diagnostics& diagnostics);

}  // namespace wrinkle
