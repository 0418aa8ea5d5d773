// Loads plugins of the tests into a separate registry.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "registry/plugin_loader.h"

namespace wrinkle::test {

inline const std::string plugin_folder = TEST_PLUGINS;

struct Loaded {
    Registry registry;
    Diagnostics diagnostics;
    std::vector<PluginReport> reports;
};

inline Loaded load(const std::vector<std::string>& places, const PluginOptions& options = {}) {
    Loaded loaded;
    loaded.reports = load_plugins(loaded.registry, places, loaded.diagnostics, options);
    return loaded;
}

}  // namespace wrinkle::test
