#include "ir/interpret.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace wrinkle::test {

// Values used by an instruction in its own scope; for a loop, also those captured by its body.
std::vector<Id> Interpreter::reads(Id id) const {
    const Module& m = *module_;
    const auto operands = m.operands(id);
    std::vector<Id> list(operands.begin(), operands.end());
    if (m[id].op != Op::loop_) return list;
    const Region& region = m.region(m[id].extra);
    for (const Id inner : body(region.results, region.level))
        for (const Id read : reads(inner))
            if (m[read].level < region.level) list.push_back(read);
    for (const Id result : region.results)
        if (m[result].level < region.level) list.push_back(result);
    return list;
}

// Values needed by the roots at this region depth or deeper, in order of evaluation.
std::vector<Id> Interpreter::body(std::span<const Id> roots, int level) const {
    std::set<Id> found;
    std::vector<Id> open(roots.begin(), roots.end());
    while (!open.empty()) {
        const Id id = open.back();
        open.pop_back();
        if ((*module_)[id].level < level || !found.insert(id).second) continue;
        for (const Id read : reads(id))
            open.push_back(read);
    }
    return {found.begin(), found.end()};
}

Lanes Interpreter::value(Id root) {
    Scope scope;
    run(body(std::span(&root, 1), 0), scope);
    return scope.values[root];
}

void Interpreter::run(std::span<const Id> list, Scope& scope) {
    for (const Id id : list) {
        const Op op = (*module_)[id].op;
        if (op == Op::region_param_) continue;
        if (op == Op::call_)
            scope.tuples[id] = call(id, scope);
        else if (op == Op::loop_)
            scope.tuples[id] = loop(id, scope);
        else
            scope.values[id] = compute(id, scope);
    }
}

Lanes Interpreter::compute(Id id, Scope& scope) {
    const Inst& inst = (*module_)[id];
    switch (inst.op) {
        case Op::literal_:
            return {inst.value};
        case Op::input_: {
            const auto found = around_->inputs.find(inst.extra);
            return found == around_->inputs.end() ? Lanes{} : found->second;
        }
        case Op::parameter_: {
            const auto& value = module_->parameters[inst.extra].value;
            return {value[0], value[1], value[2], value[3]};
        }
        case Op::result_:
            return scope.tuples.at(inst.arg[0]).at(inst.extra);
        case Op::image_size_:
            return around_->image_size(inst.extra);
        case Op::sample_:
        case Op::sample_lod_:
        case Op::sample_grad_:
            return sample(inst, scope);
        default:
            break;
    }
    std::vector<Type> types;
    std::vector<Lanes> values;
    for (const Id operand : module_->operands(id)) {
        types.push_back(module_->type(operand));
        values.push_back(scope.values.at(operand));
    }
    return apply_op(inst.op, inst.type, inst.extra, types, values);
}

Lanes Interpreter::sample(const Inst& inst, const Scope& scope) const {
    const Lanes uv = scope.values.at(inst.arg[0]);
    double lod = 0;
    if (inst.op == Op::sample_lod_) lod = scope.values.at(inst.arg[1])[0];
    if (inst.op == Op::sample_grad_) {
        const Lanes size = around_->image_size(inst.extra);
        const Lanes dx = scope.values.at(inst.arg[1]), dy = scope.values.at(inst.arg[2]);
        lod = std::log2(std::max(std::hypot(dx[0] * size[0], dx[1] * size[1]),
                                 std::hypot(dy[0] * size[0], dy[1] * size[1])));
    }
    return around_->texture(inst.extra, uv[0], uv[1], lod);
}

std::vector<Lanes> Interpreter::call(Id id, Scope& scope) {
    const Module& m = *module_;
    const Region& region = m.region(m[id].extra);
    Scope inside;
    const std::vector<Id> list = body(region.results, 0);
    for (const Id inner : list)
        if (m[inner].op == Op::region_param_ && m[inner].level == 1)
            inside.values[inner] = scope.values.at(m.operands(id)[m[inner].extra]);
    run(list, inside);
    std::vector<Lanes> results;
    for (const Id result : region.results)
        results.push_back(inside.values.at(result));
    return results;
}

