#include "small_node.h"
SMALL_PLUGIN("old", "small", 77u)
