#include "gpu/mesh_buffers.h"

#include <epoxy/gl.h>

#include "gpu/wrapper.h"

namespace wrinkle::gpu {
namespace {

template <typename T>
BufferHandle make_buffer(GLenum target, const std::vector<T>& values) {
    auto buffer = BufferHandle::make();
    glBindBuffer(target, buffer.id());
    glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
                 GL_STATIC_DRAW);
    return buffer;
}

}  // namespace

template <typename T>
void MeshBuffers::add(int location, const std::vector<T>& values) {
    if (values.empty()) return;
    const auto index = static_cast<GLuint>(location);
    buffers_.push_back(make_buffer(GL_ARRAY_BUFFER, values));
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, T::length(), GL_FLOAT, GL_FALSE, sizeof(T), nullptr);
    has_[index] = true;
}

MeshBuffers::MeshBuffers(const Mesh& mesh)
    : indices_(static_cast<int>(mesh.indices.size())), bounds_(bounds_of(mesh)) {
    glBindVertexArray(array_.id());
    add(location_of(SurfaceInput::position_), mesh.positions);
    add(location_of(SurfaceInput::normal_), mesh.normals);
    add(location_of(SurfaceInput::tangent_), mesh.tangents);
    for (int set = 0; set < static_cast<int>(max_uv_sets); ++set)
        add(location_of(SurfaceInput::uv0_) + set, mesh.uvs[static_cast<size_t>(set)]);
    add(location_of(SurfaceInput::color0_), mesh.colors);
    add(drawn_location, mesh.drawn());
    buffers_.push_back(make_buffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices));
    glBindVertexArray(0);
}

void MeshBuffers::draw() const {
    glBindVertexArray(array_.id());
    glDrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

}  // namespace wrinkle::gpu
