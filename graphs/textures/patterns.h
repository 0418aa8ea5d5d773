// The heights of the samples' textures over u, v in [0, 1). All of them tile; 0 is deepest, 1 is
// highest. Their slopes come along (dual.h).
#pragma once

#include "dual.h"

namespace wrinkle::textures {

Dual bricks(Dual u, Dual v);   // running bond, 4 by 8, each brick with its own height and tilt
Dual weave(Dual u, Dual v);    // plain weave of 8 by 8 twisted threads
Dual rivets(Dual u, Dual v);   // a plate with 4 by 4 round heads, seams and shallow dents
Dual pebbles(Dual u, Dual v);  // rounded stones of many sizes, one beside the other
Dual patches(Dual u, Dual v);  // a mask: soft-edged blotches of 0 and 1

}  // namespace wrinkle::textures
