#include "cpu/tile.h"

#include <algorithm>
#include <cassert>
#include <type_traits>

namespace wrinkle {
namespace {

// Appends `count` pointers to arrays of this many lanes.
template <class Lane>
void allot(AlignedVector<Lane>& memory, std::vector<Lane*>& pointers, size_t count, size_t lanes) {
    memory.resize(std::max(memory.size(), count * lanes));
    for (size_t i = 0; i < count; ++i)
        pointers.push_back(memory.data() + i * lanes);
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
    const uint32_t floats = program.uniform_floats, integers = program.uniform_integers;
    memory_.float_pointers.clear();
    memory_.integer_pointers.clear();
    allot(memory_.uniform_floats, memory_.float_pointers, floats, block_lanes);
    allot(memory_.floats, memory_.float_pointers, program.float_registers - floats, tile_points);
    allot(memory_.uniform_integers, memory_.integer_pointers, integers, block_lanes);
    allot(memory_.integers, memory_.integer_pointers, program.integer_registers - integers,
          tile_points);
    if (program.serial != 0 && memory_.serial == program.serial) return;
    memory_.serial = program.serial;
    fill_constants();
}

template <class T>
void Tile<T>::run(size_t count) {
    count_ = count;
    Registers<T> registers = {memory_.float_pointers.data(), memory_.integer_pointers.data(), {}};
    const size_t lanes = padded_to_blocks(count);
    const auto end = static_cast<uint32_t>(program_.steps.size());
    for (uint32_t index = 0; index < end;) {
        const CpuInst& step = program_.steps[index];
        if (!has_kernel(step)) {
            index = execute(index);
            if (!memory_.loops.empty()) registers.active = memory_.loops.back().active.data();
            continue;
        }
        assert(kernel_table_[step.kernel] && "an op without a CPU case");
        kernel_table_[step.kernel](step, registers, step.to_uniform ? block_lanes : lanes);
        ++index;
    }
}

// Runs a step without a kernel; returns the index of the next one.
template <class T>
uint32_t Tile<T>::execute(uint32_t index) {
    const CpuInst& step = program_.steps[index];
    switch (step.kind) {
        case CpuInst::Kind::sample:
            sample(step);
            break;
        case CpuInst::Kind::size:
            size(step);
            break;
        case CpuInst::Kind::loop_begin:
            begin(step);
            break;
        case CpuInst::Kind::loop_test:
            test(step);
            break;
        case CpuInst::Kind::loop_end:
            return end(step, index);
        default:
            break;  // done by run()
    }
    return index + 1;
}

template <class T>
void Tile<T>::fill_constants() {
    for (const Program::Constant& each : program_.constants) {
        if (is_whole_type(each.type))
            std::fill_n(integers(each.reg), block_lanes,
                        static_cast<uint32_t>(static_cast<int64_t>(each.value)));
        else
            std::fill_n(floats(each.reg), block_lanes, static_cast<T>(each.value));
    }
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
    if (loop.iterations >= loop.limit || (step.uniform && !goes_on[0])) return loop.active.fill(0);
    if (step.uniform) return;
    for (size_t k = 0; k < count_; ++k)
        loop.active[k] &= goes_on[k];
}

template <class T>
uint32_t Tile<T>::end(const CpuInst& step, uint32_t index) {
    RunningLoop& loop = memory_.loops.back();
    ++loop.iterations;
    const bool any = std::any_of(loop.active.begin(), loop.active.begin() + count_,
                                 [](uint32_t lane) { return lane != 0; });
    if (any && loop.iterations < loop.limit) return step.extra + 1;
    memory_.loops.pop_back();
    return index + 1;
}

template class Tile<float>;
template class Tile<double>;

}  // namespace wrinkle
