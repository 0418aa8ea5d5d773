#include "lower/dropped.h"

#include <algorithm>

#include "ir/derive.h"
#include "ir/gradient_frame.h"
#include "ir/surface.h"

namespace wrinkle {
namespace {

bool changes_with_operands(Op op, Type result) {
    Inst inst;
    inst.op = op;
    inst.type = result;
    return op != Op::resolve_ && !never_changes(inst);
}

// It changes with all that its operands change with, then.
bool stands_as_written(const Inst& made, Op op, std::span<const Id> operands) {
    bool same = made.op == op;
    for (size_t i = 0; same && i < operands.size(); ++i)
        same = operands[i] == made.arg[i];
    return same;
}

// x * 1, or what is computed of literals alone: nothing is dropped.
bool drops_literals_alone(const Module& m, std::span<const Id> operands, Id result) {
    return std::all_of(operands.begin(), operands.end(),
                       [&](Id operand) { return operand == result || m.is_constant(operand); });
}

}  // namespace

void Dropped::begin(uint32_t node) {
    node_ = node;
    const FlatNode& flat = graph_.nodes[node];
    for (uint32_t port = 0; port < graph_.port_count(flat); ++port) {
        const Wire& wire = graph_.wire(flat, port);
        if (wire.kind == Wire::Kind::node) inputs_[node] |= inputs_[wire.from];
    }
}

void Dropped::written(Op op, std::span<const Id> operands, Id result) {
    if (result == poison) return;
    if (is_surface_normal(module_, result)) give_up();  // it may have become that by a value
    if (op == Op::base_) {
        if (!is_surface_normal(module_, operands[0])) give_up();
    } else if (op == Op::frame_) {
        judge_frame(operands[0], result);
    } else if (!stands_as_written(module_[result], op, operands)) {
        const bool plain = changes_with_operands(op, module_.type(result)) &&
                           drops_literals_alone(module_, operands, result);
        if (!plain) compare(op, operands, result);
    }
}

void Dropped::judge_frame(Id uv, Id frame) {
    facts_.update();
    const uint32_t inputs = facts_.dependencies(uv);
    if ((inputs_[node_] & ~inputs) != 0 || !fits_its_scale(module_[frame].extra, inputs)) give_up();
}

// What the operands change with, with what the result does.
void Dropped::compare(Op op, std::span<const Id> operands, Id result) {
    facts_.update();
    uint32_t before = 0;
    for (const Id operand : operands)
        before |= facts_.dependencies(operand);
    const uint32_t after = facts_.dependencies(result);
    if (!changes_with_operands(op, module_.type(result))) {
        if (after != 0) give_up();
    } else {
        inputs_[node_] |= before & ~after;
    }
}

}  // namespace wrinkle
