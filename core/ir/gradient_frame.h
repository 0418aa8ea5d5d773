// Frames: what turns a slope dh/d(u,v) into a surface gradient. Part of the expansion pass.
//
// A frame is resolved to one of a few bases of the tangent plane, its FrameKey; every uv that is a
// function of one uv set shares that set's basis, so layers on it add as 2-vectors.
// J = d(uv)/d(set) brings a slope in the uv to the set: dh/d(set) = J^T dh/d(uv), divided by
// sqrt|det J| so that tiling does not steepen a `unit` slope; det J = 0 is flat.
//
//   vertex    T, B of MikkTSpace: B = sign(w) N x T from the un-normalised interpolated N and T;
//             T, B and N share the factor 1/|N|
//   derived   Mikkelsen 2020, GenBasisTB: T = normalize(sgn(det) (v_y Px - v_x Py)),
//             B = sgn(det) flip n x T, on the projected screen differentials; orthonormal,
//             sign-corrected, invariant under n -> -n. Here b = n x (v_y Px - v_x Py) comes first,
//             which drops what is along n, then t = b x n of the same length
//   guess     T = the direction's part in the tangent plane, B = n x T; flat where the direction
//             is parallel to n
//   exact     no basis of its own: a slope goes to screen differentials by the chain rule,
//             s . d(uv)/dx (eq. 3)
//   pixel     an exact frame of changes that are screen differentials already
//   space     the exact frame of a uv that changes with the position alone: a slope goes to a
//             gradient in space, s.x grad u + s.y grad v, with no differential of the screen
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ir/derive.h"
#include "ir/expand.h"
#include "ir/value.h"
#include "ir/value_facts.h"

namespace wrinkle {

// The changes of values to the next pixel or along something, each direction made when first asked
// for.
class ScreenDerivatives {
public:
    explicit ScreenDerivatives(Module& target) : target_(&target) {}

    // Along the tangent plane of the surface: for heights and uvs.
    Value along_surface(Variant axis, Id value);
    // Of the value as it stands on the screen: the ops ddx and ddy.
    Value on_screen(Variant axis, Id value);
    // The position's own, also along the normal.
    Value position(Variant axis);
    // Along x, y or z, as 0 to 2, of what changes with the position alone.
    Value in_space(int axis, Id value);
    // Along u or v of a uv set, as 0 and 1.
    Value in_uv_set(SurfaceInput set, int axis, Id value);
    // Along any of these; poison for zero.
    Id along(Change change, Id value);

private:
    Direction& direction(Change change);
    Module* target_;
    std::array<std::optional<Direction>, static_cast<size_t>(Change::end)> directions_;
};

enum class Basis : uint8_t { vertex, derived_set, derived_uv, guess, exact, space };

struct FrameKey {
    Basis basis = Basis::exact;
    Id source = poison;  // the uv set (as its number), the uv, or the direction
    bool operator==(const FrameKey&) const = default;
};

// A frame met in the source: its basis, and what brings a slope in its uv into that basis.
struct Frame {
    FrameKey key;
    Value row_u, row_v;  // vec2: slope . row_u is the slope along the basis' u; empty: identity
    Value row_z;         // vec2, the third of a frame in space, whose others are along x and y
    std::optional<std::array<double, 4>> numbers;  // row_u and row_v where they are constant
};

// T = t t_factor and B = b b_factor; zero where degenerate. The factors go to the slopes, which are
// two numbers where the vectors are six.
struct TangentBasis {
    Value t, b;                // vec3
    Value t_factor, b_factor;  // float; empty: 1

    Value along(Value slope) const;  // T s.x + B s.y
};

// `extra` of a frame op once settled: WR_FRAME with the method decided, and the uv set that its uv
// is a function of; one that is settled stays. `dependencies` are those of the uv. Where method and
// scale do not fit, a problem is recorded and one that fits is taken.
uint32_t settled_frame(Module& target, uint32_t extra, uint32_t dependencies,
                       const ExpandOptions& options);
// Whether method and scale fit, as `extra` of a frame op says them.
bool fits_its_scale(uint32_t extra, uint32_t dependencies);

Frame make_frame(Module& target, ScreenDerivatives& screen, Id uv, Id direction, uint32_t settled);

// The basis' vectors; `raw` leaves out the factor 1/|N| of a vertex basis.
TangentBasis tangent_basis(Module& target, const FrameKey& key, ScreenDerivatives& screen,
                           bool raw);

// A slope brought into the frame's basis (screen differentials dh/dx, dh/dy for an exact one, a
// vec3 for one in space).
Value slope_in_basis(const Frame& frame, Value slope);

}  // namespace wrinkle
