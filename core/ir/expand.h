// The surface-gradient algebra: replaces opaque gradients, frames and derivatives by ordinary
// arithmetic, and each resolve by one normalize.
//
// A gradient is stored as a small fixed sum: one 2-vector of slopes per frame (layers on one frame
// add as 2-vectors and the frame is applied once), one 2-vector of screen differentials (every
// `surface`-scale height, Mikkelsen 2010 eq. 3), one volume vector (projected once), and the rest
// as a tangent vector. resolve gives normalize(n - Gamma). Formulas, clamps and sources:
// docs/surface-gradient.md.
#pragma once

#include "base/back_faces.h"
#include "ir/side_tables.h"

namespace wrinkle {

// The `with_covariance` instructions left after expansion: none, or all, on every slope and normal
// that a bump is made of, including those read from a texture. A module that keeps them is not
// executed: its user emits the covariances (ir/covariance.h) and drops the rest.
enum class Covariances : uint8_t { dropped, kept };

// `baked` turns parameters into literals of their values, except graph inputs.
enum class Parameters : uint8_t { kept, baked };

struct ExpandOptions {
    bool vertex_tangents = true;  // false: `auto` frames of uv0 are derived (--no-tangents)
    BackFaces back_faces = BackFaces::mirror;
    Covariances covariances = Covariances::dropped;
    Parameters parameters = Parameters::kept;
};

// Returns the module without opaque ops, ddx and ddy. The method of a frame, the uv set it belongs
// to and the base of a gradient follow from the source's expressions, where baked parameters still
// are parameters: they, and the problems recorded for them (a method that does not match its scale,
// an invalid base), never depend on a parameter's value. A sample with a uv that may be
// discontinuous between pixels (floor, select, atan2, a loop, a texture read), or that depends on a
// function's input, becomes a sample_grad with the uv's forward derivative, so that no mip-level
// seam is visible at the discontinuity. Code that cannot be expanded (e.g. a bump inside a loop) is
// recorded as a problem of the result.
Module expand(Module source, const ExpandOptions& options);

// The last rewrite of expand(): removes `detach`, removes `with_covariance` unless it is kept, and
// replaces normalize(v) by v * inversesqrt(dot(v, v)) if that factor is computed elsewhere too.
Module finish(Module expanded, Covariances covariances);

}  // namespace wrinkle
