// What the renderer and the point runner take, from a generated shader and its reflection.
//
// The shader is without problems and in the function form. Uniforms get the values of the graph;
// samplers keep the file under which the image is to be opened.
#pragma once

#include "glsl/emit.h"
#include "gpu/material.h"
#include "gpu/point_runner.h"

namespace wrinkle::gpu {

// With differentials from the screen.
Material material_from(const Shader& shader);

// With given differentials. Output k of the job is function k, its value in the first components.
// What remains to be added: the points, an attribute for each member of the struct under its name,
// the images.
PointJob point_job_from(const Shader& shader);

}  // namespace wrinkle::gpu
