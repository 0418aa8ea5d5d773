// Values of image ports and transforms of uv.
#pragma once

#include "import/mtlx_importer.h"

namespace wrinkle::materialx {

// Returns the value of an image port: a path, or an object with the members that are not defaults.
json::Value image_value(const ImageRead& image, std::string_view encoding,
                        std::string_view default_encoding);

// (uv * scale), turned anticlockwise by `rotation` in degrees, plus `offset`.
Value transformed_uv(GraphBuilder& graph, const Value& uv, const Numbers& scale,
                     const Number& rotation, const Numbers& offset);

// The uv set of the mesh, 0 to 3.
Value uv_set(int set);

}  // namespace wrinkle::materialx
