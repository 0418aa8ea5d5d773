// What of a document the preview shows, as a document of its own that is made for it.
#pragma once

#include <map>
#include <string>

#include "editor/document/model.h"

namespace wrinkle::editor {

enum class Against : uint8_t {
    nothing,
    output,  // another output of the graph
    node,    // what a node makes
    blend,   // the graph with every sum of bumps replaced by a blend of normals
};

struct PreviewRequest {
    std::string node;  // in place of the outputs; "" shows these
    Against against = Against::nothing;
    std::string name;        // the output, the node, or a `blend` of compare_bump_blend: "udn"
    bool displaced = false;  // by the output `displacement`
    std::string double_sided = {};  // the mesh, if one of its materials is
    bool operator==(const PreviewRequest&) const = default;
};

// The output of the made document that holds the other normal, object space.
inline constexpr const char* against_output = "wrinkle_against";

struct Requested {
    Document document;
    std::map<std::string, std::string> copied;  // from the id of a copy to the node that it copies
    size_t replaced = 0;                        // sums
    std::string why_not;  // one sentence; `document` then shows no other normal
};

// Of a blend: each unmuted `gradient_add` that the normal depends on becomes `compare_bump_blend`,
// which takes both bumps for tangent-space normals of uv0; everything after it is copied. Sums
// inside sub-graphs stay.
Requested requested_document(const Document& document, const Model& model,
                             const PreviewRequest& request);

// The output of a node that the preview shows, "" when there is none: the first gradient, normal,
// height or color, else the first derivative, float or vec3.
std::string shown_port(const NodeType& type);

}  // namespace wrinkle::editor
