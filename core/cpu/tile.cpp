#include "cpu/tile.h"

#include <algorithm>
#include <cassert>

namespace wrinkle {
namespace {

template <class T>
RunOp<T> run_op_of(InstructionSet set) {
#if defined(WRINKLE_HAS_AVX2)
    if (set == InstructionSet::avx2) return avx2::run_op;
#endif
    assert(set == InstructionSet::baseline);
    static_cast<void>(set);
    return baseline::run_op;
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
    : program_(program), textures_(textures), run_op_(run_op_of<T>(set)), memory_(memory) {
    const auto grow = [](auto& registers, size_t count) {
        registers.resize(std::max(registers.size(), count * tile_lanes));
    };
    grow(memory_.floats, program.float_registers);
    grow(memory_.integers, program.integer_registers);
}

template <class T>
void Tile<T>::run(size_t count) {
    count_ = count;
    for (uint32_t step = 0; step < program_.steps.size();)
        step = execute(step);
}

template <class T>
uint32_t Tile<T>::execute(uint32_t index) {
    const Step& step = program_.steps[index];
    switch (step.kind) {
        case Step::Kind::op:
            if (!run_op_(step, {memory_.floats.data(), memory_.integers.data()}, count_))
                assert(!"an op without a CPU case");
            break;
        case Step::Kind::constant:
            constant(step);
            break;
        case Step::Kind::sample:
            sample(step);
            break;
        case Step::Kind::size:
            size(step);
            break;
        case Step::Kind::move:
            move(step, nullptr);
            break;
        case Step::Kind::masked_move:
            move(step, memory_.loops.back().active.data());
            break;
        case Step::Kind::loop_begin:
            begin(step);
            break;
        case Step::Kind::loop_test:
            test(step);
            break;
        case Step::Kind::loop_end:
            return end(step, index);
    }
    return index + 1;
}

template <class T>
void Tile<T>::constant(const Step& step) {
    const double value = program_.constants[step.extra];
    if (step.type == Type::float_)
        std::fill_n(floats(step.out[0]), count_, static_cast<T>(value));
    else
        std::fill_n(integers(step.out[0]), count_,
                    static_cast<uint32_t>(static_cast<int64_t>(value)));
}

template <class T>
void Tile<T>::sample(const Step& step) {
    const Texture& texture = textures_[step.extra];
    const T *u = floats(step.in[0]), *v = floats(step.in[1]), *lod = floats(step.in[2]);
    for (size_t k = 0; k < count_; ++k) {
        const std::array<T, 4> texel = texture.sample_lod(u[k], v[k], lod[k]);
        for (size_t i = 0; i < 4; ++i)
            floats(step.out[i])[k] = texel[i];
    }
}

template <class T>
void Tile<T>::size(const Step& step) {
    const Texture& texture = textures_[step.extra];
    std::fill_n(floats(step.out[0]), count_, static_cast<T>(texture.width()));
    std::fill_n(floats(step.out[1]), count_, static_cast<T>(texture.height()));
}

template <class T>
void Tile<T>::move(const Step& step, const uint8_t* mask) {
    if (step.type == Type::float_)
        move_lanes(floats(step.out[0]), floats(step.in[0]), mask, count_);
    else
        move_lanes(integers(step.out[0]), integers(step.in[0]), mask, count_);
}

template <class T>
void Tile<T>::begin(const Step& step) {
    RunningLoop loop;
    loop.limit = step.extra;
    if (memory_.loops.empty())
        loop.active.fill(1);
    else
        loop.active = memory_.loops.back().active;
    memory_.loops.push_back(loop);
}

template <class T>
void Tile<T>::test(const Step& step) {
    RunningLoop& loop = memory_.loops.back();
    const uint32_t* goes_on = integers(step.in[0]);
    const bool may_run = loop.iterations < loop.limit;
    for (size_t k = 0; k < count_; ++k)
        loop.active[k] = static_cast<uint8_t>(loop.active[k] && may_run && goes_on[k]);
}

template <class T>
uint32_t Tile<T>::end(const Step& step, uint32_t index) {
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
