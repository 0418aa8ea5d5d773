#include "export/mtlx_support.h"

#include <algorithm>
#include <cmath>

#include "export/mtlx_ops.h"

namespace wrinkle {

std::vector<double> mtlx_constant(const Module& module, Id value) {
    const int size = info(module.type(value)).lanes;
    if (size < 1 || size > 4 || !module.is_constant(value)) return {};
    const auto numbers = module.lanes_of(value);
    return {numbers.begin(), numbers.begin() + size};
}

MtlxSupport::MtlxSupport(const Module& module)
    : module_(module), supported_(module.size()), linear_(module.size()) {
    for (Id id = 1; id < module.size(); ++id) {
        if (module[id].level > 0) continue;
        const Type type = module.type(id);
        if (type == Type::float_ || type == Type::vec2_) linear_[id] = linear_of(id);
        supported_[id] = is_supported(id);
    }
}

bool MtlxSupport::has_normal(Id value) const {
    const Inst& inst = module_[value];
    if (inst.op == Op::resolve_) return supported_[inst.arg[0]];
    return inst.op == Op::input_ && input_of(inst.extra) == SurfaceInput::normal_;
}

bool MtlxSupport::has_all(std::span<const Id> operands) const {
    return std::ranges::all_of(operands, [&](Id operand) { return supported_[operand]; });
}

bool MtlxSupport::is_comparison(Id id) const {
    const Inst& inst = module_[id];
    return mtlx_comparison(inst.op) && module_.type(inst.arg[0]) == Type::float_ &&
           has_all(module_.operands(id));
}

bool MtlxSupport::is_supported(Id id) const {
    const Inst& inst = module_[id];
    const auto operands = module_.operands(id);
    if (inst.op == Op::frame_) return has_frame(id);
    if (module_.type(id) == Type::derivative_ || module_.type(id) == Type::gradient_)
        return is_gradient_supported(id);
    if (!is_float_type(module_.type(id))) return false;
    switch (inst.op) {
        case Op::literal_:
        case Op::parameter_:
            return true;
        case Op::input_:
            return !mtlx_surface(inst.extra).category.empty();
        case Op::to_float_:
            return is_comparison(operands[0]);
        case Op::select_:
            return is_comparison(operands[0]) && has_all(operands.subspan(1));
        case Op::step_:
            return module_.type(id) == Type::float_ && has_all(operands);
        case Op::construct_:
        case Op::swizzle_:
        case Op::sample_:
            return has_all(operands);
        default:
            return mtlx_call(inst.op) && has_all(operands);
    }
}

// Slopes of one base can be added; a base other than the surface has another frame.
bool MtlxSupport::is_gradient_supported(Id id) const {
    const Inst& inst = module_[id];
    const auto operands = module_.operands(id);
    switch (inst.op) {
        case Op::derivative_:
        case Op::normal_derivative_:
            return has_all(operands);
        case Op::gradient_zero_:
        case Op::gradient_from_derivative_:
        case Op::gradient_add_:
        case Op::gradient_scale_:
        case Op::gradient_mix_:
            return inst.extra == no_id && has_all(operands);
        default:
            return false;
    }
}

bool MtlxSupport::has_frame(Id frame) const {
    const Inst& inst = module_[frame];
    const uint32_t method = inst.extra & 0xFF, scale = inst.extra >> 8;
    if (method != WR_FRAME_vertex && method != WR_FRAME_auto) return false;
    const auto& uv = linear_[module_.operands(frame)[0]];
    return scale == WR_SCALE_unit && uv && std::abs(uv->determinant()) > 1e-12;
}

std::optional<MtlxSupport::Linear> MtlxSupport::linear_of(Id id) const {
    const Inst& inst = module_[id];
    const auto operands = module_.operands(id);
    if (module_.is_constant(id)) return Linear{};
    switch (inst.op) {
        case Op::input_:
            if (inst.extra != input_extra(SurfaceInput::uv0_, Variant::value)) return {};
            return Linear{{{{1, 0}, {0, 1}}}};
        case Op::add_:
        case Op::sub_:
            return linear_sum(id);
        case Op::mul_:
            return linear_product(id);
        default:
            break;
    }
    const bool is_known = !operands.empty() && std::ranges::all_of(operands, [&](Id operand) {
        return linear_[operand].has_value();
    });
    if (!is_known) return {};
    Linear made = *linear_[operands[0]];
    if (inst.op == Op::neg_) {
        for (auto& row : made.rows)
            row = {-row[0], -row[1]};
        return made;
    }
    if (inst.op == Op::construct_ && operands.size() == 2)
        return Linear{{made.rows[0], linear_[operands[1]]->rows[0]}};
    if (inst.op != Op::swizzle_) return {};
    for (int row = 0; row < swizzle_count(inst.extra); ++row)
        made.rows[static_cast<size_t>(row)] =
            linear_[operands[0]]->rows[static_cast<size_t>(swizzle_component(inst.extra, row))];
    return made;
}

std::optional<MtlxSupport::Linear> MtlxSupport::linear_sum(Id id) const {
    const Inst& inst = module_[id];
    const auto &a = linear_[inst.arg[0]], &b = linear_[inst.arg[1]];
    if (!a || !b) return {};
    const bool is_float_a = module_.type(inst.arg[0]) == Type::float_;
    const bool is_float_b = module_.type(inst.arg[1]) == Type::float_;
    const double sign = inst.op == Op::add_ ? 1 : -1;
    Linear made;
    for (size_t row = 0; row < 2; ++row)
        for (size_t i = 0; i < 2; ++i)
            made.rows[row][i] =
                a->rows[is_float_a ? 0 : row][i] + sign * b->rows[is_float_b ? 0 : row][i];
    return made;
}

std::optional<MtlxSupport::Linear> MtlxSupport::linear_product(Id id) const {
    const Inst& inst = module_[id];
    const size_t factor = module_.is_constant(inst.arg[1]) ? 1 : 0;
    const Id other = inst.arg[1 - factor];
    const auto numbers = mtlx_constant(module_, inst.arg[factor]);
    if (numbers.empty() || !linear_[other]) return {};
    const bool is_float = module_.type(other) == Type::float_;
    Linear made;
    for (size_t row = 0; row < 2; ++row)
        for (size_t i = 0; i < 2; ++i)
            made.rows[row][i] = linear_[other]->rows[is_float ? 0 : row][i] *
                                numbers[numbers.size() == 1 ? 0 : row];
    return made;
}

}  // namespace wrinkle
