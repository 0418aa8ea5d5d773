// Columns of the op table that are not part of the plugin contract: what an op costs, and the word
// that names its value in generated source. An op without a row costs one operation per component
// of its result and is called by its own name.
#pragma once

#include <array>
#include <string_view>

#include "ir/op.h"

namespace wrinkle {

// Operations = per_component * components of the result
//            + per_operand * components of the first operand + fixed.
struct OpTraits {
    std::string_view word;
    int per_component = 1, per_operand = 0, fixed = 0;
};

namespace tables {

struct OpRow {
    Op op;
    OpTraits traits;
};
inline constexpr OpRow op_rows[] = {
    {Op::poison_, {"", 0}},
    {Op::literal_, {"", 0}},
    {Op::input_, {"", 0}},
    {Op::parameter_, {"", 0}},
    {Op::region_param_, {"", 0}},
    {Op::material_, {"", 0}},
    {Op::loop_, {"", 0}},
    {Op::call_, {"", 0}},
    {Op::result_, {"", 0}},
    {Op::detach_, {"", 0}},
    {Op::image_size_, {"size", 0}},
    {Op::sample_, {"texel", 0}},
    {Op::sample_lod_, {"texel", 0}},
    {Op::sample_grad_, {"texel", 0}},
    {Op::construct_, {"vector", 0}},
    {Op::swizzle_, {"", 0}},
    {Op::column_, {"", 0}},
    {Op::transpose_, {"transposed", 0}},
    {Op::add_, {"sum"}},
    {Op::sub_, {"difference"}},
    {Op::mul_, {"product"}},
    {Op::div_, {"quotient"}},
    {Op::mod_, {"remainder"}},
    {Op::neg_, {"negated"}},
    {Op::abs_, {"magnitude"}},
    {Op::sign_nonzero_, {"sign", 2}},
    {Op::floor_, {"floored"}},
    {Op::ceil_, {"raised"}},
    {Op::fract_, {"fraction"}},
    {Op::min_, {"least"}},
    {Op::max_, {"greatest"}},
    {Op::clamp_, {"clamped", 2}},
    {Op::mix_, {"mixed", 3}},
    {Op::step_, {"edge"}},
    {Op::smoothstep_, {"ramp", 7}},
    {Op::sqrt_, {"root"}},
    {Op::inversesqrt_, {"inverse_root"}},
    {Op::pow_, {"power", 3}},
    {Op::exp_, {"exponential"}},
    {Op::exp2_, {"exponential"}},
    {Op::log_, {"logarithm"}},
    {Op::log2_, {"logarithm"}},
    {Op::sin_, {"sine"}},
    {Op::cos_, {"cosine"}},
    {Op::asin_, {"angle"}},
    {Op::acos_, {"angle"}},
    {Op::atan_, {"angle"}},
    {Op::atan2_, {"angle"}},
    {Op::dot_, {"dot_product", 0, 2, -1}},
    {Op::length_, {"extent", 0, 2}},
    {Op::cross_, {"cross_product", 0, 0, 9}},
    {Op::normalize_, {"unit", 3}},
    {Op::reflect_, {"reflected", 4}},
    {Op::transform_, {"transformed", 0, 0, 15}},
    {Op::matrix_product_, {"product", 0, 0, 45}},
    {Op::lt_, {"test"}},
    {Op::le_, {"test"}},
    {Op::gt_, {"test"}},
    {Op::ge_, {"test"}},
    {Op::eq_, {"test"}},
    {Op::ne_, {"test"}},
    {Op::and_, {"test"}},
    {Op::or_, {"test"}},
    {Op::not_, {"test"}},
    {Op::select_, {"choice"}},
    {Op::bit_and_, {"bits"}},
    {Op::bit_or_, {"bits"}},
    {Op::bit_xor_, {"bits"}},
    {Op::shift_left_, {"bits"}},
    {Op::shift_right_, {"bits"}},
    {Op::to_float_, {"number"}},
    {Op::to_int_, {"whole"}},
    {Op::to_uint_, {"whole"}},
};
inline constexpr auto op_traits = [] {
    std::array<OpTraits, op_count> table{};
    for (const auto& [op, traits] : op_rows)
        table[static_cast<size_t>(op)] = traits;
    for (size_t op = 0; op < op_count; ++op)
        if (table[op].word.empty()) table[op].word = ops[op].name;
    return table;
}();

}  // namespace tables

constexpr const OpTraits& traits(Op op) {
    return tables::op_traits[static_cast<size_t>(op)];
}

}  // namespace wrinkle
