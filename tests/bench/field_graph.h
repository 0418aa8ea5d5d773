// A benchmark graph: rows of nodes, each with up to two links from earlier nearby ones, three links
// for two nodes; the last node depends on all and is the graph's normal.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

namespace wrinkle::editor {

inline std::string field_graph(int count) {
    const int columns = std::max(1, static_cast<int>(std::sqrt(count * 0.8)));
    std::string nodes, layout;
    for (int i = 0; i < count; ++i) {
        const std::string id = "\"n" + std::to_string(i) + "\": ";
        const auto from = [&](int k) {
            return "{\"from\": \"n" + std::to_string(k) + (k % 4 ? ".gradient\"}" : ".height\"}");
        };
        if (i % 4 == 0)
            nodes += id + R"({"type": "gradient_noise", "in": {"scale": 3.0}})";
        else
            nodes += id + R"({"type": "gradient_add", "in": {"a": )" + from(i - 1) +
                     ", \"b\": " + from(std::max(0, i % 4 == 1 ? i - 2 : i - 1 - i % 37)) + "}}";
        layout += id + "[" + std::to_string(i % columns * 256) + ", " +
                  std::to_string(i / columns * 208) + "]";
        if (i + 1 < count) nodes += ",\n", layout += ",\n";
    }
    return "{\"wrinkle\": 1, \"nodes\": {" + nodes + "}, \"outputs\": {\"normal\": {\"from\": \"n" +
           std::to_string(count - 1) + ".gradient\"}}, \"layout\": {" + layout + "}}";
}

}  // namespace wrinkle::editor
