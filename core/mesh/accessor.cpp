#include "mesh/gltf_parts.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace wrinkle {
namespace {

using tinygltf::Model;

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

// A normalised integer is c / max, at least -1.
template <typename T>
double component_as(const unsigned char* at, bool normalized) {
    T value;
    std::memcpy(&value, at, sizeof value);
    if (!normalized || sizeof value == 4) return value;
    return std::max(static_cast<double>(value) / std::numeric_limits<T>::max(), -1.0);
}

// Component types that a mesh attribute may have; doubles and signed 32-bit integers are excluded.
bool is_component_type(int type) {
    return type >= TINYGLTF_COMPONENT_TYPE_BYTE && type <= TINYGLTF_COMPONENT_TYPE_FLOAT &&
           type != TINYGLTF_COMPONENT_TYPE_INT;
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

// Format of the elements in a buffer view.
struct Format {
    int type;  // component type
    size_t components;
    bool normalized;

    size_t component_size() const {
        return static_cast<size_t>(tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(type)));
    }
};

struct Elements {
    const unsigned char* first;
    size_t stride;  // bytes
    Format format;

    // Exact: a double holds each component of a valid type.
    double at(size_t element, size_t component) const {
        const unsigned char* at = first + element * stride + component * format.component_size();
        switch (format.type) {
            case TINYGLTF_COMPONENT_TYPE_BYTE:
                return component_as<int8_t>(at, format.normalized);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
                return component_as<uint8_t>(at, format.normalized);
            case TINYGLTF_COMPONENT_TYPE_SHORT:
                return component_as<int16_t>(at, format.normalized);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
                return component_as<uint16_t>(at, format.normalized);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
                return component_as<uint32_t>(at, format.normalized);
            default:
                return component_as<float>(at, format.normalized);
        }
    }
};

class AccessorReader {
public:
    AccessorReader(const Model& model, int index, uint64_t max_count)
        : model_(model),
          name_(name_of("accessor", index)),
          accessor_(find(model.accessors, index)) {
        if (!accessor_) throw InvalidGltf("there is no " + name_);
        if (!is_scalar_or_vector(accessor_->type) || !is_component_type(accessor_->componentType))
            throw InvalidGltf(name_ + " has a type that no vertex attribute has");
        if (accessor_->bufferView < 0 && accessor_->count > max_without_bytes)
            throw InvalidGltf(name_ + " has many elements and no buffer view");
        if (accessor_->count > max_count)
            throw InvalidGltf(name_ + " has " + std::to_string(accessor_->count) +
                              " elements, more than " + std::to_string(max_count));
        format_ = {accessor_->componentType,
                   static_cast<size_t>(
                       tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor_->type))),
                   accessor_->normalized};
    }

    AccessorFloats floats() const {
        AccessorFloats result{static_cast<int>(format_.components), accessor_->count, {}};
        if (accessor_->bufferView >= 0) result.values = values<float>();
        result.values.resize(result.count * format_.components);
        if (accessor_->sparse.isSparse) apply_sparse(result);
        return result;
    }

    std::vector<uint32_t> indices() const {
        if (accessor_->type != TINYGLTF_TYPE_SCALAR || !is_index_type(format_.type) ||
            accessor_->sparse.isSparse)
            throw InvalidGltf(name_ + " holds no indices");
        return values<uint32_t>();
    }

private:
    [[noreturn]] void fail(const std::string& why) const { throw InvalidGltf(name_ + ": " + why); }

    // Returns `count` elements from `offset` on in a buffer view. Fails if they are outside the
    // view or the view is outside its buffer.
    Elements locate(int view_index, uint64_t offset, uint64_t count, const Format& format) const {
        const auto* view = find(model_.bufferViews, view_index);
        if (!view) fail("there is no " + name_of("buffer view", view_index));
        const auto* buffer = find(model_.buffers, view->buffer);
        if (!buffer) fail("there is no " + name_of("buffer", view->buffer));
        const uint64_t held = buffer->data.size();
        if (view->byteOffset > held || view->byteLength > held - view->byteOffset)
            fail(name_of("buffer view", view_index) + " leaves its buffer");
        const uint64_t size = format.component_size() * format.components;
        const uint64_t stride = view->byteStride > 0 ? view->byteStride : size;
        const uint64_t length = view->byteLength;
        const bool fits = count == 0 || (offset <= length && size <= length - offset &&
                                         (count - 1) <= (length - offset - size) / stride);
        if (!fits || stride < size) fail("it leaves " + name_of("buffer view", view_index));
        return {buffer->data.data() + view->byteOffset + offset, stride, format};
    }

    template <typename T>
    std::vector<T> values() const {
        const Elements elements =
            locate(accessor_->bufferView, accessor_->byteOffset, accessor_->count, format_);
        std::vector<T> result;
        result.reserve(accessor_->count * format_.components);
        for (size_t i = 0; i < accessor_->count; ++i)
            for (size_t k = 0; k < format_.components; ++k)
                result.push_back(static_cast<T>(elements.at(i, k)));
        return result;
    }

    void apply_sparse(AccessorFloats& result) const {
        const auto& sparse = accessor_->sparse;
        if (sparse.count < 0 || static_cast<size_t>(sparse.count) > result.count ||
            sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 ||
            !is_index_type(sparse.indices.componentType))
            fail("its sparse part is not valid");
        const auto count = static_cast<uint64_t>(sparse.count);
        const Elements places =
            locate(sparse.indices.bufferView, static_cast<uint64_t>(sparse.indices.byteOffset),
                   count, {sparse.indices.componentType, 1, false});
        const Elements replaced =
            locate(sparse.values.bufferView, static_cast<uint64_t>(sparse.values.byteOffset), count,
                   format_);
        for (size_t i = 0; i < count; ++i) {
            const auto at = static_cast<size_t>(places.at(i, 0));
            if (at >= result.count) fail("its sparse part names element " + std::to_string(at));
            for (size_t k = 0; k < format_.components; ++k)
                result.values[at * format_.components + k] = static_cast<float>(replaced.at(i, k));
        }
    }

    const Model& model_;
    std::string name_;
    const tinygltf::Accessor* accessor_;
    Format format_{};
};

}  // namespace

AccessorFloats read_floats(const Model& model, int index, uint64_t max_count) {
    return AccessorReader(model, index, max_count).floats();
}

std::vector<uint32_t> read_indices(const Model& model, int index, uint64_t max_count) {
    return AccessorReader(model, index, max_count).indices();
}

}  // namespace wrinkle
