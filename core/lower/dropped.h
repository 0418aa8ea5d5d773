// What went out of sight because numbers were literals while nodes were built; for core/lower
// alone.
//
// Frames, bases and errors are decided as if every number could change (ir/expand.h), so what was
// lowered with literals may be used only where that decides the same. A frame follows from the
// surface inputs that its uv changes with. An op drops some where its operands change with more
// than its result does (x * 0); what its node writes from then on, and what reads that node, may
// lack them. A frame whose uv changes with all of those has the same inputs either way. A base is
// the surface's normal by being that very value, which nothing that a node computes may become.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ir/value_facts.h"
#include "lower/flat.h"

namespace wrinkle {

class Dropped {
public:
    // `facts` are those of the module that is written.
    Dropped(const Module& module, ValueFacts& facts, const FlatGraph& graph)
        : module_(module), facts_(facts), graph_(graph), inputs_(graph.nodes.size(), 0) {}

    // The node is built now; what it reads has been.
    void begin(uint32_t node);
    // It wrote an op, or what stands in its place.
    void written(Op op, std::span<const Id> operands, Id result);
    // Something else was decided that a value may have a part in.
    void give_up() { decides_alike_ = false; }

    // Whether all was decided so far as it is with parameters.
    bool decides_alike() const { return decides_alike_; }

private:
    void judge_frame(Id uv, Id frame);
    void compare(Op op, std::span<const Id> operands, Id result);

    const Module& module_;
    ValueFacts& facts_;
    const FlatGraph& graph_;
    std::vector<uint32_t> inputs_;  // by node: what may have been dropped, a bit per SurfaceInput
    uint32_t node_ = 0;
    bool decides_alike_ = true;
};

}  // namespace wrinkle
