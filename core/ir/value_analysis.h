// Data-flow facts about every value of a module before it is expanded.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

class ValueAnalysis {
public:
    explicit ValueAnalysis(const Module& module);
    void update();  // processes values added since the last call; linear in their number

    // Surface inputs that the value depends on, a bit per SurfaceInput. Includes those of region
    // bodies; excludes those of detached values and of ops with derivative zero (e.g. floor).
    uint32_t dependencies(Id id) const { return facts_[id] & all_inputs; }
    // Returns true if the value may be discontinuous between pixels where its forward derivative is
    // not, so that its hardware differences are not a footprint: it depends on a rounding,
    // remainder, select, atan2 or loop of values that vary over the surface, or on a texture read
    // that is detached.
    bool is_discontinuous(Id id) const { return facts_[id] & jumping; }
    // Returns true if the value depends on a texture read.
    bool samples_texture(Id id) const { return facts_[id] & reading; }

private:
    // One bit per fact, so that a value inherits those of its operands in one operation.
    using Facts = uint32_t;
    static constexpr Facts varying = 1U << 29, jumping = 1U << 30, reading = 1U << 31,
                           all_inputs = varying - 1;

    // Effect of an op on the facts of its operands.
    struct Effect {
        Facts keeps = ~Facts{0}, adds = 0;
    };
    static const std::array<Effect, tables::op_count> effects;

    Facts of(Id id) const;
    Facts of_op(const Inst& inst, Facts facts) const;
    Facts of_region(Id id) const;

    const Module* module_;
    std::vector<Facts> facts_{0};  // by Id
};

bool is_position_alone(uint32_t dependencies);

}  // namespace wrinkle
