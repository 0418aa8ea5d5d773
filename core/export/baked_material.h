// The standard outputs of a material over the uv layout of a mesh, in memory: hosts compute their
// maps from these values texel by texel.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "export/export.h"
#include "image/image.h"

namespace wrinkle {

// An output of the graph. Colors are linear; a normal is the vector of tangent space, m with
// n ~ m.x T + m.y B + m.z N, green up.
struct BakedOutput {
    std::string name;              // in base/standard_outputs.h
    uint32_t channels = 1;         // 1 or 3
    bool constant = false;         // the same in every texel of the surface
    std::array<float, 3> value{};  // the value if constant; of one channel, repeated
    std::vector<float> texels;     // rows from the bottom, interleaved; of a constant too
};

struct BakedMaterial {
    uint32_t width = 0, height = 0;
    std::vector<BakedOutput> outputs;        // in the order of the table
    std::vector<std::string> graph_outputs;  // all of the graph, also those not baked

    const BakedOutput* find(std::string_view name) const;  // null: the graph does not have it
    // Returns the value of an output at a texel, or the default of the table; [i] repeats the last
    // channel.
    std::array<float, 3> at(std::string_view name, size_t texel) const;
    // Returns true if none of these outputs varies over the surface.
    bool all_constant(std::initializer_list<std::string_view> names) const;
};

// Bakes the standard outputs but the vectors tangent and coat_tangent. Returns std::nullopt and
// appends errors on failure: a mesh without uv0, a graph with errors. Values that are not finite
// are reported.
std::optional<BakedMaterial> bake_outputs(const ExportRequest& request, Diagnostics& diagnostics);

// Returns an image of the size of the material; `texel` computes its channels at an index of
// BakedOutput::texels.
Image composed(const BakedMaterial& material, uint32_t channels,
               const std::function<std::array<float, 4>(size_t texel)>& texel);

}  // namespace wrinkle
