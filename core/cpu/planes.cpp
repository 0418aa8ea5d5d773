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

}  // namespace

void evaluate_planes(const Program& program, std::span<const Texture> textures,
                     const Planes& planes, size_t count, PlaneScratch& scratch,
                     InstructionSet set) {
    assert(planes.inputs.size() == program.inputs.size());
    auto& [memory, taken, written] = *scratch.memory_;
    taken.assign(program.float_registers, 0);
    for (const Program::Input& input : program.inputs)
        taken[input.reg] = 1;
    for (const Program::ConstantRegister& preset : program.presets)
        if (!is_whole_type(preset.type)) taken[preset.reg] = 1;
    written.clear();
    each_plane(program,
               [&, &is = taken, &list = written](const auto& output, uint32_t reg, size_t) {
                   list.push_back(!is_whole_type(output.type) && !is[reg]);
                   if (list.back()) is[reg] = 1;
               });
    Tile<float> tile(program, textures, set, memory);
    for (size_t first = 0; first < count; first += tile_points) {
        const size_t n = std::min(tile_points, count - first);
        // No step writes an input register, so its memory is not modified.
        for (size_t i = 0; i < program.inputs.size(); ++i)
            tile.bind_register(program.inputs[i].reg, const_cast<float*>(planes.inputs[i] + first));
        each_plane(program, [&, &list = written](const auto&, uint32_t reg, size_t plane) {
            if (list[plane]) tile.bind_register(reg, planes.outputs[plane] + first);
        });
        tile.run(n);
        each_plane(program, [&, &list = written](const auto& output, uint32_t reg, size_t plane) {
            float* out = planes.outputs[plane] + first;
            for (size_t k = 0; k < n && !list[plane]; ++k)
                out[k] = static_cast<float>(tile.value(output, reg, k));
        });
    }
}

}  // namespace wrinkle
