// What is known of every value of a module before it is expanded.
#pragma once

#include <cstdint>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

class ValueFacts {
public:
    explicit ValueFacts(const Module& module) : module_(&module) { update(); }

    // Looks at what was added since. Linear in that.
    void update();

    // Which surface inputs it changes with, a bit per SurfaceInput; bits of region bodies count,
    // those of a detached value and of what goes in steps do not.
    uint32_t dependencies(Id id) const { return facts_[id].dependencies; }
    // Whether it may jump from pixel to pixel where its forward derivative does not, so that
    // hardware differences of it are no footprint: what goes in steps, is chosen, goes once around,
    // is found by a loop, or is read from a texture and then detached.
    bool jumps(Id id) const { return facts_[id].jumps; }
    // Whether it comes from a texture.
    bool reads(Id id) const { return facts_[id].reads; }

private:
    struct Facts {
        uint32_t dependencies = 0;
        bool jumps = false, reads = false;
    };
    Facts of(Id id) const;
    void add_jumps(Id id, Facts& facts) const;
    void add_dependencies(Id id, Facts& facts) const;

    const Module* module_;
    std::vector<Facts> facts_;  // by Id
};

bool is_position_alone(uint32_t dependencies);

}  // namespace wrinkle
