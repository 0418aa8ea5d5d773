// Data behind the handles of wrinkle/wrinkle.h, and conversion of diagnostics and exceptions to
// problems of the interface.
#pragma once

#include <wrinkle/wrinkle.h>

#include <array>
#include <mutex>

#include "compile/shader.h"
#include "cpu/columns.h"
#include "cpu/texture_store.h"
#include "graph/subgraph.h"
#include "registry/registry.h"

#define WRINKLE_INSIDE __attribute__((visibility("hidden")))

namespace wrinkle::api {

struct WRINKLE_INSIDE Library::Parts {
    Registry registry;
    Diagnostics problems;
};

// A graph that is compiled for evaluation.
struct WRINKLE_INSIDE Prepared {
    Program program;
    std::vector<Texture> textures;
    Diagnostics problems;  // after an error, the other members are empty
};

struct WRINKLE_INSIDE Graph::Parts {
    std::shared_ptr<const Library::Parts> library;
    Project project;
    Diagnostics problems;  // from reading and from with()
    bool whole = false;    // false: an exception stopped reading, see `unusable`
    Problems unusable;

    // Compiled by the first evaluate(), shared by all copies; by vertex_tangents.
    mutable std::mutex mutex;
    mutable std::array<std::shared_ptr<const Prepared>, 2> prepared;
};

WRINKLE_INSIDE Problem problem_of(const Diagnostic& diagnostic);
WRINKLE_INSIDE Problems problems_of(const Diagnostics& diagnostics);

// Problem of an empty handle.
WRINKLE_INSIDE Problems no_graph();

// Returns the current exception as a problem; an empty list if there is no memory for one.
// Precondition: called in a catch block.
WRINKLE_INSIDE Problems caught() noexcept;

// Converts the arrays to the evaluator's points, with 1 for a missing `facing`; reports problems.
WRINKLE_INSIDE PointSet point_set(const Points& points, const Program& program, bool single,
                                  Diagnostics& diagnostics);

}  // namespace wrinkle::api
