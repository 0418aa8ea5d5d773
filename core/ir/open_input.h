// Inputs of open functions: sub-graph bodies before lambda lifting (ir/open_function.h).
//
// A sub-graph's body is lowered once, as instructions at level 0. Its inputs are
// region_param(0, k), where k is an index into Module::open_inputs. The body may contain bumps,
// frames and surface inputs, and passes over the module treat it like the rest. A Region with
// `first_input` represents the function; calls of it are ordinary calls. expand() closes all open
// functions.
//
// A function is specialised for each kind of arguments, so that the properties in OpenInput are
// valid for all of its calls.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "ir/op.h"

namespace wrinkle {

// Axis of a derivative: to the next pixel (`screen`: of the value on the screen; `surface`: along
// the surface's tangent plane), along an axis of space, or along an axis of a uv set.
enum class DiffAxis : uint8_t {
    none,
    screen_x,
    screen_y,
    surface_x,
    surface_y,
    space_x,
    space_y,
    space_z,
    uv0_u,  // then uv0_v, uv1_u, ... uv3_v
    end = uv0_u + 8,
};
constexpr bool is_y(DiffAxis axis) {  // the axis is y of the screen
    return axis == DiffAxis::screen_y || axis == DiffAxis::surface_y;
}
constexpr DiffAxis axis_of_uv(SurfaceInput set, int axis) {
    const int sets = static_cast<int>(set) - static_cast<int>(SurfaceInput::uv0_);
    return static_cast<DiffAxis>(static_cast<int>(DiffAxis::uv0_u) + 2 * sets + axis);
}

struct OpenInput {
    Type type = Type::float_;
    std::string name;
    uint32_t dependencies = 0;   // a bit per SurfaceInput that the arguments depend on
    bool discontinuous = false;  // as defined in ir/value_analysis.h
    bool samples_texture = false;
    bool tangent = false;  // vec3 only: a gradient, tangent to the surface
    // If this input is the derivative of another one: the axis, and the other input's index in
    // Module::open_inputs.
    DiffAxis axis = DiffAxis::none;
    uint32_t of = 0;
    // Inputs that are derivatives of this one: index in Module::open_inputs by DiffAxis; 0: none.
    std::array<uint32_t, static_cast<size_t>(DiffAxis::end)> derivatives{};
};

}  // namespace wrinkle
