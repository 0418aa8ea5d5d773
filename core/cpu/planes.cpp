#include "cpu/planes.h"

#include <algorithm>
#include <cassert>

#include "cpu/tile.h"

namespace wrinkle {

struct PlaneScratch::Memory {
    TileMemory<float> tile;
    std::vector<uint8_t> taken;    // by register
    std::vector<uint8_t> written;  // by output plane: the register is stored in the plane itself
};

PlaneScratch::PlaneScratch() : memory_(std::make_unique<Memory>()) {}
PlaneScratch::~PlaneScratch() = default;
PlaneScratch::PlaneScratch(PlaneScratch&&) noexcept = default;
PlaneScratch& PlaneScratch::operator=(PlaneScratch&&) noexcept = default;

namespace {

// Calls f(output, register, plane) for each output plane.
template <class F>
void each_plane(const Program& program, F f) {
    size_t plane = 0;
    for (const Program::Output& output : program.outputs)
        for (const uint32_t reg : output.regs)
            f(output, reg, plane++);
}

// Finds the output planes that run() can write directly: float registers that nothing else uses.
void find_written(const Program& program, std::vector<uint8_t>& taken,
                  std::vector<uint8_t>& written) {
    taken.assign(program.float_registers, 0);
    for (const Program::Input& input : program.inputs)
        taken[input.reg] = 1;
    written.clear();
    each_plane(program, [&](const auto& output, uint32_t reg, size_t) {
        written.push_back(!is_whole_type(output.type) && !taken[reg]);
        if (written.back()) taken[reg] = 1;
    });
}

// Binds the registers of inputs and of written outputs to the planes, at this point.
void bind_planes(const Program& program, const Planes& planes, size_t point,
                 const std::vector<uint8_t>& written, Tile<float>& tile) {
    // No step writes an input register, so its memory is not modified.
    for (size_t i = 0; i < program.inputs.size(); ++i)
        tile.bind_register(program.inputs[i].reg, const_cast<float*>(planes.inputs[i] + point));
    each_plane(program, [&](const auto&, uint32_t reg, size_t plane) {
        if (written[plane]) tile.bind_register(reg, planes.outputs[plane] + point);
    });
}

// Copies inputs to the tile's own registers, for points that do not fill a block.
void copy_inputs(const Program& program, const Planes& planes, size_t point, size_t count,
                 Tile<float>& tile) {
    each_plane(program, [&](const Program::Output& output, uint32_t reg, size_t) {
        if (!is_whole_type(output.type)) tile.unbind_register(reg);
    });
    for (size_t i = 0; i < program.inputs.size(); ++i) {
        const uint32_t reg = program.inputs[i].reg;
        tile.unbind_register(reg);
        std::copy_n(planes.inputs[i] + point, count, tile.floats(reg));
    }
}

}  // namespace

void evaluate_planes(const Program& program, std::span<const Texture> textures,
                     const Planes& planes, size_t count, PlaneScratch& scratch,
                     InstructionSet set) {
    assert(planes.inputs.size() == program.inputs.size());
    auto& [memory, taken, written] = *scratch.memory_;
    find_written(program, taken, written);
    Tile<float> tile(program, textures, set, memory);
    for (size_t first = 0; first < count; first += tile_points) {
        const size_t n = std::min(tile_points, count - first);
        const bool in_place = n == padded_to_blocks(n);
        if (in_place)
            bind_planes(program, planes, first, written, tile);
        else
            copy_inputs(program, planes, first, n, tile);
        tile.run(n);
        each_plane(program, [&, &list = written](const auto& output, uint32_t reg, size_t plane) {
            float* out = planes.outputs[plane] + first;
            for (size_t k = 0; k < n && !(list[plane] && in_place); ++k)
                out[k] = static_cast<float>(tile.value(output, reg, k));
        });
    }
}

}  // namespace wrinkle
