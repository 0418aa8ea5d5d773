#include "lower/decode.h"

#include "ir/value.h"

namespace wrinkle {
namespace {

Value vec4(Value a, Value b) {
    return {a.module, a.module->construct(Type::vec4_, {a.id, b.id})};
}

Value vec4(Value a, Value b, Value c, Value d) {
    return {a.module, a.module->construct(Type::vec4_, {a.id, b.id, c.id, d.id})};
}
Value vec4(Value ab, Value c, Value d) {
    return {ab.module, ab.module->construct(Type::vec4_, {ab.id, c.id, d.id})};
}

// Maps 0..1 to -1..1. The factor comes last: it cancels for a normal, which is normalized later.
Value spread(Value t) {
    return (t - number(t, 0.5)) * 2;
}

// IEC 61966-2-1; negative values of float images use the linear segment.
Value linear_from_srgb(Value c) {
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

Value decoded(Encoding encoding, Value t) {
    switch (encoding) {
        case Encoding::linear:
            return t;
        case Encoding::srgb:
            return vec4(linear_from_srgb(t.xyz()), t.w());
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

}  // namespace

Id decode(Module& module, Encoding encoding, Id texel) {
    if (texel == poison) return poison;
    return decoded(encoding, {&module, texel}).id;
}

}  // namespace wrinkle
