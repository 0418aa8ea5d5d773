#include "lower/sampling.h"

#include "ir/derive.h"
#include "ir/rewrite.h"
#include "ir/value.h"

namespace wrinkle {
namespace {

template <class... Values>
Value vec4(Value first, Values... rest) {
    return {first.module, first.module->construct(Type::vec4_, {first.id, rest.id...})};
}

// Maps 0..1 to -1..1. The factor comes last: it cancels for a normal, which is normalized later.
Value spread(Value t) {
    return (t - number(t, 0.5)) * 2;
}

// IEC 61966-2-1; negative values of float images use the linear segment.
Value linear_light(Value c) {
    const auto all = [&](double x) {
        const std::array<double, 3> lanes{x, x, x};
        return Value{c.module, c.module->constant(Type::vec3_, lanes)};
    };
    const Value curve = op(Op::pow_, (max(c, 0) + all(0.055)) / all(1.055), all(2.4));
    return op(Op::mix_, c / all(12.92), curve, op(Op::step_, all(0.04045), c));
}

Value with_depth(Value xy) {
    const Value square = number(xy, 1) - dot(xy, xy);
    return vec4(xy.x(), xy.y(), op(Op::sqrt_, max(square, 0)), number(xy, 1));
}

Value decoded(const TextureOptions& options, Value t) {
    switch (options.encoding) {
        case Encoding::linear:
            return t;
        case Encoding::srgb:
            return options.decodes_texels() ? t : vec4(linear_light(t.xyz()), t.w());
        case Encoding::normal_gl:
            return vec4(spread(t.xyz()), t.w());
        case Encoding::derivative:  // usually two components
            return vec4(spread(t.xy()), spread(t.z()), t.w());
        case Encoding::normal_dx: {
            const Value m = t.xyz() - number(t, 0.5);
            return vec4(vec3(m.x(), -m.y(), m.z()) * 2, t.w());
        }
        case Encoding::normal_rg:
            return with_depth(spread(t.xy()));
        case Encoding::normal_ag:  // red is 1 in DXT5nm files; files of two channels have no alpha
            return with_depth(spread(vec2(t.w() * t.x(), t.y())));
    }
    return t;
}

// Returns the ddx and ddy instructions that `value` needs.
std::vector<Id> screen_changes(const Module& module, Id value) {
    const std::vector<bool> needed = reachable(module, std::span(&value, 1));
    std::vector<Id> changes;
    for (Id id = 1; id < needed.size(); ++id)
        if (needed[id] && (module[id].op == Op::ddx_ || module[id].op == Op::ddy_))
            changes.push_back(id);
    return changes;
}

// Replaces an implicit sample with another uv by one with the differentials of its old uv. A region
// has no covariances.
Id with_differentials(void*, Module& target, const Module& source, Id id,
                      std::span<const Id> mapped) {
    const Inst inst = source[id];
    if (inst.op == Op::with_covariance_) return mapped[0];
    if (inst.op != Op::sample_ || mapped[0] == inst.arg[0]) return poison;
    const Id dx = target.add(Op::ddx_, {inst.arg[0]});
    const Id dy = target.add(Op::ddy_, {inst.arg[0]});
    return target.add(Op::sample_grad_, {mapped[0], dx, dy}, inst.extra);
}

}  // namespace

Id decode(Module& module, const TextureOptions& options, Id texel) {
    if (texel == poison) return poison;
    return decoded(options, {&module, texel}).id;
}

Id read_field(Module& module, Id value, SurfaceInput domain, Id at) {
    if (value == poison || at == poison) return poison;
    std::vector<Id> from{module.input(domain)}, to{at};
    if (module[at].level == 0) return substitute(module, value, from, to);
    for (const Id change : screen_changes(module, value)) {
        from.push_back(change);
        to.push_back(change);
    }
    return substitute(module, value, from, to, with_differentials);
}

Id sample_inside(Module& module, uint32_t resource, Id uv) {
    const auto change = [&](DiffAxis axis, Variant variant) {
        const Id found = direction_along(module, axis).jvp(uv);
        return found == no_id ? module.input(SurfaceInput::uv0_, variant) : found;
    };
    const Id dx = change(DiffAxis::screen_x, Variant::dx);
    const Id dy = change(DiffAxis::screen_y, Variant::dy);
    return module.add(Op::sample_grad_, {uv, dx, dy}, resource);
}

}  // namespace wrinkle
