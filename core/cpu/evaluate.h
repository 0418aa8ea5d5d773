// Numbers from a module, without a GPU: a tape over scalar registers, run on tiles of 256 points.
//
// compile_program() takes a module after expand() and explicit_lod() (no opaque op, of the samples
// sample_lod alone) and flattens it: vectors become lanes, calls are inlined, loops stay. Registers
// are used again as soon as nobody reads them, so scratch is bounded by what lives at once. A
// parameter has the value that the graph gives it. Linear time, no recursion over instructions.
//
// evaluate() is pure and may be called from several threads, each on its own range of points; the
// results do not depend on how points are split. float gives what shaders compute, double what they
// should. Semantics at the corners are those above the op table (wrinkle/plugin.h).
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "cpu/texture.h"
#include "ir/module.h"

namespace wrinkle {

// Surface points as arrays: [point * lanes + lane] by input and variant; empty where not given.
// Units and spaces as in the table of surface inputs; dx and dy are the change to the next pixel.
struct PointSet {
    size_t count = 0;
    std::array<std::array<std::vector<double>, 3>, surface_input_count> values;

    std::vector<double>& at(SurfaceInput input, Variant variant = Variant::value) {
        return values[static_cast<size_t>(input)][static_cast<size_t>(variant)];
    }
    const std::vector<double>& at(SurfaceInput input, Variant variant = Variant::value) const {
        return values[static_cast<size_t>(input)][static_cast<size_t>(variant)];
    }
};

// Whether values of this type stand in integer registers.
constexpr bool is_integer_type(Type type) {
    return type == Type::int_ || type == Type::uint_ || type == Type::bool_;
}

// One operation on a tile: on scalars, or on two or three lanes at once where that saves passes
// over memory (dot: a then b; cross; normalize). Registers of floats and of integers (bools: 0 or
// 1) are two files.
struct Step {
    enum class Kind : uint8_t {
        op,
        pair,         // second(op(in[0], in[1]), in[2]), or second(in[2], op(...))
        depth,        // max(max(|in[3]|, max(|in[0]|, |in[1]|) * in[2]), in[4])
        constant,     // Program::constants[extra]
        sample,       // in: u, v, lod; four outputs, of which the first `channels` are read, each
                      // less the number of Program::presets[bias - 1] where there is a bias
        size,         // two outputs
        move,         // out[0] = in[0]
        masked_move,  // the same, where the innermost loop still goes on
        loop_begin,   // extra: the greatest number of iterations
        loop_test,    // in[0]: go on
        loop_end,     // extra: the step of its loop_begin
    };
    Kind kind = Kind::op;
    Op op = Op::poison_;
    Op second = Op::poison_;
    bool swapped = false;
    Type type = Type::float_;  // of the operands' lanes
    uint8_t count = 0;         // operands
    uint8_t outputs = 0;
    uint8_t channels = 4;
    std::array<uint32_t, 4> out{};
    std::array<uint32_t, 6> in{};
    uint32_t extra = 0;  // resource, or see above
    uint32_t bias = 0;
    uint16_t loop = 0;  // loop_of() in step_loops.h, of kinds op, pair and depth
    // One more than the resource for whose lod alone this is computed; 0: for other things as well.
    uint32_t lod_of = 0;
};

struct Program {
    struct Input {
        SurfaceInput input;
        Variant variant;
        uint32_t lane;
        uint32_t reg;
    };
    struct Output {
        std::string name;
        Type type;
        uint32_t port_type;
        std::vector<uint32_t> regs;  // one a lane
    };
    // A register that holds one number from the first step to the last.
    struct Preset {
        double value;
        Type type;
        uint32_t reg;
    };
    std::vector<Step> steps;
    std::vector<Input> inputs;
    std::vector<Preset> presets;
    std::vector<double> constants;
    std::vector<Output> outputs;
    uint32_t float_registers = 0;
    uint32_t integer_registers = 0;
    uint64_t serial = 0;  // of this compilation in this process; 0: none
};

// Calls are written out. A program that would have more steps than this (a second's work to make),
// or functions that call each other deeper than this, are refused.
inline constexpr size_t max_program_steps = 4'000'000;
inline constexpr size_t max_call_depth = 200;

// An empty program, with the reason in `why`, when a limit is met.
Program compile_program(const Module& module, std::string& why,
                        size_t max_steps = max_program_steps);

// The values a program reads, each once, in the order of the enumerators.
struct InputNeed {
    SurfaceInput input = SurfaceInput::position_;
    Variant variant = Variant::value;
};
std::vector<InputNeed> needed_inputs(const Program& program);

// values[output][point * lanes + lane]
struct Results {
    std::vector<std::vector<double>> values;
};
Results make_results(const Program& program, size_t points);

// Which machine code runs the steps. Results are the same to the last bit.
enum class InstructionSet : uint8_t { baseline, avx2, avx512 };
bool is_available(InstructionSet set);
// The best there is, or the available one that the environment variable WRINKLE_ISA names:
// "baseline", "avx2", "avx512".
InstructionSet default_instruction_set();

// Points first ... first + count - 1 into `results`. Every needed input is given; textures stand by
// resource index.
template <class T>
void evaluate(const Program& program, const PointSet& points, std::span<const Texture> textures,
              size_t first, size_t count, Results& results,
              InstructionSet set = default_instruction_set());

extern template void evaluate<float>(const Program&, const PointSet&, std::span<const Texture>,
                                     size_t, size_t, Results&, InstructionSet);
extern template void evaluate<double>(const Program&, const PointSet&, std::span<const Texture>,
                                      size_t, size_t, Results&, InstructionSet);

}  // namespace wrinkle
