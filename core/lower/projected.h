// A warning at a node whose map is read on a projection along a plane (planar_uv, plane_uv, box_uv)
// while its port `scale` is left at `unit`: its slopes are then those of a map on a surface of its
// own, not the volume's bump that the triplanar nodes make of the same image
// (docs/surface-gradient.md, Projections). Writing the port, either way, is an answer. Uvs are
// followed through nodes of the family "uv".
#pragma once

#include "base/diagnostics.h"
#include "graph/document.h"
#include "registry/registry.h"

namespace wrinkle {

void warn_of_projection(const Document& document, const Node& node, const Registry& registry,
                        Diagnostics& diagnostics);

}  // namespace wrinkle
