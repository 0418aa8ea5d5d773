#include "gpu/mesh_buffers.h"

#include <epoxy/gl.h>

#include <utility>

#include "gpu/wrapper.h"

namespace wrinkle::gpu {
namespace {

template <typename T>
uint32_t make_buffer(GLenum target, const std::vector<T>& values) {
    GLuint id = 0;
    glGenBuffers(1, &id);
    glBindBuffer(target, id);
    glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
                 GL_STATIC_DRAW);
    return id;
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
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
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

MeshBuffers::MeshBuffers(MeshBuffers&& other) noexcept
    : array_(std::exchange(other.array_, 0)),
      buffers_(std::exchange(other.buffers_, {})),
      has_(other.has_),
      indices_(other.indices_),
      bounds_(other.bounds_) {}

MeshBuffers& MeshBuffers::operator=(MeshBuffers&& other) noexcept {
    std::swap(array_, other.array_);
    std::swap(buffers_, other.buffers_);
    std::swap(has_, other.has_);
    std::swap(indices_, other.indices_);
    std::swap(bounds_, other.bounds_);
    return *this;
}

MeshBuffers::~MeshBuffers() {
    if (array_) glDeleteVertexArrays(1, &array_);
    if (!buffers_.empty()) glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
}

void MeshBuffers::draw() const {
    glBindVertexArray(array_);
    glDrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

}  // namespace wrinkle::gpu
