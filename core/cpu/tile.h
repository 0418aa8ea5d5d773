// Runs a program's steps on one tile of at most tile_points points, in float or double (T). Part of
// evaluate() and evaluate_planes(), which fill or bind the input registers before run() and read
// the outputs after it.
//
// A register is an array of tile_points numbers, so the components of a vector are in separate
// registers (structure of arrays):
//   register 0: point 0, 1, ... 511
//   register 1: point 0, 1, ... 511
//
// TileMemory is scratch memory that tiles reuse one after the other; it only grows. Constants are
// not filled again for the same program.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "cpu/aligned.h"
#include "cpu/evaluate.h"
#include "cpu/kernels.h"
#include "cpu/texture.h"
#include "ir/op.h"

namespace wrinkle {

// State of an active loop: its active lanes and the number of completed iterations.
struct RunningLoop {
    std::array<uint32_t, tile_points> active;  // 0 or 1
    uint32_t iterations = 0;
    uint32_t limit = 0;  // maximum number of iterations
};

template <class T>
struct TileMemory {
    AlignedVector<T> floats, uniform_floats;
    AlignedVector<uint32_t> integers, uniform_integers;
    std::vector<T*> float_pointers;  // by register
    std::vector<uint32_t*> integer_pointers;
    std::vector<RunningLoop> loops;
    uint64_t serial = 0;  // the constants are those of this Program::serial
};

template <class T>
class Tile {
public:
    Tile(const Program& program, std::span<const Texture> textures, InstructionSet set,
         TileMemory<T>& memory);

    T* floats(uint32_t reg) { return memory_.float_pointers[reg]; }
    uint32_t* integers(uint32_t reg) { return memory_.integer_pointers[reg]; }

    // Binds a float register to the caller's memory: run() reads or writes `lanes` directly, padded
    // to blocks. Precondition: an input register, which no step writes, or an output register.
    void bind_register(uint32_t reg, T* lanes) { memory_.float_pointers[reg] = lanes; }
    void unbind_register(uint32_t reg) {
        const size_t written = reg - program_.uniform_floats;
        memory_.float_pointers[reg] = memory_.floats.data() + written * tile_points;
    }

    // Runs all steps for the first `count` points, at most tile_points.
    void run(size_t count);

    // Returns lane k of one of an output's registers; exact for integers and bools.
    double value(const Program::Output& output, uint32_t reg, size_t k) {
        if (!is_whole_type(output.type)) return static_cast<double>(floats(reg)[k]);
        const uint32_t bits = integers(reg)[k];
        return output.type == Type::int_ ? static_cast<double>(static_cast<int32_t>(bits))
                                         : static_cast<double>(bits);
    }

private:
    uint32_t execute(uint32_t index);
    void fill_constants();
    void sample(const CpuInst& step);
    void size(const CpuInst& step);
    void begin(const CpuInst& step);
    void test(const CpuInst& step);
    uint32_t end(const CpuInst& step, uint32_t index);

    const Program& program_;
    std::span<const Texture> textures_;
    const Kernels& kernels_;
    const KernelTable<T>& kernel_table_;
    TileMemory<T>& memory_;
    size_t count_ = 0;
};

// Samples one texture at the points of a tile, in float. Results are those of
// Texture::sample_lod<float>() for each lane.
struct TileSample {
    size_t channels = 4;  // number of channels required; others of `out` may be overwritten
    const float* u = nullptr;
    const float* v = nullptr;
    const float* lod = nullptr;  // not read if the texture has one level
    std::array<float*, 4> out{};
    size_t count = 0;  // at most tile_points
};
void sample_tile(const Texture& texture, const Kernels& kernels, const TileSample& sample);

extern template class Tile<float>;
extern template class Tile<double>;

}  // namespace wrinkle
