#include "ir/surface.h"

#include "ir/value.h"

namespace wrinkle {

Id unit_normal(Module& module) {
    const Id normal = module.add(Op::normalize_, {module.input(SurfaceInput::normal_)});
    module.name(normal, 0, "normal");
    return normal;
}

Id surface_normal(Module& module, BackFaces back_faces) {
    const Value normal{&module, unit_normal(module)};
    if (back_faces == BackFaces::none) return normal.id;
    const Value facing{&module, module.input(SurfaceInput::facing_)};
    return (normal * facing).id;
}

bool is_surface_normal(const Module& module, Id id) {
    const auto is_input = [&](Id input, SurfaceInput which) {
        return module[input].op == Op::input_ &&
               module[input].extra == input_extra(which, Variant::value);
    };
    const bool turned =
        module[id].op == Op::mul_ && is_input(module[id].arg[1], SurfaceInput::facing_);
    const Inst& unit = module[turned ? module[id].arg[0] : id];
    return unit.op == Op::normalize_ && is_input(unit.arg[0], SurfaceInput::normal_);
}

Id projected_position(Module& module, Variant axis) {
    const Value normal{&module, unit_normal(module)};
    const Value change{&module, module.input(SurfaceInput::position_, axis)};
    const char* name = axis == Variant::dx ? "surface_dpdx" : "surface_dpdy";
    return surface_named(name, change - normal * dot(normal, change)).id;
}

Id screen_area(Module& module) {
    const Value normal{&module, unit_normal(module)};
    const Value p_x{&module, module.input(SurfaceInput::position_, Variant::dx)};
    const Value p_y{&module, module.input(SurfaceInput::position_, Variant::dy)};
    return surface_named("screen_area", dot(normal, cross(p_x, p_y))).id;
}

}  // namespace wrinkle
