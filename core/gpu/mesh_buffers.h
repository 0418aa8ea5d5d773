// A mesh in GPU memory, with the attribute locations of wrapper.h. Belongs to one context.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "emit/attributes.h"
#include "gpu/gl_handle.h"
#include "mesh/mesh.h"

namespace wrinkle::gpu {

class MeshBuffers {
public:
    explicit MeshBuffers(const Mesh& mesh);

    void draw() const;
    bool has(int location) const { return has_[static_cast<size_t>(location)]; }
    const Bounds& bounds() const { return bounds_; }

private:
    template <typename T>
    void add(int location, const std::vector<T>& values);

    VertexArrayHandle array_ = VertexArrayHandle::make();
    std::vector<BufferHandle> buffers_;
    std::array<bool, attribute_count + 1> has_{};
    int indices_ = 0;
    Bounds bounds_;
};

}  // namespace wrinkle::gpu
