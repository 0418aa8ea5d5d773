#include "mesh/gltf_parts.h"

#include <cmath>

namespace wrinkle {
namespace {

using tinygltf::Value;

double number(const Value& value, double missing) {
    const double result = value.IsNumber() ? value.GetNumberAsDouble() : missing;
    return std::isfinite(result) ? result : missing;
}

glm::dvec2 pair_of(const Value& object, const char* key, glm::dvec2 missing) {
    const Value& value = object.Get(key);
    if (!value.IsArray() || value.ArrayLen() != 2) return missing;
    return {number(value.Get(0), missing.x), number(value.Get(1), missing.y)};
}

template <typename Texture>
void add(UvTransforms& result, const Texture& texture) {
    if (texture.index < 0) return;
    int set = texture.texCoord;
    UvTransform transform;
    const auto found = texture.extensions.find("KHR_texture_transform");
    if (found != texture.extensions.end() && found->second.IsObject()) {
        const Value& value = found->second;
        transform.offset = pair_of(value, "offset", glm::dvec2(0));
        transform.scale = pair_of(value, "scale", glm::dvec2(1));
        transform.rotation = number(value.Get("rotation"), 0);
        if (value.Get("texCoord").IsInt()) set = value.Get("texCoord").GetNumberAsInt();
    }
    if (set < 0 || static_cast<size_t>(set) >= max_uv_sets) return;
    auto& slot = result.sets[static_cast<size_t>(set)];
    if (!slot)
        slot = transform;
    else if (*slot != transform)
        result.differ = true;
}

}  // namespace

glm::vec2 UvTransform::apply(glm::vec2 uv) const {
    const glm::dvec2 p = scale * glm::dvec2(uv);
    const double c = std::cos(rotation), s = std::sin(rotation);
    return offset + glm::dvec2(c * p.x + s * p.y, c * p.y - s * p.x);
}

UvTransforms uv_transforms(const tinygltf::Model& model, int material) {
    UvTransforms result;
    if (material < 0 || static_cast<size_t>(material) >= model.materials.size()) return result;
    const tinygltf::Material& m = model.materials[static_cast<size_t>(material)];
    add(result, m.normalTexture);
    add(result, m.pbrMetallicRoughness.baseColorTexture);
    add(result, m.pbrMetallicRoughness.metallicRoughnessTexture);
    add(result, m.occlusionTexture);
    add(result, m.emissiveTexture);
    return result;
}

}  // namespace wrinkle
