#include "bake/map_values.h"

#include "base/normals.h"
#include "ir/surface.h"

namespace wrinkle {

Value slope_of_normal(Module& module, Value normal) {
    const Value n{&module, unit_normal(module)};
    const Value depth = dot(n, normal);
    const Value side = normal - n * depth;
    const Value least = op(Op::sqrt_, dot(side, side)) * (1 / max_slope);
    const Value divisor = max(max(depth, least), min_depth);
    const auto along = [&](Variant axis) {
        const Value change{&module, module.input(SurfaceInput::position_, axis)};
        return -(dot(side, change) / divisor);
    };
    return vec2(along(Variant::dx), along(Variant::dy));
}

}  // namespace wrinkle
