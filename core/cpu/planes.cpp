#include "cpu/planes.h"

#include <algorithm>
#include <cassert>

#include "cpu/tile.h"

namespace wrinkle {

struct PlaneScratch::Memory {
    TileMemory<float> tile;
};

PlaneScratch::PlaneScratch() : memory_(std::make_unique<Memory>()) {}
PlaneScratch::~PlaneScratch() = default;
PlaneScratch::PlaneScratch(PlaneScratch&&) noexcept = default;
PlaneScratch& PlaneScratch::operator=(PlaneScratch&&) noexcept = default;

void evaluate_planes(const Program& program, std::span<const Texture> textures,
                     const Planes& planes, size_t count, PlaneScratch& scratch,
                     InstructionSet set) {
    assert(planes.inputs.size() == program.inputs.size());
    Tile<float> tile(program, textures, set, scratch.memory_->tile);
    for (size_t first = 0; first < count; first += tile_lanes) {
        const size_t n = std::min(tile_lanes, count - first);
        for (size_t i = 0; i < program.inputs.size(); ++i)
            std::copy_n(planes.inputs[i] + first, n, tile.floats(program.inputs[i].reg));
        tile.run(n);
        size_t plane = 0;
        for (const Program::Output& output : program.outputs)
            for (const uint32_t reg : output.regs) {
                float* out = planes.outputs[plane++] + first;
                for (size_t k = 0; k < n; ++k)
                    out[k] = static_cast<float>(tile.value(output, reg, k));
            }
    }
}

}  // namespace wrinkle
