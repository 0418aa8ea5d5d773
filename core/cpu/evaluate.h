// CPU evaluator: compiles a module to a list of steps on scalar registers, run on tiles of 512
// points.
//
// compile_program() takes a module after expand() and explicit_lod() (no opaque ops; sample_lod is
// the only sampling op) and flattens it: vectors are split into their components (lanes), calls are
// inlined, loops remain. Registers are reused after the last use of their value, so scratch memory
// is bounded by the values live at once. Parameters have the values of the graph;
// set_parameter() replaces those of the graph's inputs. Linear time, no
// recursion over instructions.
//
// evaluate() is pure and thread-safe for disjoint ranges of points; results do not depend on how
// points are split. float computes as shaders do, double is the accurate reference. Edge cases
// follow the comment above the op table (wrinkle/plugin.h).
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "cpu/texture.h"

namespace wrinkle {

class Module;              // ir/module.h
enum class Op : uint16_t;  // ir/op.h, like the next three
enum class Type : uint8_t;
enum class SurfaceInput : uint8_t;
enum class Variant : uint8_t;

// Surface points as arrays: [point * lanes + lane] by input and variant; empty if not given. Units
// and spaces are those of the table of surface inputs; dx and dy are differentials per pixel.
struct PointSet {
    static constexpr size_t inputs = 10;  // surface_input_count of ir/op.h
    size_t count = 0;
    std::array<std::array<std::vector<double>, 3>, inputs> values;

    std::vector<double>& at(SurfaceInput input, Variant variant = {}) {
        return values[static_cast<size_t>(input)][static_cast<size_t>(variant)];
    }
    const std::vector<double>& at(SurfaceInput input, Variant variant = {}) const {
        return values[static_cast<size_t>(input)][static_cast<size_t>(variant)];
    }
};

// One step of a program: an operation on a tile. Operands are scalars; dot (a, then b), cross and
// normalize take two or three components of a vector at once, which saves passes over memory. sin
// has two outputs, the sine and the cosine.
// Floats and whole numbers (is_whole_type(); bools are 0 or 1) are in two separate register files.
struct CpuInst {
    enum class Kind : uint8_t {
        op,
        pair,         // second(op(in[0], in[1]), in[2]), or second(in[2], op(...))
        hash,         // pcg_hash(in[0]), kernel_table.h
        sample,       // in: u, v, lod; four outputs, of which the first `channels` are read
        size,         // two outputs
        move,         // out[0] = in[0]
        masked_move,  // the same, in lanes in which the innermost loop is active
        loop_begin,   // extra: the maximum number of iterations
        loop_test,    // in[0]: the loop condition
        loop_end,     // extra: the index of the step of its loop_begin
    };
    Kind kind = Kind::op;
    Op op{};
    Op second{};
    bool swapped = false;
    Type type{};        // type of the operands
    uint8_t count = 0;  // number of operands
    uint8_t outputs = 0;
    uint8_t channels = 4;
    uint8_t uniform = 0;      // bit i: in[i] is a uniform register
    bool to_uniform = false;  // the outputs are uniform registers
    std::array<uint32_t, 4> out{};
    std::array<uint32_t, 6> in{};
    uint32_t extra = 0;   // resource index, or as listed at Kind
    uint16_t kernel = 0;  // kernel_index() in kernel_table.h, for the kinds that have one
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
        std::vector<uint32_t> regs;  // one per component
    };
    // A uniform register holds the same value at all points: a constant, or computed from uniform
    // registers. They are the first registers of their file.
    struct Constant {
        double value;
        Type type;
        uint32_t reg;
    };
    // A numeric input of the graph that the outputs depend on.
    struct Parameter {
        std::string name;
        std::vector<uint32_t> constants;  // indices into `constants`, one per component
    };
    std::vector<CpuInst> steps;
    std::vector<Input> inputs;
    std::vector<Constant> constants;
    std::vector<Parameter> parameters;
    std::vector<Output> outputs;
    uint32_t float_registers = 0, uniform_floats = 0;  // uniform ones are among the registers
    uint32_t integer_registers = 0, uniform_integers = 0;
    uint64_t serial = 0;  // unique id of these steps and constants within the process; 0: none
};

// Calls are inlined. Programs with more steps than this (about a second of compile time) or with
// deeper nested calls than this are refused.
inline constexpr size_t max_program_steps = 4'000'000;
inline constexpr size_t max_call_depth = 200;

// Returns an empty program and the reason in `why` if a limit is exceeded.
Program compile_program(const Module& module, std::string& why,
                        size_t max_steps = max_program_steps);

// Replaces the value of a parameter. Precondition: one value per component.
void set_parameter(Program& program, const Program::Parameter& parameter,
                   std::span<const double> value);

// Returns the inputs that a program reads, each once, in the order of the enumerators.
struct InputNeed {
    SurfaceInput input{};
    Variant variant{};
};
std::vector<InputNeed> needed_inputs(const Program& program);

// values[output][point * lanes + lane]
struct Results {
    std::vector<std::vector<double>> values;
};
Results make_results(const Program& program, size_t points);

// Instruction set of the kernels. Results are identical bit for bit.
enum class InstructionSet : uint8_t { baseline, avx2, avx512 };
bool is_available(InstructionSet set);
// Returns the best available set, or the available one named by the environment variable
// WRINKLE_ISA: "baseline", "avx2", "avx512".
InstructionSet default_instruction_set();

// Evaluates points first ... first + count - 1 into `results`. Precondition: every needed input is
// set. `textures` is indexed by resource.
template <class T>
void evaluate(const Program& program, const PointSet& points, std::span<const Texture> textures,
              size_t first, size_t count, Results& results,
              InstructionSet set = default_instruction_set());

extern template void evaluate<float>(const Program&, const PointSet&, std::span<const Texture>,
                                     size_t, size_t, Results&, InstructionSet);
extern template void evaluate<double>(const Program&, const PointSet&, std::span<const Texture>,
                                      size_t, size_t, Results&, InstructionSet);

}  // namespace wrinkle
