// Evaluates a program on many points in structure-of-arrays layout: each component of an input and
// of an output is a plane, an array with one float per point. Results are those of
// evaluate<float>(), bit for bit, without conversion to double; for rendering images.
//
// The caller splits the work between threads, each with its own PlaneScratch; the split and the
// instruction set do not change the results. Integers are converted to the nearest float, bools to
// 0 and 1. Outputs must not overlap inputs or each other. For speed, align planes to 64 bytes and
// avoid multiples of 4096 bytes as the distance between planes of one chunk.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "cpu/evaluate.h"

namespace wrinkle {

struct Planes {
    std::vector<const float*> inputs;  // by index of Program::inputs, `count` floats each
    // By component, over Program::outputs in order: those of output 0, then those of output 1, ...
    std::vector<float*> outputs;
};

// Memory of one thread's evaluations, allocated by the first one and reused by the next.
class PlaneScratch {
public:
    PlaneScratch();
    ~PlaneScratch();
    PlaneScratch(PlaneScratch&&) noexcept;
    PlaneScratch& operator=(PlaneScratch&&) noexcept;

private:
    friend void evaluate_planes(const Program&, std::span<const Texture>, const Planes&, size_t,
                                PlaneScratch&, InstructionSet);
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

// Evaluates `count` points. `textures` is indexed by resource.
void evaluate_planes(const Program& program, std::span<const Texture> textures,
                     const Planes& planes, size_t count, PlaneScratch& scratch,
                     InstructionSet set = default_instruction_set());

}  // namespace wrinkle
