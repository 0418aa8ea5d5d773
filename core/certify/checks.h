// What a node is held to, one function a thing. Each adds to the report what it finds, and says
// nothing of a node that is fine. A node whose graphs do not compile is a finding of check_text()
// and nothing to the others.
#pragma once

#include "certify/report.h"
#include "certify/subject.h"

namespace wrinkle::certify {

// "descriptor": names, ranges, and a doc line for every port, with a unit where it is a length or
// an angle.
void check_descriptor(const NodeType& type, Report& report);

// "text": on every target, in both forms, with both kinds of parameters and of differentials.
// "deterministic": built twice it gives the same text.
// "round_trip": also after its graph went through the file.
void check_text(const NodeType& type, const Bench& bench, Report& report);

// "derivative": what the host derives from the body, against central differences in double. Images
// are left out: the derivative of a texture is a filtered one. More than one number in 50 at jumps
// or kinks is a finding too. "detach": the same of heights with what is detached as a constant, as
// bumps are made of them; a node may mean that.
void check_derivatives(const NodeType& type, const Bench& bench, Report& report);

// "uniform": a number means the same written into the text and in a uniform.
void check_uniforms(const NodeType& type, const Bench& bench, Report& report);

// "finite": on degenerate input, in float, in double, and on the GPU when there is one.
void check_finite(const NodeType& type, const Bench& bench, Report& report);

// "precision": float against double. "gpu": the CPU against generated GLSL, when there is a GPU.
// More than half of the values hanging on the last bits of their inputs is a finding too.
void check_parity(const NodeType& type, const Bench& bench, Report& report);

}  // namespace wrinkle::certify
