// A program on many points, floats in and floats out: each lane of an input and of an output is an
// array of its own with one number a point. What evaluate<float>() gives, to the last bit, without
// doubles between; for whoever makes pictures.
//
// The caller splits the work between threads, each with a PlaneScratch of its own; how it is split,
// and which instruction set runs it, changes no bit. Integers come as the nearest float, bools as 0
// and 1. Outputs may not overlap inputs or each other. Planes at multiples of 64 bytes are read
// fastest, and those of one chunk better do not lie whole multiples of 4096 bytes apart.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "cpu/evaluate.h"

namespace wrinkle {

struct Planes {
    std::vector<const float*> inputs;  // by index of Program::inputs, `count` floats each
    // By lane, over Program::outputs in order: those of output 0, then those of output 1, ...
    std::vector<float*> outputs;
};

// The memory of one thread's evaluations, allocated by the first and kept for the next.
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

// Textures stand by resource index.
void evaluate_planes(const Program& program, std::span<const Texture> textures,
                     const Planes& planes, size_t count, PlaneScratch& scratch,
                     InstructionSet set = default_instruction_set());

}  // namespace wrinkle
