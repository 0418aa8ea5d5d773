// Values of nodes on a flat surface seen from the front, by the CPU evaluator: no shader is built,
// and the values are those of `wrinkle eval`. uvs and positions are in units; the position is
// (u - 1, v - 0.5, 0), the normal +z, the tangent +x.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cpu/texture_store.h"
#include "editor/model/document/model.h"
#include "graph/document.h"

namespace wrinkle::editor {

// Points are the centers of width x height texels; (u, v) is the lower left corner.
struct FlatArea {
    double u = 0, v = 0, texel = 1;
    uint32_t width = 0, height = 0;
    bool operator==(const FlatArea&) const = default;
};

struct FlatValues {
    std::string node;
    PortType type = PortType::float_;
    size_t lanes = 1;
    std::vector<double> values;  // lanes of a point, points of a row, bottom row first
    std::string channel = {};    // shown channel; "": not a material
    std::vector<std::string> channels = {};
};

// Evaluates the shown output (request.h) of each node. Materials, and nodes that make nothing that
// can be shown, are left out. Returns false if the nodes do not compile together.
bool evaluate_flat(const Model& model, const Document& document,
                   const std::vector<std::string>& nodes, const FlatArea& area,
                   TextureStore& textures, std::vector<FlatValues>& result);

// Evaluates a node likewise; of a material the channel, or another one if it lacks that. Returns
// std::nullopt if there is nothing to show.
std::optional<FlatValues> evaluate_flat(const Model& model, const Document& document,
                                        const std::string& node, const std::string& channel,
                                        const FlatArea& area, TextureStore& textures);

// Returns the least and the greatest value; a constant has the range from 0 to 1.
Range range_of_values(const std::vector<double>& values);

// Display color of the lanes of a value: colors by the sRGB curve, vectors unchanged; a gradient, a
// derivative and a normal as the unit normal, 0.5 + 0.5 n; a height and a float as gray over
// `range`; a vec2 as its fractional part. Values that are not finite are magenta.
glm::dvec3 flat_color(PortType type, const double* lanes, const Range& range);

void append_texel(std::vector<uint8_t>& texels, glm::dvec3 color);  // RGBA
// Returns the display colors of all points; numbers and heights as gray over their range.
std::vector<uint8_t> texels_of(const FlatValues& values);

}  // namespace wrinkle::editor
