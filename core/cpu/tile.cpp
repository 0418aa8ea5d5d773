#include "cpu/tile.h"

#include <algorithm>
#include <cassert>
#include <type_traits>

namespace wrinkle {
namespace {

template <class Lane>
void allot(AlignedVector<Lane>& memory, std::vector<Lane*>& pointers, size_t registers) {
    memory.resize(std::max(memory.size(), registers * tile_points));
    pointers.resize(registers);
    for (size_t reg = 0; reg < registers; ++reg)
        pointers[reg] = memory.data() + reg * tile_points;
}

bool has_kernel(const CpuInst& step) {
    return step.kind == CpuInst::Kind::op || step.kind == CpuInst::Kind::pair;
}

template <class Lane>
void move_lanes(Lane* out, const Lane* from, const uint8_t* mask, size_t count) {
    for (size_t k = 0; k < count; ++k)
        if (!mask || mask[k]) out[k] = from[k];
}

}  // namespace

template <class T>
Tile<T>::Tile(const Program& program, std::span<const Texture> textures, InstructionSet set,
              TileMemory<T>& memory)
    : program_(program),
      textures_(textures),
      kernels_(kernels_of(set)),
      kernel_table_(kernel_table<T>(kernels_)),
      memory_(memory) {
    allot(memory_.floats, memory_.float_pointers, program.float_registers);
    allot(memory_.integers, memory_.integer_pointers, program.integer_registers);
    // No step writes a preset's register, so its contents remain valid for the same program.
    if (program.serial != 0 && memory_.serial == program.serial) return;
    memory_.serial = program.serial;
    for (const Program::ConstantRegister& each : program.presets)
        fill_register(each.reg, each.type, each.value, tile_points);
}

template <class T>
void Tile<T>::run(size_t count) {
    count_ = count;
    const Registers<T> registers = {memory_.float_pointers.data(), memory_.integer_pointers.data()};
    const auto end = static_cast<uint32_t>(program_.steps.size());
    for (uint32_t index = 0; index < end;) {
        const CpuInst& step = program_.steps[index];
        if (!has_kernel(step)) {
            index = execute(index);
            continue;
        }
        assert(kernel_table_[step.kernel] && "an op without a CPU case");
        kernel_table_[step.kernel](step, registers, count_);
        ++index;
    }
}

template <class T>
uint32_t Tile<T>::execute(uint32_t index) {
    const CpuInst& step = program_.steps[index];
    switch (step.kind) {
        case CpuInst::Kind::op:
        case CpuInst::Kind::pair:
            break;  // done by run()
        case CpuInst::Kind::constant:
            fill_register(step.out[0], step.type, program_.constants[step.extra], count_);
            break;
        case CpuInst::Kind::sample:
            sample(step);
            break;
        case CpuInst::Kind::size:
            size(step);
            break;
        case CpuInst::Kind::move:
            move(step, nullptr);
            break;
        case CpuInst::Kind::masked_move:
            move(step, memory_.loops.back().active.data());
            break;
        case CpuInst::Kind::loop_begin:
            begin(step);
            break;
        case CpuInst::Kind::loop_test:
            test(step);
            break;
        case CpuInst::Kind::loop_end:
            return end(step, index);
    }
    return index + 1;
}

template <class T>
void Tile<T>::fill_register(uint32_t reg, Type type, double value, size_t count) {
    if (type == Type::float_)
        std::fill_n(floats(reg), count, static_cast<T>(value));
    else
        std::fill_n(integers(reg), count, static_cast<uint32_t>(static_cast<int64_t>(value)));
}

template <class T>
void Tile<T>::sample(const CpuInst& step) {
    const Texture& texture = textures_[step.extra];
    const T *u = floats(step.in[0]), *v = floats(step.in[1]), *lod = floats(step.in[2]);
    if constexpr (std::is_same_v<T, float>)
        if (texture.options().filter == Filter::linear &&
            !texture.texels().levels(texture.options().wrap).empty())
            return sample_tile(texture, kernels_,
                               {step.channels,
                                u,
                                v,
                                lod,
                                {floats(step.out[0]), floats(step.out[1]), floats(step.out[2]),
                                 floats(step.out[3])},
                                count_});
    for (size_t k = 0; k < count_; ++k) {
        const std::array<T, 4> texel = texture.sample_lod(u[k], v[k], lod[k]);
        for (size_t i = 0; i < 4; ++i)
            floats(step.out[i])[k] = texel[i];
    }
}

template <class T>
void Tile<T>::size(const CpuInst& step) {
    const Texture& texture = textures_[step.extra];
    std::fill_n(floats(step.out[0]), count_, static_cast<T>(texture.width()));
    std::fill_n(floats(step.out[1]), count_, static_cast<T>(texture.height()));
}

template <class T>
void Tile<T>::move(const CpuInst& step, const uint8_t* mask) {
    if (step.type == Type::float_)
        move_lanes(floats(step.out[0]), floats(step.in[0]), mask, count_);
    else
        move_lanes(integers(step.out[0]), integers(step.in[0]), mask, count_);
}

template <class T>
void Tile<T>::begin(const CpuInst& step) {
    RunningLoop loop;
    loop.limit = step.extra;
    if (memory_.loops.empty())
        loop.active.fill(1);
    else
        loop.active = memory_.loops.back().active;
    memory_.loops.push_back(loop);
}

template <class T>
void Tile<T>::test(const CpuInst& step) {
    RunningLoop& loop = memory_.loops.back();
    const uint32_t* goes_on = integers(step.in[0]);
    const bool may_run = loop.iterations < loop.limit;
    for (size_t k = 0; k < count_; ++k)
        loop.active[k] = static_cast<uint8_t>(loop.active[k] && may_run && goes_on[k]);
}

template <class T>
uint32_t Tile<T>::end(const CpuInst& step, uint32_t index) {
    RunningLoop& loop = memory_.loops.back();
    ++loop.iterations;
    const bool any = std::any_of(loop.active.begin(), loop.active.begin() + count_,
                                 [](uint8_t lane) { return lane != 0; });
    if (any && loop.iterations < loop.limit) return step.extra + 1;
    memory_.loops.pop_back();
    return index + 1;
}

template class Tile<float>;
template class Tile<double>;

}  // namespace wrinkle
