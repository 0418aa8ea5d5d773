// Limits on the size of inputs and of derived data; an environment variable overrides each. Sizes
// are checked before allocation, so a run rejects oversized input early with a diagnostic, and the
// result does not depend on the speed or memory of the machine.
//
// A variable holds a whole number from 1. report_limits() reports any other text, and limit_of()
// ignores it. docs/limits.md documents this table.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/diagnostics.h"

namespace wrinkle {

enum class Limit : uint8_t {
    file_bytes,
    graph_nodes,
    graph_calls,
    graph_values,
    text_bytes,
    image_side,
    image_pixels,
    image_bytes,
    all_images_bytes,
    mesh_bytes,
    mesh_corners,
    materialx_bytes,
};

struct LimitRow {
    std::string_view variable;
    uint64_t default_value;
    std::string_view unit;
    std::string_view doc;
};

// In the order of the enumerators.
inline constexpr std::array<LimitRow, 12> limit_rows = {{
    {"WRINKLE_FILE_MAX_BYTES", uint64_t{1} << 30, "bytes",
     "A file that is read, and standard input; not images and meshes, which have their own"},
    {"WRINKLE_GRAPH_MAX_NODES", 1'000'000, "nodes",
     "Nodes of a graph, each use of a sub-graph that is inlined counted by itself"},
    {"WRINKLE_GRAPH_MAX_CALLS", 100'000, "calls",
     "Calls of sub-graphs in what runs without functions: eval, bake, render"},
    {"WRINKLE_GRAPH_MAX_VALUES", 1'000'000, "values",
     "Values that a graph computes, derivatives and reads of fields among them"},
    {"WRINKLE_TEXT_MAX_BYTES", uint64_t{16} << 20, "bytes", "The text of one shader stage"},
    {"WRINKLE_IMAGE_MAX_SIDE", 16384, "texels", "Width and height of an image"},
    {"WRINKLE_IMAGE_MAX_PIXELS", uint64_t{1} << 27, "texels", "Width times height of an image"},
    {"WRINKLE_IMAGE_MAX_BYTES", uint64_t{2} << 30, "bytes",
     "An image in memory: width * height * channels * 4"},
    {"WRINKLE_IMAGES_MAX_BYTES", uint64_t{4} << 30, "bytes",
     "All images of a graph in memory together, with their mips"},
    {"WRINKLE_MESH_MAX_BYTES", uint64_t{1} << 30, "bytes",
     "A mesh's file, and all external files of it together"},
    {"WRINKLE_MESH_MAX_CORNERS", uint64_t{1} << 26, "corners",
     "Corners of a mesh's triangles, three each; elements of an accessor"},
    {"WRINKLE_MATERIALX_MAX_BYTES", uint64_t{16} << 20, "bytes", "A MaterialX document"},
}};

constexpr const LimitRow& row_of(Limit limit) {
    return limit_rows[static_cast<size_t>(limit)];
}

// Returns the value of the variable if it is valid, else the default. Reads the environment on each
// call.
uint64_t limit_of(Limit limit);

// Reports an error for each invalid variable; returns true if there is none.
bool report_limits(Diagnostics& diagnostics);

// Thrown when data exceeds its limit during construction: values of a module, generated text.
struct OverLimit : std::runtime_error {
    // `value` is the limit; `at` and `called` become `node` and `path`.
    OverLimit(Limit which, uint64_t value, uint32_t at, std::string called);

    Limit limit;
    uint32_t node;     // node that exceeded it, index into Module::nodes; 0: not one node
    std::string path;  // path of that node; "" if unknown at the throw
    std::string message, expected;
};

}  // namespace wrinkle
