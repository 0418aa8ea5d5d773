// Helpers of the bake tests: graphs compiled for a bake, and complete images of lanes.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "bake/bake.h"
#include "bake/maps.h"
#include "lower/material.h"

namespace wrinkle::test {

// Compiles a graph of these nodes and outputs (JSON objects without braces) for a bake.
Module bake_module(const std::string& nodes, const std::string& outputs, bool tangents = true);
Module bake_module_of(const std::string& text, bool tangents = true,
                      Covariances covariances = Covariances::kept);

BakePlan plan_of(const Module& module, const std::vector<std::string>& maps,
                 const MapOptions& options = {}, bool integers = true);

// Rows of a bake, from the top.
struct LanePicture {
    uint32_t width = 0;
    size_t lanes = 0;
    std::vector<float> values;
    std::vector<uint8_t> covered;
    BakeStatistics findings;

    // The lanes of texel (x, y); row 0 is the bottom row.
    const float* at(uint32_t x, uint32_t y) const { return values.data() + texel(x, y) * lanes; }
    uint8_t covered_at(uint32_t x, uint32_t y) const { return covered[texel(x, y)]; }

private:
    size_t texel(uint32_t x, uint32_t y) const {
        return covered.size() - size_t{y + 1} * width + x;
    }
};
struct BakeHow {
    uint32_t width = 128, height = 128, samples = 1, dilate = 0, threads = 1;
    uint32_t first = 0, last = ~0U;
    std::span<const Texture> textures = {};
};
LanePicture bake_lanes(const Mesh& mesh, const Program& program, const BakeHow& how = {},
                       const std::vector<uint32_t>& unit = {});

}  // namespace wrinkle::test
