#include "mesh/gltf_parts.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace wrinkle {
namespace {

using tinygltf::Accessor;
using tinygltf::Model;

// Array of elements of `size` bytes; `stride` bytes from one element to the next.
struct Bytes {
    const unsigned char* first = nullptr;  // null: all zero
    size_t stride = 0;
};

// Maximum element count of an accessor without a buffer view (all zeros). The limit prevents a
// short file from requesting gigabytes.
constexpr size_t max_without_bytes = size_t{1} << 20;

std::string name_of(const char* what, int index) {
    return std::string(what) + " " + std::to_string(index);
}

template <typename T>
const T* find(const std::vector<T>& list, int index) {
    if (index < 0 || static_cast<size_t>(index) >= list.size()) return nullptr;
    return &list[static_cast<size_t>(index)];
}

// Returns the address of element 0 and the stride. Sets `why` if the elements are outside the view
// or the view is outside its buffer.
Bytes locate(const Model& model, int view_index, uint64_t offset, uint64_t count, uint64_t size,
             std::string& why) {
    const auto* view = find(model.bufferViews, view_index);
    if (!view) return why = "there is no " + name_of("buffer view", view_index), Bytes{};
    const auto* buffer = find(model.buffers, view->buffer);
    if (!buffer) return why = "there is no " + name_of("buffer", view->buffer), Bytes{};
    const uint64_t held = buffer->data.size();
    if (view->byteOffset > held || view->byteLength > held - view->byteOffset)
        return why = name_of("buffer view", view_index) + " leaves its buffer", Bytes{};
    const uint64_t stride = view->byteStride > 0 ? view->byteStride : size;
    const uint64_t length = view->byteLength;
    const bool fits = count == 0 || (offset <= length && size <= length - offset &&
                                     (count - 1) <= (length - offset - size) / stride);
    if (!fits || stride < size)
        return why = "it leaves " + name_of("buffer view", view_index), Bytes{};
    return {buffer->data.data() + view->byteOffset + offset, static_cast<size_t>(stride)};
}

template <typename T>
T value_at(const unsigned char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

// A normalised integer is c / max, at least -1.
template <typename T>
float integer_at(const unsigned char* at, bool normalized) {
    const float value = value_at<T>(at);
    return normalized ? std::max(value / std::numeric_limits<T>::max(), -1.0F) : value;
}

float component_at(const unsigned char* at, int type, bool normalized) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return integer_at<int8_t>(at, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return integer_at<uint8_t>(at, normalized);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return integer_at<int16_t>(at, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return integer_at<uint16_t>(at, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return static_cast<float>(value_at<uint32_t>(at));
        default:
            return value_at<float>(at);
    }
}

uint32_t index_at(const unsigned char* at, int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return value_at<uint8_t>(at);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return value_at<uint16_t>(at);
        default:
            return value_at<uint32_t>(at);
    }
}

// Component types that a mesh attribute may have; doubles and signed 32-bit integers are excluded.
bool is_component_type(int type) {
    return type >= TINYGLTF_COMPONENT_TYPE_BYTE && type <= TINYGLTF_COMPONENT_TYPE_FLOAT &&
           type != TINYGLTF_COMPONENT_TYPE_INT;
}

uint64_t size_of_component(int type) {
    return static_cast<uint64_t>(tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(type)));
}

bool is_index_type(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

bool is_scalar_or_vector(int type) {
    return type == TINYGLTF_TYPE_SCALAR || type == TINYGLTF_TYPE_VEC2 ||
           type == TINYGLTF_TYPE_VEC3 || type == TINYGLTF_TYPE_VEC4;
}

const Accessor* find_accessor(const Model& model, int index, uint64_t max_count, std::string& why) {
    const Accessor* accessor = find(model.accessors, index);
    if (!accessor)
        why = "there is no " + name_of("accessor", index);
    else if (!is_scalar_or_vector(accessor->type) || !is_component_type(accessor->componentType))
        why = name_of("accessor", index) + " has a type that no vertex attribute has";
    else if (accessor->bufferView < 0 && accessor->count > max_without_bytes)
        why = name_of("accessor", index) + " has many elements and no buffer view";
    else if (accessor->count > max_count)
        why = name_of("accessor", index) + " has " + std::to_string(accessor->count) +
              " elements, more than " + std::to_string(max_count);
    return why.empty() ? accessor : nullptr;
}

bool apply_sparse(const Model& model, const Accessor& accessor, AccessorFloats& result,
                  std::string& why) {
    const auto& sparse = accessor.sparse;
    if (sparse.count < 0 || static_cast<size_t>(sparse.count) > accessor.count ||
        sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 ||
        !is_index_type(sparse.indices.componentType)) {
        why = "its sparse part is no valid one";
        return false;
    }
    const auto count = static_cast<uint64_t>(sparse.count);
    const auto width = static_cast<size_t>(result.components);
    const uint64_t part = size_of_component(accessor.componentType);
    const Bytes indices =
        locate(model, sparse.indices.bufferView, static_cast<uint64_t>(sparse.indices.byteOffset),
               count, size_of_component(sparse.indices.componentType), why);
    const Bytes values =
        locate(model, sparse.values.bufferView, static_cast<uint64_t>(sparse.values.byteOffset),
               count, part * width, why);
    for (size_t i = 0; why.empty() && i < count; ++i) {
        const size_t at =
            index_at(indices.first + i * indices.stride, sparse.indices.componentType);
        if (at >= result.count) {
            why = "its sparse part names element " + std::to_string(at);
            break;
        }
        for (size_t k = 0; k < width; ++k)
            result.values[at * width + k] =
                component_at(values.first + i * values.stride + k * part, accessor.componentType,
                             accessor.normalized);
    }
    return why.empty();
}

}  // namespace

std::optional<AccessorFloats> read_floats(const Model& model, int index, uint64_t max_count,
                                          std::string& why) {
    const Accessor* accessor = find_accessor(model, index, max_count, why);
    if (!accessor) return {};
    AccessorFloats result;
    result.components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor->type));
    result.count = accessor->count;
    const auto width = static_cast<size_t>(result.components);
    const uint64_t part = size_of_component(accessor->componentType);
    Bytes bytes;
    if (accessor->bufferView >= 0)
        bytes = locate(model, accessor->bufferView, accessor->byteOffset, accessor->count,
                       part * width, why);
    if (why.empty()) result.values.resize(result.count * width);
    for (size_t i = 0; why.empty() && bytes.first && i < result.count; ++i)
        for (size_t k = 0; k < width; ++k)
            result.values[i * width + k] =
                component_at(bytes.first + i * bytes.stride + k * part, accessor->componentType,
                             accessor->normalized);
    if (why.empty() && accessor->sparse.isSparse) apply_sparse(model, *accessor, result, why);
    if (why.empty()) return result;
    why = name_of("accessor", index) + ": " + why;
    return {};
}

std::optional<std::vector<uint32_t>> read_indices(const Model& model, int index, uint64_t max_count,
                                                  std::string& why) {
    const Accessor* accessor = find_accessor(model, index, max_count, why);
    if (!accessor) return {};
    const int type = accessor->componentType;
    if (accessor->type != TINYGLTF_TYPE_SCALAR || !is_index_type(type) ||
        accessor->sparse.isSparse) {
        why = name_of("accessor", index) + " holds no indices";
        return {};
    }
    const Bytes bytes = locate(model, accessor->bufferView, accessor->byteOffset, accessor->count,
                               size_of_component(type), why);
    if (!why.empty()) {
        why = name_of("accessor", index) + ": " + why;
        return {};
    }
    std::vector<uint32_t> result(accessor->count);
    for (size_t i = 0; i < result.size(); ++i)
        result[i] = index_at(bytes.first + i * bytes.stride, type);
    return result;
}

}  // namespace wrinkle
