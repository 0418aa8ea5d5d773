// A registry of the nodes of nodes/, built once.
#pragma once

#include <gtest/gtest.h>

#include "nodes/all.h"
#include "registry/registry.h"

namespace wrinkle::test {

inline const Registry& linked_nodes() {
    static const Registry registry = [] {
        Registry made;
        Diagnostics diagnostics;
        EXPECT_TRUE(made.add_plugin(built_in_nodes(), Registry::built_in, diagnostics))
            << to_text(diagnostics);
        return made;
    }();
    return registry;
}

}  // namespace wrinkle::test
