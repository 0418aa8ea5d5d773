// The table of conversions: which port types can be connected, and the conversion on the wire. The
// editor's badges, the reference page and the compiler all use it.
//
//   float <-> height, vec3 <-> color   the same numbers, another meaning
//   float, height -> color             a gray
//   height -> gradient                 differentiates along the surface, scale `surface`
//   derivative -> gradient             applies its frame
//   normal -> gradient                 extracts the perturbation, against the base of that input
//   gradient -> normal                 resolves
//   float -> gradient                  through height
//   float, height, derivative -> normal   through gradient
//
// Every other pair of different types is an error.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "registry/registry.h"

namespace wrinkle {

enum class Conversion : uint8_t {
    illegal,
    same,           // equal types
    rename,         // float <-> height, vec3 <-> color
    gray,           // float or height -> color
    differentiate,  // height or float -> gradient
    apply_frame,    // derivative -> gradient
    take_normal,    // normal -> gradient
    resolve,        // gradient -> normal
    differentiate_and_resolve,
    apply_frame_and_resolve,
};

Conversion conversion(PortType from, PortType to);
std::string_view doc(Conversion conversion);  // a short phrase: "differentiates along the surface"

std::vector<PortType> accepted_by(PortType to);  // types that may be connected, `to` first

// Returns a remedy for an illegal wire: "it takes gradient, float, ...; node 'x' makes one".
std::string alternative(PortType from, PortType to, const Registry& registry);

}  // namespace wrinkle
