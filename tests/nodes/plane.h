// Evaluates nodes on a plane, so that oracles are plain calculus: position (x, y, 0), normal (0, 0,
// 1), uv0 = (x, y), uv1 = 2 (x, y), tangent (1, 0, 0, +1); a pixel is 1/1024.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "cpu/evaluate.h"
#include "image/image.h"
#include "lower/material.h"

namespace wrinkle::test {

// The built-in nodes and the example plugin.
const Registry& registry();

inline constexpr double pixel = 1.0 / 1024;

struct Scene {
    std::string nodes;                      // the members of "nodes"
    std::string output;                     // "node.port"
    Image texture = {};                     // used for every image; empty: one grey texel of 0.5
    std::array<double, 3> normal{0, 0, 1};  // may differ from the plane's normal
    std::array<double, 3> view{0, 0, 1};
    std::map<std::string, Image> pictures = {};  // by file; these replace `texture`
};

// The output's components at each (x, y); if compiling fails, reports a test failure and returns an
// empty list.
std::vector<std::vector<double>> values(const Scene& scene,
                                        const std::vector<std::array<double, 2>>& points);
std::vector<double> value(const Scene& scene, double x = 0.3, double y = 0.6);

// The same at arbitrary points; and the points of the plane, for tests that modify some of them.
std::vector<std::vector<double>> values(const Scene& scene, const PointSet& points);
// The same for several outputs "node.port" instead of the scene's; the first index is the output.
std::vector<std::vector<std::vector<double>>> values(const Scene& scene,
                                                     const std::vector<std::string>& outputs,
                                                     const PointSet& points);
PointSet plane_points(const Scene& scene, const std::vector<std::array<double, 2>>& points);

// The same at one point, where compiling may report warnings.
std::vector<double> value_with_warnings(const std::string& nodes, const std::string& output);

// The diagnostics of compiling; "" on success.
std::string problems(const std::string& nodes, const std::string& output);

// One node "n" with these members of "in"; an image and a material are added if the type takes
// one.
std::string one(const std::string& type, const std::string& in = "");

// A float texture from a formula of texel centres (u, v) to r, g, b.
Image painted(uint32_t size, std::array<double, 3> (*formula)(double u, double v));

}  // namespace wrinkle::test
