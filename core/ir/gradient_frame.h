// Frames convert a slope dh/d(u,v) to a surface gradient. Part of the expansion pass.
//
// A frame is resolved to one of a few bases of the tangent plane, its FrameKey; every uv that is a
// function of one uv set shares that set's basis, so layers on it add as 2-vectors.
// J = d(uv)/d(set) converts a slope in the uv to one in the set: dh/d(set) = J^T dh/d(uv), divided
// by sqrt|det J| so that tiling does not steepen a `unit` slope; det J = 0 gives a flat gradient.
//
// docs/surface-gradient.md#frames defines the frames `vertex`, `derived`, `guess` and `exact`. Two
// more: `pixel`, an exact frame for slopes that already are screen differentials, and `space`, the
// exact frame of a uv that depends on the position only, without a screen differential. `derived`
// computes b = n x (v_y Px - v_x Py) first, which removes the component along n, then t = b x n of
// the same length.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ir/derive.h"
#include "ir/expand.h"
#include "ir/value.h"
#include "ir/value_analysis.h"

namespace wrinkle {

// Derivatives of values to the next pixel or along another axis; each direction is created when it
// is first used.
class ScreenDerivatives {
public:
    explicit ScreenDerivatives(Module& target) : target_(&target) {}

    // Derivative along an axis.
    Value along(DiffAxis axis, Id value);
    ForwardDiff& direction(DiffAxis axis);
    // Differential of the position, including its component along the normal.
    Value position(Variant axis);

private:
    Module* target_;
    std::array<std::optional<ForwardDiff>, static_cast<size_t>(DiffAxis::end)> directions_;
};

enum class Basis : uint8_t { vertex, derived_set, derived_uv, guess, exact, space };

struct FrameKey {
    Basis basis = Basis::exact;
    Id source = no_id;  // the uv set (as its number), the uv, or the direction
    bool operator==(const FrameKey&) const = default;
};

// A frame of the source module: its basis, and the rows that convert a slope in its uv to it.
struct Frame {
    FrameKey key;
    Value row_u, row_v;  // vec2: slope . row_u is the slope along the basis' u; empty: identity
    Value row_z;         // vec2: third row of a frame in space; the first two are along x and y
};

// T = t t_factor and B = b b_factor; zero if degenerate. The factors are applied to the slopes,
// which have two components, instead of to the vectors, which have six.
struct TangentBasis {
    Value t, b;                // vec3
    Value t_factor, b_factor;  // float; empty: 1

    Value along(Value slope) const;  // T s.x + B s.y
};

// How a frame is made: WR_FRAME_*, not auto, and the surface input that its uv is a function of, if
// it is a single one that the method can use.
struct FrameChoice {
    uint32_t method = WR_FRAME_exact;
    std::optional<SurfaceInput> source;
};

// Decides on the frame of a frame op's `extra`; `dependencies` are those of its uv. If method and
// scale do not match, a problem is recorded and a matching method is chosen.
FrameChoice choose_frame(Module& target, uint32_t extra, uint32_t dependencies,
                         const ExpandOptions& options);

Frame make_frame(Module& target, ScreenDerivatives& screen, Id uv, Id direction,
                 const FrameChoice& choice);

// Returns the vectors of the basis; `raw` omits the factor 1/|N| of a vertex basis.
TangentBasis tangent_basis(Module& target, const FrameKey& key, ScreenDerivatives& screen,
                           bool raw);

// Returns the slope converted to the frame's basis (screen differentials dh/dx, dh/dy for an exact
// one, a vec3 for one in space).
Value slope_in_basis(const Frame& frame, Value slope);

}  // namespace wrinkle
