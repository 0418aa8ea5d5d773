#include "ir/normal_variance.h"

#include <utility>

#include "ir/covariance.h"
#include "ir/module_cloner.h"
#include "ir/rewrite.h"

namespace wrinkle {
namespace {

bool is_arrangement(Op op) {
    return op == Op::swizzle_ || op == Op::construct_ || op == Op::neg_ || op == Op::add_ ||
           op == Op::sub_;
}

// Returns the single texture read that the value is an affine function of, as decoding makes it;
// no_id otherwise. Only affine functions map a mean to a mean.
Id picture_of(const Module& m, Id value) {
    Id read = no_id;
    bool affine = true;
    walk({&value, 1}, [&](Id id, std::vector<Id>& open) {
        if (m.is_constant(id)) return;
        const Inst& inst = m[id];
        const bool scaled =
            inst.op == Op::mul_ && (m.is_constant(inst.arg[0]) || m.is_constant(inst.arg[1]));
        if (is_sample(inst.op))
            affine = std::exchange(read, id) == no_id && affine;
        else if (is_arrangement(inst.op) || scaled)
            append_dependencies(m, id, false, open);
        else
            affine = false;
    });
    return affine ? read : no_id;
}

Value level_in_use(Module& m, ScreenDerivatives& screen, Id read) {
    const Inst inst = m[read];
    if (inst.op == Op::sample_lod_) return {&m, inst.arg[1]};
    if (inst.op == Op::sample_grad_)
        return {&m, sample_lod_of(m, inst.extra, inst.arg[1], inst.arg[2])};
    const Value x = screen.along(DiffAxis::screen_x, inst.arg[0]);
    const Value y = screen.along(DiffAxis::screen_y, inst.arg[0]);
    return {&m, sample_lod_of(m, inst.extra, x.id, y.id)};
}

}  // namespace

// Returns the variance along each direction across the mean, half of 1 - |mean|^2, in the units of
// `normal`; std::nullopt if `normal` is not a function of a single texture read.
std::optional<Value> NormalVariance::variance_lost_to_filtering(Value normal, double factor) {
    const Id read = picture_of(*target_, normal.id);
    if (read == no_id) return {};
    const Value none = number(normal, 0), one = number(normal, 1);
    const Value level = level_in_use(*target_, *screen_, read);
    const Value minified = named("minified", op(Op::clamp_, level, none, one));
    const double unit = factor * factor;
    const Value lost = max(one - dot(normal, normal) * unit, 0);
    return named("lost", lost * minified * (0.5 / unit));
}

// All directions across a unit mean have the same variance: I - m m^T. For -xy/z that is (I + s
// s^T) / z^2 with the slopes s, and for xy with z constant, as written here, I + s s^T.
Value NormalVariance::tangent_normal(Value normal, Value depth, double factor) {
    const std::optional<Value> lost = variance_lost_to_filtering(normal, factor);
    if (!lost) return normal.xy();
    const Value s = named("slope", normal.xy() / depth);
    const Value one = number(s, 1);
    const Value across = vec3(s.x() * s.x() + one, s.y() * s.y() + one, s.x() * s.y());
    return varying(normal.xy(), named("covariance", across * *lost));
}

Value NormalVariance::object_normal(Value normal, double factor) {
    const std::optional<Value> lost = variance_lost_to_filtering(normal, factor);
    return lost ? varying(normal, *lost) : normal;
}

Value NormalVariance::varying(Value value, Value covariance) {
    return op(Op::with_covariance_, value, covariance);
}

// Only components across the normal rotate it: dot(a, b) - dot(n, a) dot(n, b), over |bumped|^2.
Value NormalVariance::of(Value normal) {
    const Inst unit = (*target_)[normal.id];
    if (unit.op != Op::normalize_) return number(normal, 0);
    const Value bumped{target_, unit.arg[0]};
    Value sum;
    for (const auto& [a, b, weight] : covariance_terms(bumped)) {
        const Value across = dot(a, b) - dot(normal, a) * dot(normal, b);
        sum = sum_of(sum, across * weight);
    }
    return sum ? named("variance", max(sum / dot(bumped, bumped), 0)) : number(normal, 0);
}

Value NormalVariance::along(Value normal, Value x) {
    const Inst unit = (*target_)[normal.id];
    const Value none = vec3(number(normal, 0), number(normal, 0), number(normal, 0));
    if (unit.op != Op::normalize_) return none;
    const Value bumped{target_, unit.arg[0]}, y = named("across", cross(normal, x));
    Value sum;
    for (const auto& [a, b, weight] : covariance_terms(bumped)) {
        const Value ax = dot(a, x), ay = dot(a, y), bx = dot(b, x), by = dot(b, y);
        const Value term = vec3(ax * bx, ay * by, (ax * by + ay * bx) * 0.5);
        sum = sum_of(sum, term * weight);
    }
    return sum ? named("covariance", sum / dot(bumped, bumped)) : none;
}

bool wants_normal_variance(const Module& source) {
    const auto wants = [](Op op) {
        return op == Op::normal_variance_ || op == Op::normal_covariance_;
    };
    if (!source.has(Op::normal_variance_) && !source.has(Op::normal_covariance_)) return false;
    // Values that no output needs do not count.
    const std::vector<bool> needed = reachable(source);
    for (Id id = 1; id < source.size(); ++id)
        if (needed[id] && wants(source[id].op)) return true;
    return false;
}

}  // namespace wrinkle
