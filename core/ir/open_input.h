// Inputs of functions that are still open.
//
// A sub-graph's body is lowered once, as ordinary instructions at level 0 over its own leaves:
// region_param(0, k), k an index into Module::open_inputs. So bumps, frames and surface inputs may
// occur in it as in any graph, and passes over the module treat it like the rest. A Region names
// the function (`first_input`), and calls of it are ordinary calls. expand() closes it
// (ir/open_function.h); its result contains no open functions.
//
// The facts that passes need about a leaf hold for every call: a function is specialised for each
// kind of arguments.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "ir/op.h"

namespace wrinkle {

// Axis of a derivative: the next pixel (of the value on the screen, or along the surface's tangent
// plane), an axis of space, or an axis of a uv set.
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
    // For the derivative of another input: its axis, and that input's index in Module::open_inputs.
    DiffAxis axis = DiffAxis::none;
    uint32_t of = 0;
    // Its own derivatives, by DiffAxis: their indices in Module::open_inputs; 0: not needed so far.
    std::array<uint32_t, static_cast<size_t>(DiffAxis::end)> derivatives{};
};

}  // namespace wrinkle
