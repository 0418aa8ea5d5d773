// Checks of a node type. Each function adds its findings to the report. Graphs that do not compile
// are a finding of check_text() only; the other checks skip them.
#pragma once

#include "certify/report.h"
#include "certify/subject.h"

namespace wrinkle::certify {

// "descriptor": names, ranges, and a doc line for every port, with a unit if the port is a height
// or an angle.
void check_descriptor(const NodeType& type, Report& report);

// "text": the generated source compiles on every GLSL target, with both kinds of parameters and of
// differentials, in both forms (given differentials: the function form only).
// "deterministic": building twice gives the same source.
// "round_trip": writing the graph to a file and reading it gives the same graph and source.
void check_text(const NodeType& type, const CertifyContext& context, Report& report);

// "derivative": the derivative that the host derives from the body, against central differences in
// double. Graphs with images are skipped: the derivative of a texture is filtered. More than one
// number in 50 at jumps or kinks is also a finding.
// "detach": the same for heights, with detached values constant as in bumps, for constant inputs;
// a node may intend such a difference.
void check_derivatives(const NodeType& type, const CertifyContext& context, Report& report);

// "uniform": a number gives the same result as a literal and as a uniform.
void check_uniforms(const NodeType& type, const CertifyContext& context, Report& report);

// "finite": results are finite on degenerate input, in float, in double, and on the GPU if
// available.
void check_finite(const NodeType& type, const CertifyContext& context, Report& report);

// "precision": float against double; more than half of the values unstable (compare.h) is also a
// finding. "gpu": the CPU against generated GLSL, if a GPU is available.
void check_parity(const NodeType& type, const CertifyContext& context, Report& report);

}  // namespace wrinkle::certify
