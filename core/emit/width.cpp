// Estimated widths of expressions.
#include <array>

#include "emit/expression.h"

namespace wrinkle {
namespace {

// Characters of an operation without its operands: `all` fixed ones, plus `each` per operand if the
// number of operands varies.
struct OwnWidth {
    uint8_t all = 0, each = 0;
};

constexpr OwnWidth own_width_of(Op op) {
    constexpr uint8_t comma = 2;
    const auto spelling = static_cast<uint8_t>(info(op).glsl.size());
    const int arity = info(op).arity;
    const auto commas = static_cast<uint8_t>(arity > 0 ? comma * arity : 0);
    if (op == Op::construct_) return {4, comma};
    if (op == Op::select_) return {6};
    if (op == Op::sign_nonzero_) return {19};
    if (op == Op::input_) return {4 + 2 + 2 + 17};
    if (reads_image(op)) return {static_cast<uint8_t>(spelling + commas)};
    if (info(op).precedence) return {static_cast<uint8_t>(spelling + 2)};
    return {static_cast<uint8_t>(spelling + commas), arity < 0 ? comma : uint8_t{0}};
}

constexpr auto own_widths = [] {
    std::array<OwnWidth, tables::op_count> table;
    for (size_t i = 0; i < table.size(); ++i)
        table[i] = own_width_of(static_cast<Op>(i));
    return table;
}();

}  // namespace

// A named constant counts as its literal, so that statements do not depend on the material's name.
uint32_t leaf_width(const EmitAnalysis& analysis, const Symbols& symbols, Id leaf) {
    const Module& m = analysis.module();
    const Inst& inst = m[leaf];
    switch (inst.op) {
        case Op::literal_:
            return static_cast<uint32_t>(analysis.literal(leaf).size());
        case Op::parameter_:
            return static_cast<uint32_t>(symbols.parameters[inst.extra].size());
        case Op::input_:
            return static_cast<uint32_t>(info(input_of(inst.extra)).name.size() + 2);
        case Op::construct_: {
            uint32_t width = own_width(analysis, symbols, leaf);
            for (const Id part : analysis.operands(leaf))
                width += leaf_width(analysis, symbols, part);
            return width;
        }
        case Op::swizzle_:
            return leaf_width(analysis, symbols, analysis.strip_detach(inst.arg[0])) + 1 +
                   static_cast<uint32_t>(swizzle_count(inst.extra));
        default:
            return 2;
    }
}

uint32_t own_width(const EmitAnalysis& analysis, const Symbols& symbols, Id id) {
    const Module& m = analysis.module();
    const Inst& inst = m[id];
    const auto operands = static_cast<uint32_t>(m.operands(id).size());
    if (inst.op == Op::result_) {
        const std::string& function = symbols.functions[m[inst.arg[0]].extra];
        return static_cast<uint32_t>(function.size()) + 2 * operands;
    }
    const OwnWidth width = own_widths[static_cast<size_t>(inst.op)];
    const size_t image = reads_image(inst.op) ? symbols.resources[inst.extra].size() : 0;
    return width.all + width.each * operands + static_cast<uint32_t>(image);
}

}  // namespace wrinkle
