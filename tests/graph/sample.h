// The sample of the format's definition, in canonical form, and helpers shared by several tests.
#pragma once

#include <string>

#include "graph/read.h"
#include "graph/write.h"

namespace wrinkle {

inline const std::string& sample_text() {
    static const std::string text = R"({
  "wrinkle": 1,
  "name": "Woven strap over a baked shape",
  "inputs": {
    "amount": { "type": "float", "default": 0.50, "doc": "How strong" }
  },
  "nodes": {
    "base": { "type": "tangent_normal_map", "in": { "image": "textures/base.png" } },
    "tile": { "type": "uv_transform", "in": { "uv": { "from": "surface.uv1" }, "scale": [8.0, 8] } },
    "weave": {
      "type": "tangent_normal_map",
      "version": 2,
      "muted": true,
      "in": {
        "image": { "file": "textures/weave.png", "encoding": "normal_dx" },
        "uv": { "from": "tile.uv" },
        "scale": "unit"
      }
    },
    "softer": { "type": "gradient_scale", "in": { "gradient": { "from": "weave.gradient" }, "amount": { "from": "input.amount" } } },
    "sum": { "type": "gradient_add", "in": { "a": { "from": "base.gradient" }, "b": { "from": "softer.gradient" } } },
    "normal": { "type": "resolve", "in": { "gradient": { "from": "sum.gradient" } } },
    "plain": { "type": "surface" }
  },
  "outputs": {
    "normal": { "from": "normal.normal" }
  },
  "layout": {
    "base": [0, 0],
    "weave": [220.0, 140],
    "$frames": {
      "f1": { "title": "Detail", "rect": [0, 0, 400, 3e2] }
    },
    "$notes": {
      "n1": { "text": "Scan 12", "rect": [10, 10, 80, 40] }
    }
  }
}
)";
    return text;
}

inline Document read_quietly(const std::string& text) {
    Diagnostics diagnostics;
    return read_document(text, "g.json", diagnostics);
}

// The problems of a text, one per line.
inline std::string problems_of(const std::string& text, ReadLimits limits = {}) {
    Diagnostics diagnostics;
    read_document(text, "g.json", diagnostics, limits);
    return to_text(diagnostics);
}

// A graph with only these nodes (their JSON, without braces).
inline std::string graph_of(const std::string& nodes) {
    return "{\"wrinkle\": 1, \"nodes\": {\n" + nodes + "\n}}";
}

}  // namespace wrinkle
