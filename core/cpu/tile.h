// A program's steps on one tile, at most tile_lanes points, in T. Part of evaluate() and
// evaluate_planes(), which fill the input registers before run() and read the outputs after it.
//
// TileMemory is what a tile needs to stand on: allocated for the first program, used again for
// every other that needs no more.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "cpu/aligned.h"
#include "cpu/evaluate.h"
#include "cpu/kernels.h"

namespace wrinkle {

// A loop under way: which lanes still go on, and how often it has run.
struct RunningLoop {
    std::array<uint8_t, tile_lanes> active;
    uint32_t iterations = 0;
    uint32_t limit = 0;
};

template <class T>
struct TileMemory {
    AlignedVector<T> floats;
    AlignedVector<uint32_t> integers;
    std::vector<T*> float_places;  // of each register
    std::vector<uint32_t*> integer_places;
    std::vector<uint32_t> next;  // of each step: the first from it on that is run
    std::vector<RunningLoop> loops;
    // For whom the presets stand in their registers and `next` is right.
    uint64_t serial = 0;
    std::vector<uint32_t> level_counts;
};

template <class T>
class Tile {
public:
    Tile(const Program& program, std::span<const Texture> textures, InstructionSet set,
         TileMemory<T>& memory);

    T* floats(uint32_t reg) { return memory_.float_places[reg]; }
    uint32_t* integers(uint32_t reg) { return memory_.integer_places[reg]; }

    // Has a register of floats elsewhere, in as many lanes as will run: an input's that nobody
    // writes, or an output's.
    void place(uint32_t reg, T* lanes) { memory_.float_places[reg] = lanes; }

    void run(size_t count);

    // What lane k of one of an output's registers means.
    double value(const Program::Output& output, uint32_t reg, size_t k) {
        if (!is_integer_type(output.type)) return static_cast<double>(floats(reg)[k]);
        const uint32_t bits = integers(reg)[k];
        return output.type == Type::int_ ? static_cast<double>(static_cast<int32_t>(bits))
                                         : static_cast<double>(bits);
    }

private:
    uint32_t execute(uint32_t index);
    bool is_prepared();
    void skip_lods();
    void fill(uint32_t reg, Type type, double value, size_t count);
    void sample(const Step& step);
    void size(const Step& step);
    void move(const Step& step, const uint8_t* mask);
    void begin(const Step& step);
    void test(const Step& step);
    uint32_t end(const Step& step, uint32_t index);

    const Program& program_;
    std::span<const Texture> textures_;
    const Kernels& kernels_;
    const StepLoops<T>& loops_;
    TileMemory<T>& memory_;
    size_t count_ = 0;
};

extern template class Tile<float>;
extern template class Tile<double>;

}  // namespace wrinkle
