// Modules built by hand in the form that lowering gives them.
#pragma once

#include "ir/module.h"
#include "ir/value.h"

namespace wrinkle::test {

// Adds nodes and reads as a graph does: node("weave", "Tangent normal map") becomes the current
// node.
uint32_t node(Module& module, const std::string& path, const std::string& title);

Id image(Module& module, const std::string& port, const std::string& file, Id uv,
         Encoding encoding = Encoding::linear);
Id parameter(Module& module, const std::string& port, double value, Type type = Type::float_);
void name(Module& module, const std::string& port, Id value);
void output(Module& module, const std::string& name, Id value, uint32_t port_type = WR_PORT_float);

// The sample of design section 7 before expansion: a base normal map, a detail map on a tiled uv
// set scaled by 0.6, added and resolved. `detail_first` selects which map's instructions are added
// first.
Module base_and_detail(SurfaceInput detail_uv = SurfaceInput::uv1_, bool detail_first = false);

}  // namespace wrinkle::test
