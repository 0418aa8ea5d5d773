#include "mesh/uv_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "mesh/uv_triangle.h"

namespace wrinkle {
namespace {

constexpr uint32_t max_side = 2048;  // per axis

}  // namespace

UvBox uv_box(const Mesh& mesh, size_t triangle) {
    const uint32_t* corners = mesh.indices.data() + 3 * triangle;
    const auto& uvs = mesh.uvs[0];
    UvBox box;
    for (int axis = 0; axis < 2; ++axis) {
        const auto [low, high] =
            std::minmax({double{uvs[corners[0]][axis]}, double{uvs[corners[1]][axis]},
                         double{uvs[corners[2]][axis]}});
        const double margin = 1e-5 * (high - low);
        box.low[axis] = low - margin;
        box.high[axis] = high + margin;
    }
    return box;
}

uint32_t UvGrid::cell_of(double coordinate, int axis) const {
    const double size = box_.high[axis] - box_.low[axis];
    const double cell = size > 0 ? std::floor((coordinate - box_.low[axis]) / size * side_) : 0;
    return static_cast<uint32_t>(std::fmin(std::fmax(cell, 0), side_ - 1.0));  // NaN becomes 0
}

UvGrid::CellRange UvGrid::cells_of(const Mesh& mesh, size_t triangle) const {
    const UvBox box = uv_box(mesh, triangle);
    return {{cell_of(box.low.x, 0), cell_of(box.low.y, 1)},
            {cell_of(box.high.x, 0), cell_of(box.high.y, 1)}};
}

// Chooses about one cell per triangle, but fewer if large triangles would fill more than 16 cells
// per triangle on average.
void UvGrid::choose_side(const Mesh& mesh) {
    const double root = std::sqrt(static_cast<double>(covering_.size()));
    side_ = std::clamp<uint32_t>(static_cast<uint32_t>(root), 1, max_side);
    const auto entries = [&] {
        uint64_t count = 0;
        for (const uint32_t triangle : covering_)
            count += cells_of(mesh, triangle).count();
        return count;
    };
    while (side_ > 1 && entries() > 16 * uint64_t{covering_.size()})
        side_ /= 2;
}

UvGrid::UvGrid(const Mesh& mesh) {
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        if (!has_uv_area(mesh, t)) continue;
        const UvBox box = uv_box(mesh, t);
        if (covering_.empty()) box_ = box;
        box_ = {glm::min(box_.low, box.low), glm::max(box_.high, box.high)};
        covering_.push_back(static_cast<uint32_t>(t));
    }
    choose_side(mesh);
    cells_.resize(size_t{side_} * side_);
    for (const uint32_t triangle : covering_) {
        const CellRange range = cells_of(mesh, triangle);
        for (uint32_t y = range.low[1]; y <= range.high[1]; ++y)
            for (uint32_t x = range.low[0]; x <= range.high[0]; ++x)
                cells_[size_t{y} * side_ + x].push_back(triangle);
    }
}

std::span<const uint32_t> UvGrid::near(glm::dvec2 uv) const {
    return cells_[size_t{cell_of(uv.y, 1)} * side_ + cell_of(uv.x, 0)];
}

}  // namespace wrinkle
