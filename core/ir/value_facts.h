// What is known of every value of a module before it is expanded.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

class ValueFacts {
public:
    explicit ValueFacts(const Module& module);
    void update();  // looks at what was added since; linear in that

    // Which surface inputs it changes with, a bit per SurfaceInput; bits of region bodies count,
    // those of a detached value and of what goes in steps do not.
    uint32_t dependencies(Id id) const { return facts_[id] & all_inputs; }
    // Whether it may jump from pixel to pixel where its forward derivative does not, so that
    // hardware differences of it are no footprint: what goes in steps, is chosen, goes once around,
    // is found by a loop, or is read from a texture and then detached.
    bool jumps(Id id) const { return facts_[id] & jumping; }
    // Whether it comes from a texture.
    bool reads(Id id) const { return facts_[id] & reading; }

private:
    // One bit for each thing known, so that a value takes over what its operands have in one step.
    using Facts = uint32_t;
    static constexpr Facts jumping = 1U << 30, reading = 1U << 31, all_inputs = jumping - 1;

    // What an op makes of what is known of its operands.
    struct Effect {
        Facts keeps = ~Facts{0}, adds = 0;
    };
    static const std::array<Effect, tables::op_count> effects;

    Facts of(Id id) const;
    static Facts of_op(const Inst& inst, Facts facts);
    Facts of_region(Id id) const;

    const Module* module_;
    std::vector<Facts> facts_{0};  // by Id
};

bool is_position_alone(uint32_t dependencies);

}  // namespace wrinkle
