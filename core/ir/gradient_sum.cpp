#include "ir/gradient_sum.h"

#include <algorithm>

#include "ir/surface.h"

namespace wrinkle {
namespace {

// A determinant of screen differentials is an area of (pixel size)^2; a higher floor would flatten
// bumps close up.
constexpr double smallest_area = 1e-36;

// Added to what is resolved on vertex tangents, along z, which is one addition: lost in rounding,
// but where a tangent along the normal takes all of it away. Its square is a normal float.
constexpr double least_normal = 1e-18;

bool on_vertex_tangents(const Slopes::Slot& slot) {
    return slot.basis.basis == Basis::vertex;
}

Value sum_of(Value a, Value b) {
    if (!a) return b;
    if (!b) return a;
    return a + b;
}

Value product(Value a, Value factor) {
    return a ? a * factor : a;
}

}  // namespace

GradientSum GradientAlgebra::from_slope(const FrameKey& basis, Value slope, Value depth) {
    Slopes slopes;
    if (basis.basis == Basis::exact)
        slopes.screen = slope;
    else if (basis.basis == Basis::space)
        slopes.volume = slope;
    else
        slopes.slots.push_back({basis, slope});
    GradientSum result;
    if (depth)
        result.pending.push_back({slopes, depth});
    else
        result.flat = slopes;
    return result;
}

Slopes GradientAlgebra::add(const Slopes& a, const Slopes& b) {
    Slopes result = a;
    result.screen = sum_of(a.screen, b.screen);
    result.volume = sum_of(a.volume, b.volume);
    result.rest = sum_of(a.rest, b.rest);
    for (const Slopes::Slot& slot : b.slots) {
        const auto same = [&](const Slopes::Slot& other) { return other.basis == slot.basis; };
        const auto found = std::find_if(result.slots.begin(), result.slots.end(), same);
        if (found != result.slots.end()) {
            found->slope = named("slope", found->slope + slot.slope);
        } else if (result.slots.size() < max_slots) {
            result.slots.push_back(slot);
        } else {
            const TangentBasis basis = tangent_basis(*target_, slot.basis, *screen_, false);
            result.rest = sum_of(result.rest, basis.t * slot.slope.x() + basis.b * slot.slope.y());
        }
    }
    return result;
}

Slopes GradientAlgebra::scale(const Slopes& a, Value amount) {
    Slopes result = a;
    for (Slopes::Slot& slot : result.slots)
        slot.slope = named("slope", slot.slope * amount);
    result.screen = product(a.screen, amount);
    result.volume = product(a.volume, amount);
    result.rest = product(a.rest, amount);
    return result;
}

void GradientAlgebra::divide(GradientSum& sum) {
    for (const GradientSum::Term& term : sum.pending) {
        const Value inverse = number(term.depth, 1) / term.depth;
        sum.flat = add(sum.flat, scale(term.over, inverse));
    }
    sum.pending.clear();
}

GradientSum GradientAlgebra::add(const GradientSum& a, const GradientSum& b) {
    GradientSum result = a;
    result.flat = add(a.flat, b.flat);
    for (const GradientSum::Term& term : b.pending) {
        const auto same = [&](const auto& other) { return other.depth.id == term.depth.id; };
        const auto found = std::find_if(result.pending.begin(), result.pending.end(), same);
        if (found != result.pending.end())
            found->over = add(found->over, term.over);
        else
            result.pending.push_back(term);
    }
    if (result.pending.size() > max_pending) divide(result);
    return result;
}

GradientSum GradientAlgebra::scale(const GradientSum& a, Value amount) {
    GradientSum result;
    result.flat = scale(a.flat, amount);
    for (const GradientSum::Term& term : a.pending)
        result.pending.push_back({scale(term.over, amount), term.depth});
    return result;
}

// Mikkelsen 2010, eq. 3.
Value GradientAlgebra::screen_gradient(Value slope) {
    const Value n{target_, unit_normal(*target_)};
    // What they hold along n drops out of both products.
    const Value p_x{target_, target_->input(SurfaceInput::position_, Variant::dx)};
    const Value p_y{target_, target_->input(SurfaceInput::position_, Variant::dy)};
    const Value r_x = surface_named("r_x", cross(p_y, n));
    const Value r_y = surface_named("r_y", cross(n, p_x));
    const Value det = surface_named("det", dot(p_x, r_x));
    // A pixel without an area is flat.
    const Value inverse =
        surface_named("inverse_det", op(Op::sign_, det) / max(abs(det), smallest_area));
    return (r_x * slope.x() + r_y * slope.y()) * inverse;
}

// A gradient on a resolved base is projected on it as a whole, its volume part straight from space.
Value GradientAlgebra::vector(const Slopes& slopes, Value on_base, bool raw) {
    Value gamma = slopes.rest;
    for (const Slopes::Slot& slot : slopes.slots) {
        const TangentBasis basis = tangent_basis(*target_, slot.basis, *screen_, raw);
        gamma = sum_of(gamma, basis.t * slot.slope.x() + basis.b * slot.slope.y());
    }
    if (slopes.screen) gamma = sum_of(gamma, screen_gradient(slopes.screen));
    const auto projected = [](Value v, Value n) { return v - n * dot(n, v); };
    if (on_base) {
        gamma = sum_of(gamma, slopes.volume);
        return gamma ? projected(gamma, on_base) : gamma;
    }
    if (slopes.volume)
        gamma = sum_of(gamma, projected(slopes.volume, {target_, unit_normal(*target_)}));
    return gamma;
}

Value GradientAlgebra::vector(const GradientSum& sum, Value on_base) {
    GradientSum divided = sum;
    divide(divided);
    return vector(divided.flat, on_base, false);
}

// All terms over one depth, the product of the pending ones (empty where there are none).
Slopes GradientAlgebra::over_common_depth(const GradientSum& sum, Value& depth) {
    if (sum.pending.empty()) return sum.flat;
    const GradientSum::Term& first = sum.pending[0];
    if (sum.pending.size() == 1) {
        depth = first.depth;
        return add(scale(sum.flat, depth), first.over);
    }
    const GradientSum::Term& second = sum.pending[1];
    depth = first.depth * second.depth;
    const Slopes terms = add(scale(first.over, second.depth), scale(second.over, first.depth));
    return sum.flat.empty() ? terms : add(scale(sum.flat, depth), terms);
}

Value GradientAlgebra::resolve(const GradientSum& sum, Value facing, Value sign, Value on_base) {
    Value depth;
    const Slopes slopes = over_common_depth(sum, depth);
    // T, B and N of a vertex basis share the factor 1/|N|: where nothing else stands beside them it
    // drops out too.
    const bool raw = !on_base && !slopes.screen && !slopes.volume && !slopes.rest &&
                     std::all_of(slopes.slots.begin(), slopes.slots.end(), on_vertex_tangents);
    const Value gamma = vector(slopes, on_base, raw && !slopes.empty());
    if (!gamma) {
        if (on_base) return on_base;
        const Value n{target_, unit_normal(*target_)};
        return facing ? n * facing : n;
    }
    Value n = on_base;
    if (!on_base)
        n = raw ? Value{target_, target_->input(SurfaceInput::normal_)}
                : Value{target_, unit_normal(*target_)};
    const Value turn = on_base ? Value{} : facing;
    const Value factor = depth && turn ? depth * turn : depth ? depth : turn;
    if (factor) n = n * factor;
    const Value bumped = sign ? n - gamma * sign : n - gamma;
    const bool may_vanish =
        !on_base && std::any_of(slopes.slots.begin(), slopes.slots.end(), on_vertex_tangents);
    if (!may_vanish) return normalize(bumped);
    named("gradient", gamma);
    named("bumped", bumped);
    return normalize(vec3(bumped.xy(), bumped.z() + number(bumped, least_normal)));
}

}  // namespace wrinkle
