// The built-in nodes as one plugin. all.cpp lists the files, each file its nodes.
#pragma once

struct wr_plugin;

namespace wrinkle {

const wr_plugin* built_in_nodes();

}  // namespace wrinkle
