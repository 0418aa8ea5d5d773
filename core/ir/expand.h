// The surface-gradient algebra, in one place: opaque gradients, frames and derivatives become
// ordinary arithmetic, and each resolve one normalize.
//
// A gradient is held as a small fixed sum: one 2-vector of slopes per frame (layers on one frame
// add as 2-vectors and the frame is applied once), one 2-vector of screen differentials (every
// `surface`-scale height, Mikkelsen 2010 eq. 3), one volume vector (projected once), and the rest
// as a tangent vector. resolve gives normalize(n - Gamma). Formulas, clamps and sources:
// docs/surface-gradient.md.
#pragma once

#include "ir/module.h"
#include "ir/surface.h"

namespace wrinkle {

// What is left of `with_covariance`: nothing, or all of it, on every slope and normal that a bump
// is made of and that is read from a picture too. A module that keeps it is not run: what asks for
// it (ir/covariance.h) writes that down, and drops the rest.
enum class Covariances : uint8_t { dropped, kept };

struct ExpandOptions {
    bool vertex_tangents = true;  // false: `auto` frames of uv0 are derived (--no-tangents)
    BackFaces back_faces = BackFaces::mirror;
    Covariances covariances = Covariances::dropped;
};

// Decides the method of every frame and the uv set it belongs to, and reports a method that does
// not fit its scale and a base that is none. Parameters, but graph inputs, may be baked into
// literals in the same pass and not before: frames, bases and errors never depend on a value.
// (lower/material.h knows when literals from the start are as good.)
enum class Parameters : uint8_t { kept, baked };
Module settle_frames(Module source, const ExpandOptions& options,
                     Parameters parameters = Parameters::kept);

// A module without opaque ops, ddx and ddy; frames are settled where they are not. A sample
// whose uv jumps between pixels (floor, select, an angle, a march, a read shift) becomes a
// sample_grad with the uv's forward derivative, so that no seam of levels shows where it jumps.
// What cannot be expanded (a bump inside a loop, say) is a problem in the result.
Module expand(Module source, const ExpandOptions& options);

}  // namespace wrinkle
