// A warning at a node with a map that is read on a projection along a plane (planar_uv, plane_uv,
// box_uv) while its port `scale` has no written value and the default `unit`: its slopes are then
// those of a map on a separate surface, not the volume's bump that the triplanar nodes make of the
// same image (docs/surface-gradient.md, Projections). Writing either value at the port removes the
// warning. Uvs are followed through nodes of the family "uv".
#pragma once

#include "base/diagnostics.h"
#include "graph/document.h"
#include "registry/registry.h"

namespace wrinkle {

void warn_of_projection(const Document& document, const Node& node, const Registry& registry,
                        Diagnostics& diagnostics);

}  // namespace wrinkle
