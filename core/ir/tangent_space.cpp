#include "ir/tangent_space.h"

#include "ir/gradient_frame.h"
#include "ir/surface.h"

namespace wrinkle {
namespace {

constexpr double tiny_volume = 1e-30;
constexpr std::string_view volume_name = "min_volume // of the frame: smaller ones are flat";

Value times(Value vector, Value factor) {
    return factor ? vector * factor : vector;
}

}  // namespace

Value in_tangent_space(Module& module, Value normal, bool vertex_tangents) {
    ScreenDerivatives screen(module);
    FrameKey key{Basis::derived_set, static_cast<Id>(SurfaceInput::uv0_)};
    if (vertex_tangents) key = {Basis::vertex, poison};
    const TangentBasis basis = tangent_basis(module, key, screen, true);
    const Value t = times(basis.t, basis.t_factor);
    const Value b = times(basis.b, basis.b_factor);
    const Value n = vertex_tangents ? Value{&module, module.input(SurfaceInput::normal_)}
                                    : Value{&module, unit_normal(module)};
    // Cramer's rule; the magnitude of the volume cancels in the normalisation.
    const Value volume = dot(t, cross(b, n));
    const Value side = sign_nonzero(volume);
    const Value m = vec3(dot(normal, cross(b, n)) * side, dot(normal, cross(n, t)) * side,
                         dot(normal, cross(t, b)) * side);
    const Value up = vec3(number(m, 0), number(m, 0), number(m, 1));
    return select(greater(abs(volume), constant(volume_name, volume, tiny_volume)), normalize(m),
                  up);
}

Module with_tangent_space_normals(Module module, bool vertex_tangents) {
    for (ModuleOutput& output : module.outputs)
        if (output.port_type == WR_PORT_normal)
            output.value = in_tangent_space(module, {&module, output.value}, vertex_tangents).id;
    return module;
}

}  // namespace wrinkle
