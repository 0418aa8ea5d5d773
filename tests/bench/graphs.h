// Benchmark graphs, as JSON text of files in graphs/.
//
// Layers cycle through the images of graphs/textures, each with a different tiling, so that no two
// texture reads are equal. tests/bench/peers builds the same chains for other programs.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace wrinkle::bench {

inline constexpr std::array<const char*, 8> images = {
    "rivets_normal", "weave_normal",  "ball_object",    "pebbles_slopes",
    "weave_height",  "bricks_height", "pebbles_height", "patches_mask"};

// The node types that make a layer from an image and join two layers, and their output port.
struct Layering {
    const char* source;   // a node type
    const char* options;  // its inputs as JSON, ending in ", "
    const char* join;
    const char* output;
};
inline constexpr Layering normal_maps = {"tangent_normal_map", "", "gradient_add", "gradient"};
inline constexpr Layering heights = {"height_map", "\"quality\": \"three_taps\", ", "height_add",
                                     "height"};

inline std::string from(const std::string& link) {
    return "{\"from\": \"" + link + "\"}";
}

inline std::string chain(const Layering& layering, int64_t layers) {
    const std::string output = std::string(".") + layering.output;
    std::string nodes, sum;
    for (int64_t i = 0; i < layers; ++i) {
        const std::string number = std::to_string(i), tiling = std::to_string(i + 2);
        nodes += "\"tile" + number + "\": {\"type\": \"uv_transform\", \"in\": {\"scale\": [" +
                 tiling + ", " + tiling + "]}},\n\"map" + number + "\": {\"type\": \"" +
                 layering.source + "\", \"in\": {\"image\": \"textures/" +
                 images[static_cast<size_t>(i) % images.size()] + ".png\", " + layering.options +
                 "\"uv\": " + from("tile" + number + ".uv") + "}},\n";
        const std::string map = "map" + number + output;
        if (i > 0)
            nodes += "\"sum" + number + "\": {\"type\": \"" + layering.join +
                     "\", \"in\": {\"a\": " + from(sum) + ", \"b\": " + from(map) + "}},\n";
        sum = i > 0 ? "sum" + number + output : map;
    }
    return "{\"wrinkle\": 1, \"nodes\": {" + nodes +
           "\"end\": {\"type\": \"resolve\", \"in\": {\"gradient\": " + from(sum) +
           "}}}, \"outputs\": {\"normal\": " + from("end.normal") + "}}";
}

// Level n of nested graphs, in level_n.json: it adds the results of level n - 1 at x / 2 and at
// x + 0.25; level 0 is x * x.
inline std::string nested_level(int64_t level) {
    const std::string head =
        "{\"wrinkle\": 1, \"inputs\": {\"x\": {\"type\": \"float\", \"default\": 0}}, \"nodes\": {";
    const std::string tail = "}, \"outputs\": {\"result\": " + from("sum.result") + "}}";
    const std::string x = from("input.x");
    if (level == 0)
        return head + "\"sum\": {\"type\": \"multiply\", \"in\": {\"a\": " + x + ", \"b\": " + x +
               "}}" + tail;
    const std::string below =
        "{\"type\": \"graph:level_" + std::to_string(level - 1) + ".json\", \"in\": {\"x\": ";
    return head + "\"half\": {\"type\": \"multiply\", \"in\": {\"a\": " + x + ", \"b\": 0.5}},\n" +
           "\"moved\": {\"type\": \"add\", \"in\": {\"a\": " + x + ", \"b\": 0.25}},\n" +
           "\"left\": " + below + from("half.result") + "}},\n\"right\": " + below +
           from("moved.result") +
           "}},\n\"sum\": {\"type\": \"add\", \"in\": {\"a\": " + from("left.result") +
           ", \"b\": " + from("right.result") + "}}" + tail;
}

// A graph that uses level `depth`.
inline std::string nested_top(int64_t depth) {
    return "{\"wrinkle\": 1, \"nodes\": {\"split\": {\"type\": \"separate_vec2\", \"in\": "
           "{\"vector\": " +
           from("surface.uv0") + "}},\n\"all\": {\"type\": \"graph:level_" + std::to_string(depth) +
           ".json\", \"in\": {\"x\": " + from("split.x") +
           "}},\n\"end\": {\"type\": \"resolve\", \"in\": {\"gradient\": " + from("all.result") +
           "}}}, \"outputs\": {\"normal\": " + from("end.normal") + "}}";
}

}  // namespace wrinkle::bench
