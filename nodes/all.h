// The built-in nodes as one plugin. all.cpp lists them; there is no self-registration.
#pragma once

struct wr_plugin;

namespace wrinkle {

const wr_plugin* built_in_nodes();

}  // namespace wrinkle
