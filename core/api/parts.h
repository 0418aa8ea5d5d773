// What the handles of wrinkle/wrinkle.h stand for, and the border itself: problems as the caller
// gets them, and exceptions that become some.
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

// A graph made ready to be evaluated.
struct WRINKLE_INSIDE Prepared {
    Program program;
    std::vector<Texture> textures;
    Diagnostics problems;  // with an error nothing else is there
};

struct WRINKLE_INSIDE Graph::Parts {
    std::shared_ptr<const Library::Parts> library;
    Project project;
    Diagnostics problems;  // of reading, and of values that were set
    bool whole = false;    // else reading was stopped by what `unusable` says
    Problems unusable;

    // Made by the first who asks, for everybody; by vertex_tangents.
    mutable std::mutex mutex;
    mutable std::array<std::shared_ptr<const Prepared>, 2> prepared;
};

WRINKLE_INSIDE Problem problem_of(const Diagnostic& diagnostic);
WRINKLE_INSIDE Problems problems_of(const Diagnostics& diagnostics);

// Of a handle that holds nothing.
WRINKLE_INSIDE Problems no_graph();

// In a catch block: the exception under way as the one problem; none where there is no memory even
// for that.
WRINKLE_INSIDE Problems caught() noexcept;

// The arrays as the evaluator takes them, with `facing` where nobody gives it.
WRINKLE_INSIDE PointSet point_set(const Points& points, const Program& program, bool single,
                                  Diagnostics& diagnostics);

}  // namespace wrinkle::api