std::vector<Lanes> Interpreter::loop(Id id, Scope& scope) {
    const Module& m = *module_;
    const Region& region = m.region(m[id].extra);
    std::vector<Lanes> state;
    for (const Id arg : m.operands(id))
        state.push_back(scope.values.at(arg));
    const std::vector<Id> list = body(region.results, region.level);
    for (uint32_t i = 0; i < region.max_iterations; ++i) {
        for (const Id inner : list)
            if (m[inner].op == Op::region_param_ && m[inner].level == region.level)
                scope.values[inner] = state[m[inner].extra];
        run(list, scope);
        if (scope.values.at(region.results[0])[0] == 0) break;
        for (size_t k = 0; k < state.size(); ++k)
            state[k] = scope.values.at(region.results[k + 1]);
    }
    return state;
}

namespace {

double on_floats(Op op, double a, double b, double c) {
    switch (op) {
        case Op::neg_:
            return -a;
        case Op::add_:
            return a + b;
        case Op::sub_:
            return a - b;
        case Op::mul_:
            return a * b;
        case Op::div_:
            return a / b;
        case Op::mod_:
            return a - b * std::floor(a / b);
        case Op::abs_:
            return std::abs(a);
        case Op::sign_:
            return (a > 0) - (a < 0);
        case Op::floor_:
            return std::floor(a);
        case Op::ceil_:
            return std::ceil(a);
        case Op::fract_:
            return a - std::floor(a);
        case Op::min_:
            return b < a ? b : a;
        case Op::max_:
            return a < b ? b : a;
        case Op::clamp_:
            return on_floats(Op::min_, on_floats(Op::max_, a, b, 0), c, 0);
        case Op::mix_:
            return (1 - c) * a + c * b;
        case Op::step_:
            return b < a ? 0 : 1;
        case Op::smoothstep_: {
            const double t = std::min(std::max((c - a) / (b - a), 0.0), 1.0);
            return 3 * t * t - 2 * t * t * t;
        }
        case Op::sign_nonzero_:
            return a < 0 ? -1 : 1;
        case Op::sqrt_:
            return std::sqrt(a);
        case Op::inversesqrt_:
            return 1 / std::sqrt(a);
        case Op::pow_:
            return std::pow(a, b);
        case Op::exp_:
            return std::exp(a);
        case Op::log_:
            return std::log(a);
        case Op::exp2_:
            return std::exp2(a);
        case Op::log2_:
            return std::log2(a);
        case Op::sin_:
            return std::sin(a);
        case Op::cos_:
            return std::cos(a);
        case Op::tan_:
            return std::tan(a);
        case Op::asin_:
            return std::asin(a);
        case Op::acos_:
            return std::acos(a);
        case Op::atan_:
            return std::atan(a);
        case Op::atan2_:
            return std::atan2(a, b);
        default:
            return std::nan("");  // an op of the table that is missing here: tests fail on it
    }
}

// Operates on 32-bit words; `is_signed` selects their interpretation.
double on_words(Op op, double x, double y, bool is_signed) {
    const auto a = static_cast<uint32_t>(static_cast<int64_t>(x));
    const auto b = static_cast<uint32_t>(static_cast<int64_t>(y));
    uint32_t r = 0;
    switch (op) {
        case Op::neg_:
            r = 0u - a;
            break;
        case Op::add_:
            r = a + b;
            break;
        case Op::sub_:
            r = a - b;
            break;
        case Op::mul_:
            r = a * b;
            break;
        case Op::min_:
            return std::min(x, y);
        case Op::max_:
            return std::max(x, y);
        case Op::bit_and_:
            r = a & b;
            break;
        case Op::bit_or_:
            r = a | b;
            break;
        case Op::bit_xor_:
            r = a ^ b;
            break;
        case Op::shift_left_:
            r = a << b;
            break;
        case Op::shift_right_:
            r = a >> b;
            if (is_signed && b > 0 && a >> 31) r |= ~0u << (32 - b);
            break;
        default:
            return std::nan("");
    }
    return is_signed ? static_cast<double>(static_cast<int32_t>(r)) : static_cast<double>(r);
}

double on_scalars(Op op, double a, double b) {
    switch (op) {
        case Op::lt_:
            return a < b;
        case Op::le_:
            return a <= b;
        case Op::gt_:
            return a > b;
        case Op::ge_:
            return a >= b;
        case Op::eq_:
            return a == b;
        case Op::ne_:
            return a != b;
        case Op::and_:
            return a != 0 && b != 0;
        case Op::or_:
            return a != 0 || b != 0;
        default:
            return a == 0;  // not
    }
}

Lanes product(const Lanes& matrix, const Lanes& b, int columns) {
    Lanes r{};
    for (int column = 0; column < columns; ++column)
        for (int row = 0; row < 3; ++row)
            for (int k = 0; k < 3; ++k)
                r[static_cast<size_t>(column * 3 + row)] +=
                    matrix[static_cast<size_t>(k * 3 + row)] *
                    b[static_cast<size_t>(column * 3 + k)];
    return r;
}

double inner(const Lanes& a, const Lanes& b, size_t lanes) {
    double sum = 0;
    for (size_t i = 0; i < lanes; ++i)
        sum += a[i] * b[i];
    return sum;
}

Lanes joined(std::span<const Type> types, std::span<const Lanes> values) {
    Lanes r{};
    size_t next = 0;
    for (size_t part = 0; part < values.size(); ++part)
        for (size_t i = 0; i < info(types[part]).lanes; ++i)
            r[next++] = values[part][i];
    return r;
}

Lanes as_whole(Op op, uint32_t extra, std::span<const Type> types, std::span<const Lanes> v) {
    Lanes r{};
    const Lanes& a = v[0];
    const size_t lanes = info(types[0]).lanes;
    switch (op) {
        case Op::construct_:
            return joined(types, v);
        case Op::swizzle_:
            for (size_t i = 0; i < (extra & 15); ++i)
                r[i] = a[extra >> (4 + 4 * i) & 15];
            return r;
        case Op::column_:
            return {a[extra * 3], a[extra * 3 + 1], a[extra * 3 + 2]};
        case Op::dot_:
            return {inner(a, v[1], lanes)};
        case Op::length_:
            return {std::sqrt(inner(a, a, lanes))};
        case Op::cross_:
            return {a[1] * v[1][2] - a[2] * v[1][1], a[2] * v[1][0] - a[0] * v[1][2],
                    a[0] * v[1][1] - a[1] * v[1][0]};
        case Op::normalize_:
            for (size_t i = 0; i < lanes; ++i)
                r[i] = a[i] / std::sqrt(inner(a, a, lanes));
            return r;
        case Op::reflect_:
            for (size_t i = 0; i < lanes; ++i)
                r[i] = a[i] - 2 * inner(a, v[1], lanes) * v[1][i];
            return r;
        case Op::transform_:
            return product(a, v[1], 1);
        case Op::matrix_product_:
            return product(a, v[1], 3);
        case Op::transpose_:
            return {a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]};
        case Op::select_:
            return a[0] != 0 ? v[1] : v[2];
        case Op::to_float_:
        case Op::detach_:
        case Op::with_covariance_:
            return a;
        case Op::to_int_: {
            const auto word = static_cast<int64_t>(a[0]);
            return {static_cast<double>(static_cast<int32_t>(static_cast<uint32_t>(word)))};
        }
        case Op::to_uint_:
            return {static_cast<double>(static_cast<uint32_t>(static_cast<int64_t>(a[0])))};
        default:
            r.fill(std::nan(""));
            return r;
    }
}

}  // namespace

Lanes apply_op(Op op, Type result, uint32_t extra, std::span<const Type> types,
               std::span<const Lanes> values) {
    const Rule rule = info(op).rule;
    if (rule == Rule::special && op != Op::sign_nonzero_) return as_whole(op, extra, types, values);
    if (rule == Rule::compare || rule == Rule::logic)
        return {on_scalars(op, values[0][0], values.size() > 1 ? values[1][0] : 0)};
    Lanes r{};
    for (size_t lane = 0; lane < info(result).lanes; ++lane) {
        std::array<double, 3> x{};
        for (size_t i = 0; i < values.size(); ++i)
            x[i] = values[i][info(types[i]).lanes > 1 ? lane : 0];
        const bool word = result == Type::int_ || result == Type::uint_;
        r[lane] =
            word ? on_words(op, x[0], x[1], result == Type::int_) : on_floats(op, x[0], x[1], x[2]);
    }
    return r;
}

}  // namespace wrinkle::test
