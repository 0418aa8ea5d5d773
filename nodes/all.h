// The built-in nodes, as one plugin. Its list stands in all.cpp; nothing registers itself.
#pragma once

#include "wrinkle/plugin.h"

namespace wrinkle {

const wr_plugin* built_in_nodes();

}  // namespace wrinkle
