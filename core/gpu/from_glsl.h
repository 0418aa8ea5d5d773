// Converts a generated shader and its reflection to inputs of the renderer and the point runner.
//
// Precondition: the shader has no problems and is in the function form. Uniforms get the values of
// the graph; samplers get the file name under which the image is opened.
#pragma once

#include "glsl/emit.h"
#include "gpu/material.h"
#include "gpu/point_runner.h"

namespace wrinkle::gpu {

// Precondition: differentials from the screen.
Material material_from(const Shader& shader);

// Precondition: given differentials. Output k of the job is function k, its value in the first
// components. The caller adds the points, the images, and for each member of the struct an
// attribute with the member's name.
PointJob point_job_from(const Shader& shader);

}  // namespace wrinkle::gpu
