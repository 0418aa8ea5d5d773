// Data of the handles of wrinkle/wrinkle.hpp, and conversion of diagnostics and exceptions to
// problems of the interface.
#pragma once

#include <wrinkle/wrinkle.hpp>

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

// A graph compiled for evaluation.
struct WRINKLE_INSIDE Prepared {
    Program program;
    std::vector<Texture> textures;
    Diagnostics problems;  // after an error, `program` is empty
};

struct WRINKLE_INSIDE Graph::Parts {
    std::shared_ptr<const Library::Parts> library;
    Project project;
    Diagnostics problems;  // from reading and from with()
    bool whole = false;    // false: reading threw; `unusable` holds the exception
    Problems unusable;

    // Made by the first evaluate() and shared by all copies; index: vertex_tangents (0 or 1).
    mutable std::mutex mutex;
    mutable std::array<std::shared_ptr<const Prepared>, 2> prepared;
};

WRINKLE_INSIDE Problem problem_of(const Diagnostic& diagnostic);
// Appends an entry with the number of dropped diagnostics, if any.
WRINKLE_INSIDE Problems problems_of(const Diagnostics& diagnostics);

// Returns the error of a call on an empty handle.
WRINKLE_INSIDE Problems no_graph();

// Returns the current exception as a problem; an empty list if there is no memory for one.
// Precondition: called in a catch block.
WRINKLE_INSIDE Problems caught() noexcept;

// Returns the graph compiled for evaluation, which is done once for all copies.
WRINKLE_INSIDE std::shared_ptr<const Prepared> prepared_once(const Graph::Parts& parts,
                                                             bool vertex_tangents);

// Evaluates a program without errors and appends the problems of the points.
WRINKLE_INSIDE Evaluated evaluated_at(const Points& points, const Program& program,
                                      const std::vector<Texture>& textures, bool double_precision,
                                      Diagnostics problems);

// Returns the graph compiled for evaluation, which is done once for all copies.
WRINKLE_INSIDE std::shared_ptr<const Prepared> prepared_once(const Graph::Parts& parts,
                                                             bool vertex_tangents);

// Evaluates the program unless `problems` has errors; the result has those of the points too.
WRINKLE_INSIDE Evaluated evaluated_at(const Points& points, const Program& program,
                                      const std::vector<Texture>& textures, bool double_precision,
                                      Diagnostics problems);

// Returns the inputs that the program needs; a missing `facing` is 1. Reports unknown names, wrong
// lengths, non-finite numbers, zero normals and missing inputs; with `single`, also values that
// overflow float. After an error the result is incomplete. O(values).
WRINKLE_INSIDE PointSet point_set(const Points& points, const Program& program, bool single,
                                  Diagnostics& diagnostics);

}  // namespace wrinkle::api
