#include "ir/support.h"

#include <algorithm>
#include <cmath>

#include "ir/add.h"

namespace wrinkle::test {
namespace {

constexpr Type numbers[] = {Type::float_, Type::vec2_, Type::vec3_, Type::vec4_,
                            Type::mat3_,  Type::int_,  Type::uint_, Type::bool_};

uint32_t swizzle(std::initializer_list<uint32_t> components) {
    auto extra = static_cast<uint32_t>(components.size());
    uint32_t shift = 4;
    for (const uint32_t component : components) {
        extra |= component << shift;
        shift += 4;
    }
    return extra;
}

// (extra, requested type) of the ops that need them.
std::vector<std::pair<uint32_t, Type>> variants(Op op) {
    if (op == Op::column_) return {{0, {}}, {1, {}}, {2, {}}};
    if (op == Op::swizzle_)
        return {{swizzle({0}), Type::float_},
                {swizzle({1, 0}), Type::vec2_},
                {swizzle({1, 1, 0}), Type::vec3_}};
    if (op != Op::construct_) return {{0, {}}};
    return {{0, Type::vec2_}, {0, Type::vec3_}, {0, Type::vec4_}, {0, Type::mat3_}};
}

void add_fitting(std::vector<Application>& list, Op op, const std::vector<Type>& operands) {
    const bool vector = operands[0] >= Type::vec2_ && operands[0] <= Type::vec4_;
    if (op == Op::swizzle_ && !vector) return;
    std::string why;
    for (const auto& [extra, wanted] : variants(op))
        if (result_type(op, operands, wanted, &why) != Type::poison_)
            list.push_back({op, operands, extra, wanted});
}

void add_all(std::vector<Application>& list, Op op, size_t count) {
    std::vector<size_t> digits(count, 0);
    for (;;) {
        std::vector<Type> operands;
        for (const size_t digit : digits)
            operands.push_back(numbers[digit]);
        add_fitting(list, op, operands);
        size_t place = 0;
        while (place < count && ++digits[place] == std::size(numbers))
            digits[place++] = 0;
        if (place == count) return;
    }
}

bool needs_unit_range(Op op) {
    constexpr Op list[] = {Op::sqrt_, Op::inversesqrt_, Op::pow_,  Op::log_,
                           Op::log2_, Op::asin_,        Op::acos_, Op::smoothstep_};
    return std::find(std::begin(list), std::end(list), op) != std::end(list);
}

}  // namespace

std::string text(const Application& a) {
    std::string text = std::string(info(a.op).name) + "(";
    for (const Type type : a.operands)
        text += std::string(info(type).name) + " ";
    return text + ") extra " + std::to_string(a.extra);
}

bool tested_elsewhere(Op op) {
    constexpr Op list[] = {Op::sample_, Op::sample_lod_, Op::sample_grad_, Op::image_size_,
                           Op::loop_,   Op::call_,       Op::result_};
    return info(op).rule == Rule::leaf || is_opaque(op) ||
           std::find(std::begin(list), std::end(list), op) != std::end(list);
}

std::vector<Application> applications() {
    std::vector<Application> list;
#define X(name, number, arity, rule, glsl, precedence, flags)                           \
    if (!tested_elsewhere(Op::name##_)) {                                               \
        for (size_t n = arity < 0 ? 1 : arity; n <= size_t(arity < 0 ? 4 : arity); ++n) \
            add_all(list, Op::name##_, n);                                              \
    }
    WR_OPS(X)
#undef X
    return list;
}

Id new_leaf(Module& module, Type type, std::string_view name) {
    if (type != Type::mat3_)
        return module.parameter(module.add_parameter({0, std::string(name), type, {}, false}));
    const Id x = new_leaf(module, Type::vec3_), y = new_leaf(module, Type::vec3_),
             z = new_leaf(module, Type::vec3_);
    return module.construct(Type::mat3_, {x, y, z});
}

void set_leaf(Module& module, Id leaf, const Lanes& lanes) {
    if (module.type(leaf) == Type::mat3_) {
        for (size_t k = 0; k < 3; ++k)
            set_leaf(module, module.operands(leaf)[k],
                     {lanes[k * 3], lanes[k * 3 + 1], lanes[k * 3 + 2]});
        return;
    }
    std::copy_n(lanes.begin(), 4, module.parameters[module[leaf].extra].value.begin());
}

Lanes get_leaf(const Module& module, Id leaf) {
    return interpret(module, leaf);
}

Lanes Numbers::operand(const Application& a, size_t which) {
    const Type type = a.operands[which];
    const bool shift = a.op == Op::shift_left_ || a.op == Op::shift_right_;
    Lanes lanes{};
    for (size_t i = 0; i < info(type).lanes; ++i) {
        double& lane = lanes[i];
        if (type == Type::bool_)
            lane = number(0, 1) < 0.5;
        else if (shift && which == 1)
            lane = std::floor(number(0, 32));
        else if (type == Type::int_)
            lane = std::floor(number(-2147483648.0, 2147483647.0));
        else if (type == Type::uint_)
            lane = std::floor(number(0, 4294967295.0));
        else if (a.op == Op::mod_ && which == 1)
            lane = number(0.5, 2);
        else if (a.op == Op::smoothstep_)
            lane = which == 0 ? number(0, 0.3) : which == 1 ? number(0.7, 1) : number(-0.2, 1.2);
        else
            lane = needs_unit_range(a.op) ? number(0.05, 0.95) : number(-2, 2);
    }
    return lanes;
}

}  // namespace wrinkle::test
