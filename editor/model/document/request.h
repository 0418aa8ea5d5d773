// Builds the document that the preview compiles: the graph's outputs or one node, and with a
// comparison a second normal.
#pragma once

#include <map>
#include <string>

#include "editor/model/document/model.h"

namespace wrinkle::editor {

enum class Against : uint8_t {
    nothing,
    output,  // another output of the graph
    node,    // the output of another node
    blend,   // the graph with every sum of bumps replaced by a blend of normals
};

struct PreviewRequest {
    std::string node;  // shown instead of the outputs; "" shows these
    Against against = Against::nothing;
    std::string name;        // the output, the node, or a `blend` of compare_bump_blend: "udn"
    bool displaced = false;  // by the output `displacement`
    std::string double_sided = {};  // the mesh if one of its materials is double-sided
    std::string preset = {};        // name in the graph; "": the defaults of its inputs
    bool operator==(const PreviewRequest&) const = default;
};

// Output of the requested document with the other normal, object space.
inline constexpr const char* against_output = "wrinkle_against";

struct Requested {
    Document document;
    std::map<std::string, std::string> copied;  // id of a copy -> node that it copies
    size_t replaced = 0;                        // number of replaced sums
    std::string why_not;  // one sentence; if not empty, `document` has no other normal
};

// For Against::blend each unmuted `gradient_add` that the normal depends on becomes a
// `compare_bump_blend`, which takes both bumps as tangent-space normals of uv0; everything
// downstream is copied. Sums inside sub-graphs remain.
Requested requested_document(const Document& document, const Model& model,
                             const PreviewRequest& request);

// Returns the output of a node that the preview shows: the first gradient, normal, height or color,
// else the first derivative, float or vec3; nullptr if there is none.
const Port* shown_port(const NodeType* type);

}  // namespace wrinkle::editor
