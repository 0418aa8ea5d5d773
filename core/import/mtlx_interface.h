// Exposed inputs of a graph for interfaces of node graphs and for constants of a shader.
#pragma once

#include "base/standard_outputs.h"
#include "graph/document.h"
#include "import/mtlx_value.h"
#include "materialx/document.h"

namespace wrinkle::materialx {

bool is_exposable(Type type);

// The exposed input of an interface <input>: uisoftmin and uisoftmax, else uimin and uimax, are its
// slider, uiname its label, uifolder its group; it has no limits. Precondition: `value` is a
// literal of an exposable type.
GraphInput interface_input(const Element& input, const Value& value);

// The exposed input of a constant of a shader, named and described as the output that it feeds.
GraphInput output_input(const StandardOutput& output, const Value& value);

}  // namespace wrinkle::materialx
