#include "ir/gradient_sum.h"

#include <algorithm>

#include "ir/surface.h"

namespace wrinkle {
namespace {

// Added along z to normals resolved on vertex tangents, at the cost of one addition. Lost in
// rounding, unless a tangent along the normal cancels the normal entirely. Its square is a normal
// float.
constexpr double min_normal = 1e-18;
constexpr std::string_view min_normal_name = "min_normal // of a tangent along the normal";

bool on_vertex_tangents(const Slopes::Slot& slot) {
    return slot.basis.basis == Basis::vertex;
}

constexpr auto linear_parts = {&Slopes::screen, &Slopes::volume, &Slopes::rest, &Slopes::along};

// Moves a common factor of both components of a vec2, such as an amplitude, to `factor`.
Value without_factor(Value pair, Value& factor) {
    Module& m = *pair.module;
    const Inst inst = m[pair.id];
    if (inst.op != Op::construct_ || !inst.arg[1]) return pair;
    const Inst x = m[inst.arg[0]], y = m[inst.arg[1]];
    if (x.op != Op::mul_ || y.op != Op::mul_ || x.arg[1] != y.arg[1]) return pair;
    factor = factor * Value{&m, x.arg[1]};
    return vec2(Value{&m, x.arg[0]}, Value{&m, y.arg[0]});
}

Slopes slopes_on(const FrameKey& basis, Value slope) {
    Slopes slopes;
    if (basis.basis == Basis::exact)
        slopes.screen = slope;
    else if (basis.basis == Basis::space)
        slopes.volume = slope;
    else
        slopes.slots.push_back({basis, slope});
    return slopes;
}

}  // namespace

GradientSum GradientAlgebra::from_slope(const FrameKey& basis, Value slope) {
    return {slopes_on(basis, slope), {}};
}

GradientSum GradientAlgebra::from_negated_slope(const FrameKey& basis, Value slope, Value depth) {
    GradientSum sum;
    sum.pending.push_back({slopes_on(basis, slope), depth});
    return sum;
}

Slopes GradientAlgebra::add(Slopes result, const Slopes& b) {
    for (const auto part : linear_parts)
        result.*part = sum_of(result.*part, b.*part);
    for (const Slopes::Slot& slot : b.slots) {
        const auto same = [&](const Slopes::Slot& other) { return other.basis == slot.basis; };
        const auto found = std::find_if(result.slots.begin(), result.slots.end(), same);
        if (found != result.slots.end()) {
            found->slope = named("slope", found->slope + slot.slope);
        } else if (result.slots.size() < max_slots) {
            result.slots.push_back(slot);
        } else {
            const TangentBasis basis = tangent_basis(*target_, slot.basis, *screen_, false);
            result.rest = sum_of(result.rest, basis.along(slot.slope));
        }
    }
    return result;
}

Slopes GradientAlgebra::scale(Slopes result, Value amount) {
    for (Slopes::Slot& slot : result.slots)
        slot.slope = named("slope", slot.slope * amount);
    for (const auto part : linear_parts)
        result.*part = product_of(result.*part, amount);
    return result;
}

void GradientAlgebra::divide(GradientSum& sum) {
    for (GradientSum::Term& term : sum.pending) {
        const Value inverse = number(term.denominator, -1) / term.denominator;
        sum.flat = add(std::move(sum.flat), scale(std::move(term.numerator), inverse));
    }
    sum.pending.clear();
}

GradientSum GradientAlgebra::add(GradientSum a, const GradientSum& b) {
    a.flat = add(std::move(a.flat), b.flat);
    for (const GradientSum::Term& term : b.pending) {
        const auto same = [&](const auto& other) {
            return other.denominator.id == term.denominator.id;
        };
        const auto found = std::find_if(a.pending.begin(), a.pending.end(), same);
        if (found != a.pending.end())
            found->numerator = add(std::move(found->numerator), term.numerator);
        else
            a.pending.push_back(term);
    }
    if (a.pending.size() > max_pending) divide(a);
    return a;
}

GradientSum GradientAlgebra::scale(GradientSum a, Value amount) {
    a.flat = scale(std::move(a.flat), amount);
    for (GradientSum::Term& term : a.pending)
        term.numerator = scale(std::move(term.numerator), amount);
    return a;
}

// Mikkelsen 2010, eq. 3: (hx R1 + hy R2) / det, R1 = Py x n and R2 = n x Px combined into one
// product.
Value GradientAlgebra::screen_gradient(Value slope) {
    const Value n{target_, unit_normal(*target_)};
    const Value area{target_, screen_area(*target_)};
    // A pixel of zero area gives a flat gradient.
    const Value inverse =
        surface_named("inverse_area", op(Op::sign_, area) / max(abs(area), min_area(area)));
    Value factor = inverse;
    const Value change = without_factor(slope, factor);
    const Value per_area = named("per_area", change * factor);
    const Value p_x = screen_->position(Variant::dx), p_y = screen_->position(Variant::dy);
    return cross(n, p_x * per_area.y() - p_y * per_area.x());
}

// A gradient on a resolved base is projected on it as one vector; its volume part is not projected
// on the surface first.
GradientAlgebra::Parts GradientAlgebra::parts(const Slopes& slopes, Value on_base, bool raw) {
    Value vec = slopes.rest;
    for (const Slopes::Slot& slot : slopes.slots)
        vec = sum_of(vec, tangent_basis(*target_, slot.basis, *screen_, raw).along(slot.slope));
    if (slopes.screen) vec = sum_of(vec, screen_gradient(slopes.screen));
    Value along = slopes.along;
    if (!on_base && slopes.volume)
        along = sum_of(along, -dot({target_, unit_normal(*target_)}, slopes.volume));
    vec = sum_of(vec, slopes.volume);
    if (on_base && vec) along = -dot(on_base, vec);
    return {vec, along};
}

Value GradientAlgebra::vector(const GradientSum& sum, Value on_base) {
    GradientSum divided = sum;
    divide(divided);
    const auto [vec, along] = parts(divided.flat, on_base, false);
    if (!vec || !along) return vec;
    return vec + (on_base ? on_base : Value{target_, unit_normal(*target_)}) * along;
}

// Returns all terms over one depth, the product of the pending ones, with downhill sign; if none is
// pending, with uphill sign and an empty `depth`.
Slopes GradientAlgebra::terms_over_depth(const GradientSum& sum, Value& depth) {
    if (sum.pending.empty()) return sum.flat;
    const GradientSum::Term& first = sum.pending[0];
    Slopes terms = first.numerator;
    depth = first.denominator;
    if (sum.pending.size() == 2) {
        const GradientSum::Term& second = sum.pending[1];
        terms = add(scale(first.numerator, second.denominator),
                    scale(second.numerator, first.denominator));
        depth = first.denominator * second.denominator;
    }
    return sum.flat.empty() ? terms : add(terms, scale(sum.flat, -depth));
}

Value GradientAlgebra::resolve(const GradientSum& sum, Value facing, Value sign, Value on_base) {
    Value depth;
    const Slopes slopes = terms_over_depth(sum, depth);
    // T, B and N of a vertex basis share the factor 1/|N|: without other terms it cancels too.
    const bool raw = !on_base && !slopes.empty() && !slopes.screen && !slopes.volume &&
                     !slopes.rest &&
                     std::all_of(slopes.slots.begin(), slopes.slots.end(), on_vertex_tangents);
    const Value n = on_base ? on_base
                            : Value{target_, raw ? target_->input(SurfaceInput::normal_)
                                                 : unit_normal(*target_)};
    const Value turn = on_base ? Value{} : facing;
    Parts gamma = parts(slopes, on_base, raw);
    if (!gamma.vec) return on_base || !turn ? n : n * turn;
    if (sign) gamma = {gamma.vec * sign, product_of(gamma.along, sign)};
    Value factor = depth && turn ? depth * turn : depth ? depth : turn;
    if (gamma.along) {
        if (!factor) factor = number(n, 1);
        factor = depth ? factor + gamma.along : factor - gamma.along;
    }
    const Value raised = factor ? n * factor : n;
    if (depth) named("raised", raised);
    const Value bumped = depth ? raised + gamma.vec : raised - gamma.vec;
    const bool may_vanish =
        !on_base && std::any_of(slopes.slots.begin(), slopes.slots.end(), on_vertex_tangents);
    if (!may_vanish) return normalize(bumped);
    named("gradient", gamma.vec);
    named("bumped", bumped);
    return normalize(vec3(bumped.xy(), bumped.z() + constant(min_normal_name, bumped, min_normal)));
}

}  // namespace wrinkle
