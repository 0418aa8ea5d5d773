#include "export/mtlx_ops.h"

#include <algorithm>
#include <array>

namespace wrinkle {

const MtlxCall* mtlx_call(Op op) {
    static const std::vector<MtlxCall> calls = {
        {Op::add_, "add", {"in1", "in2"}},
        {Op::sub_, "subtract", {"in1", "in2"}},
        {Op::mul_, "multiply", {"in1", "in2"}},
        {Op::div_, "divide", {"in1", "in2"}},
        {Op::mod_, "modulo", {"in1", "in2"}},
        {Op::min_, "min", {"in1", "in2"}},
        {Op::max_, "max", {"in1", "in2"}},
        {Op::pow_, "power", {"in1", "in2"}},
        {Op::abs_, "absval", {"in"}},
        {Op::sign_, "sign", {"in"}},
        {Op::floor_, "floor", {"in"}},
        {Op::ceil_, "ceil", {"in"}},
        {Op::fract_, "fract", {"in"}},
        {Op::sqrt_, "sqrt", {"in"}},
        {Op::exp_, "exp", {"in"}},
        {Op::log_, "ln", {"in"}},
        {Op::sin_, "sin", {"in"}},
        {Op::cos_, "cos", {"in"}},
        {Op::tan_, "tan", {"in"}},
        {Op::asin_, "asin", {"in"}},
        {Op::acos_, "acos", {"in"}},
        {Op::atan_, "atan2", {"iny"}},
        {Op::atan2_, "atan2", {"iny", "inx"}},
        {Op::clamp_, "clamp", {"in", "low", "high"}},
        {Op::mix_, "mix", {"bg", "fg", "mix"}},
        {Op::smoothstep_, "smoothstep", {"low", "high", "in"}},
        {Op::dot_, "dotproduct", {"in1", "in2"}},
        {Op::cross_, "crossproduct", {"in1", "in2"}},
        {Op::length_, "magnitude", {"in"}},
        {Op::normalize_, "normalize", {"in"}},
        {Op::neg_, "subtract", {"in2"}},
        {Op::inversesqrt_, "power", {"in1"}},
    };
    const auto found = std::ranges::find(calls, op, &MtlxCall::op);
    return found == calls.end() ? nullptr : &*found;
}

const MtlxComparison* mtlx_comparison(Op op) {
    static constexpr std::array comparisons = {
        MtlxComparison{Op::gt_, "ifgreater", false, false},
        MtlxComparison{Op::lt_, "ifgreater", true, false},
        MtlxComparison{Op::ge_, "ifgreatereq", false, false},
        MtlxComparison{Op::le_, "ifgreatereq", true, false},
        MtlxComparison{Op::eq_, "ifequal", false, false},
        MtlxComparison{Op::ne_, "ifequal", false, true},
    };
    const auto found = std::ranges::find(comparisons, op, &MtlxComparison::op);
    return found == comparisons.end() ? nullptr : &*found;
}

MtlxSurface mtlx_surface(uint32_t extra) {
    for (int set = 0; set < 4; ++set)
        if (extra == input_extra(static_cast<SurfaceInput>(WR_SURFACE_uv0 + set), Variant::value))
            return {"texcoord", "vector2", set};
    if (extra == input_extra(SurfaceInput::position_, Variant::value))
        return {"position", "vector3", -1};
    return {"", "", -1};
}

}  // namespace wrinkle
