#include "small_node.h"
SMALL_PLUGIN("second", "smaller", WR_ABI)
