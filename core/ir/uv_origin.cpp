#include "ir/rewrite.h"
#include "ir/value.h"

namespace wrinkle {
namespace {

bool is_uv(const Inst& inst) {
    const SurfaceInput input = input_of(inst.extra);
    return inst.op == Op::input_ && input >= SurfaceInput::uv0_ && input <= SurfaceInput::uv3_;
}

Id raw_input(Module& target, const Inst& input) {
    return target.input(input_of(input.extra), variant_of(input.extra));
}

// Returns 1 - v, or -dv for a differential.
Value flipped_v(Value uv, bool differential) {
    return differential ? -uv.y() : number(uv, 1) - uv.y();
}

Id flipped(Module& target, Id uv, bool differential) {
    return vec2(Value{&target, uv}.x(), flipped_v({&target, uv}, differential)).id;
}

// Names v as well: frames read it without u.
Id flipped_input(Module& target, const Inst& input) {
    const bool differential = variant_of(input.extra) != Variant::value;
    constexpr std::string_view suffixes[] = {"", "_dx", "_dy"};  // by Variant
    const Id raw = raw_input(target, input);
    const std::string name = std::string(info(input_of(input.extra)).name.substr(1))
                                 .append(suffixes[static_cast<size_t>(variant_of(input.extra))]);
    surface_named(name, flipped_v({&target, raw}, differential));
    return flipped(target, raw, differential);
}

Id flip(void*, Module& target, const Module& source, Id id, std::span<const Id> mapped) {
    const Inst& inst = source[id];
    if (is_uv(inst)) return flipped_input(target, inst);
    if (!is_sample(inst.op)) return no_id;
    const auto of_image = [&](size_t k) {
        const Inst& operand = source[inst.arg[k]];
        if (is_uv(operand)) return raw_input(target, operand);
        return flipped(target, mapped[k], k > 0);
    };
    if (inst.op == Op::sample_) return target.add(Op::sample_, {of_image(0)}, inst.extra);
    if (inst.op == Op::sample_lod_)
        return target.add(Op::sample_lod_, {of_image(0), mapped[1]}, inst.extra);
    return target.add(Op::sample_grad_, {of_image(0), of_image(1), of_image(2)}, inst.extra);
}

}  // namespace

Module with_uv_origin_top(Module source) {
    return rebuild(std::move(source), flip, nullptr);
}

}  // namespace wrinkle
