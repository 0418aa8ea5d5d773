#include "ir/module.h"

#include <algorithm>
#include <cmath>

#include "base/limits.h"
#include "ir/add.h"
#include "ir/module_cloner.h"

namespace wrinkle {
namespace {

bool is_variadic_list(Op op) {
    return op == Op::loop_ || op == Op::call_;
}

// Returns poison if the vector does not have a requested component.
Type swizzled_type(Type vector, uint32_t extra) {
    const int count = swizzle_count(extra);
    if (vector < Type::vec2_ || vector > Type::vec4_ || count < 1 || count > 4)
        return Type::poison_;
    for (int i = 0; i < count; ++i)
        if (swizzle_component(extra, i) >= info(vector).lanes) return Type::poison_;
    return vector_of(count);
}

// Returns the value as a literal of the type stores it: integers are clamped to 32 bits, a bool is
// 0 or 1.
double representable(Type scalar, double value) {
    if (scalar == Type::bool_) return value != 0;
    if (scalar != Type::int_ && scalar != Type::uint_) return value;
    const double low = scalar == Type::int_ ? -2147483648.0 : 0;
    const double high = scalar == Type::int_ ? 2147483647.0 : 4294967295.0;
    return std::isnan(value) ? 0 : std::trunc(std::clamp(value, low, high)) + 0.0;
}

// Returns true for ops that add() writes; leaves and ops of regions have functions of their own.
bool is_written(Op op, const OpInfo& row) {
    return row.rule != Rule::leaf && op != Op::loop_ && op != Op::call_ && op != Op::result_;
}

// Returns true if operands of one float type have a result of that type: most instructions.
bool takes_alike(const OpInfo& row) {
    return row.rule == Rule::broadcast || row.rule == Rule::floats;
}

bool may_fold(Op op, Type type) {
    return info(type).lanes > 0 && op != Op::construct_ && op != Op::swizzle_ && op != Op::select_;
}

std::string base_in_words(const Module& m, Id base) {
    if (base == no_id) return "the surface";
    const uint32_t node = m.origin[m[base].arg[0]];
    return "the normal of node '" + (node < m.nodes.size() ? m.nodes[node].path : "") + "'";
}

// Values of the surface point belong to no node: the one before them is named.
OverLimit too_many(const Module& m) {
    uint32_t node = m.current_node;
    for (Id id = m.size(); node == 0 && id > 0;)
        node = m.origin[--id];
    return {Limit::graph_values, m.most_values, node, m.nodes[node].path};
}

}  // namespace

Module::Module() : most_values(limit_of(Limit::graph_values)) {
    inst_.push_back({});
    origin.push_back(0);
    regions_.push_back({});
    free_levels_.push_back(0);
    call_depths_.push_back(0);
    lists_.push_back({});
    nodes.push_back({});
}

void Module::reserve(size_t expected) {
    table_.reserve(expected);
    inst_.reserve(expected);
    origin.reserve(expected);
    names_.resize(expected);
    named.reserve(expected / 8);  // most values have no name
}

Id Module::intern(const Inst& inst) {
    Id& slot = table_.find(inst, inst_);
    if (slot == no_id) slot = append(inst);
    return slot;
}

Id Module::append(const Inst& inst) {
    if (inst_.size() > most_values) throw too_many(*this);
    const Id added = size();
    inst_.push_back(inst);
    origin.push_back(current_node);
    has_[static_cast<size_t>(inst.op)] = true;
    return added;
}

uint32_t Module::intern_list(std::span<const Id> ids) {
    std::vector<Id> list(ids.begin(), ids.end());
    const auto [entry, added] = list_table_.try_emplace(list, static_cast<uint32_t>(lists_.size()));
    if (added) lists_.push_back(std::move(list));
    return entry->second;
}

std::span<const Id> Module::listed_operands(const Inst& inst) const {
    if (is_variadic_list(inst.op)) return lists_[inst.arg[0]];
    size_t count = inst.arg.size();
    while (count > 0 && inst.arg[count - 1] == no_id)
        --count;
    return std::span(inst.arg.data(), count);
}

// `op` and the number of operands may come from plugins, so both are checked.
Id Module::add(Op op, std::span<const Id> args, uint32_t extra, Type type) {
    if (op == Op::swizzle_ && args.size() == 1) return add_swizzle(args[0], extra);
    const OpInfo& row = info(op);
    Inst made{op, Type::poison_, 0, {}, extra, 0};
    if (!is_written(op, row) || args.size() > made.arg.size()) return not_written(op, args);
    std::array<Type, 4> types{};
    bool constant = !args.empty(), alike = true;
    for (size_t i = 0; i < args.size(); ++i) {
        if (args[i] == poison || args[i] >= size()) return not_written(op, args);
        const Inst& operand = inst_[args[i]];
        made.arg[i] = args[i];
        made.level = std::max(made.level, operand.level);
        types[i] = operand.type;
        constant = constant && is_constant(args[i]);
        alike = alike && types[i] == types[0];
    }
    if (alike && takes_alike(row) && is_float_type(types[0]) &&
        args.size() == static_cast<size_t>(row.arity))
        made.type = types[0];
    else
        made.type = typed(op, std::span(types.data(), args.size()), extra, type);
    if (made.type == Type::poison_) return poison;
    if (constant && may_fold(op, made.type))
        if (const Id folded = folded_constant(op, args, extra, made.type)) return folded;
    if (const Id simpler = simplified(*this, op, args, extra, made.type)) return simpler;
    if (made.type == Type::gradient_ && !set_base(op, args, made.extra)) return poison;
    return intern(made);
}

Id Module::add_swizzle(Id vector, uint32_t extra) {
    if (vector == poison || vector >= size()) return not_written(Op::swizzle_, {&vector, 1});
    const Type operand = inst_[vector].type, type = swizzled_type(operand, extra);
    if (type == Type::poison_) {
        refused(Op::swizzle_, {&operand, 1}, type);
        return poison;
    }
    const Op made_by = inst_[vector].op;
    const bool may_be_simpler =
        made_by == Op::construct_ || made_by == Op::swizzle_ || type == operand;
    if (may_be_simpler)
        if (const Id simpler = simplified(*this, Op::swizzle_, {&vector, 1}, extra, type))
            return simpler;
    return intern({Op::swizzle_, type, inst_[vector].level, {vector}, extra, 0});
}

// Reports why add() writes no instruction; reports nothing if an operand is poison. Returns poison.
Id Module::not_written(Op op, std::span<const Id> args) {
    const OpInfo& row = info(op);
    if (!is_written(op, row)) {
        problem(row.name.empty() ? "there is no op " + std::to_string(static_cast<int>(op))
                                 : "'" + std::string(row.name) + "' is not written as an op");
        return poison;
    }
    if (args.size() > Inst{}.arg.size()) {
        if (row.arity < 0)
            problem(std::string(row.name) + " takes at most 4 operands");
        else
            refused(op, std::vector<Type>(args.size()), Type::poison_);
        return poison;
    }
    for (const Id arg : args)
        if (arg >= size()) {
            problem(std::string(row.name) + " is given a value that does not exist");
            return poison;
        }
    return poison;
}

Type Module::typed(Op op, std::span<const Type> types, uint32_t extra, Type wanted) {
    const Type result = result_type(op, types, wanted, nullptr);
    if (result == Type::poison_) return refused(op, types, wanted);
    if (op == Op::column_ && extra > 2) {
        problem("a mat3 has no column " + std::to_string(extra));
        return Type::poison_;
    }
    if (reads_image(op) && extra >= resources.size()) {
        problem(std::string(info(op).name) + " is given an image that does not exist");
        return Type::poison_;
    }
    return result;
}

Type Module::refused(Op op, std::span<const Type> types, Type wanted) {
    std::string why;
    result_type(op, types, wanted, &why);
    problem(why);
    return Type::poison_;
}

Id Module::folded_constant(Op op, std::span<const Id> args, uint32_t extra, Type type) {
    std::array<Constant, 4> constants;
    for (size_t i = 0; i < args.size(); ++i)
        constants[i] = {this->type(args[i]), lanes_of(args[i])};
    Lanes lanes{};
    if (!fold(op, type, extra, std::span(constants.data(), args.size()), lanes)) return no_id;
    return constant(type, std::span(lanes.data(), info(type).lanes));
}

std::array<double, 9> Module::lanes_of(Id id) const {
    std::array<double, 9> lanes{};
    if (inst_[id].op == Op::literal_) {
        lanes[0] = inst_[id].value;
        return lanes;
    }
    size_t lane = 0;
    for (const Id part : operands(id)) {
        if (inst_[part].op == Op::literal_) {
            lanes[lane++] = inst_[part].value;
            continue;
        }
        for (const Id scalar : operands(part))
            lanes[lane++] = inst_[scalar].value;
    }
    return lanes;
}

// Sets `extra` to the base of the result; the terms of a sum must have the same. Returns false and
// records a problem on failure.
bool Module::set_base(Op op, std::span<const Id> args, uint32_t& extra) {
    if (is_gradient_source(op)) {
        if (extra == no_id || (extra < size() && type(extra) == Type::base_)) return true;
        problem(std::string(info(op).name) + " is given a base that is none");
        return false;
    }
    if (op == Op::gradient_zero_) return true;
    extra = inst_[args[0]].extra;
    if (op == Op::gradient_scale_) return true;
    const Id other = inst_[args[1]].extra;
    if (extra == other) return true;
    problem(std::string(op == Op::gradient_add_ ? "adds" : "mixes") +
                " gradients of different bases: one on " + base_in_words(*this, extra) +
                ", one on " + base_in_words(*this, other),
            "resolve them one after the other");
    return false;
}

Id Module::literal(Type scalar, double value) {
    return intern({Op::literal_, scalar, 0, {}, 0, representable(scalar, value)});
}

// Interned directly: a construct of literals has nothing to simplify.
Id Module::constant(Type type, std::span<const double> lanes) {
    if (lanes.size() == 1) return literal(type, lanes[0]);
    Inst construct{Op::construct_, type, 0, {}, 0, 0};
    const size_t count = type == Type::mat3_ ? 3 : lanes.size();
    for (size_t i = 0; i < count; ++i)
        construct.arg[i] =
            type == Type::mat3_ ? constant(Type::vec3_, lanes.subspan(i * 3, 3)) : number(lanes[i]);
    return intern(construct);
}

Id Module::zero(Type type) {
    constexpr std::array<double, 9> lanes{};
    return constant(type, std::span(lanes.data(), info(type).lanes));
}

Id Module::unit(Type type, size_t lane) {
    std::array<double, 4> lanes{};
    lanes[lane] = 1;
    return constant(type, std::span(lanes.data(), info(type).lanes));
}

Id Module::input(SurfaceInput which, Variant variant) {
    return intern({Op::input_, info(which).type, 0, {}, input_extra(which, variant), 0});
}

// Interned by index, not by the table: a node writes several, and never twice the same.
Id Module::parameter(uint32_t index) {
    if (index >= parameter_ids_.size()) parameter_ids_.resize(index + size_t{1});
    Id& id = parameter_ids_[index];
    if (id == no_id) id = append({Op::parameter_, parameters[index].type, 0, {}, index, 0});
    return id;
}

Id Module::region_parameter(int level, uint32_t index, Type type) {
    return intern({Op::region_param_, type, static_cast<uint8_t>(level), {}, index, 0});
}

Id Module::construct(Type type, std::initializer_list<Id> parts) {
    return add(Op::construct_, parts, 0, type);
}

Id Module::component(Id vector, uint32_t lane) {
    const Inst& inst = inst_[vector];
    if (inst.type == Type::float_) return vector;
    if (inst.op == Op::construct_ && lane < inst.arg.size() &&
        std::all_of(inst.arg.begin(), inst.arg.begin() + lane + 1,
                    [&](Id part) { return type(part) == Type::float_; }))
        return inst.arg[lane];
    return add(Op::swizzle_, {vector}, 1 | lane << 4);
}

Id Module::swizzle(Id vector, std::string_view components) {
    uint32_t extra = static_cast<uint32_t>(components.size());
    for (size_t i = 0; i < components.size(); ++i)
        extra |= static_cast<uint32_t>(std::string_view("xyzw").find(components[i])) << (4 + 4 * i);
    return add(Op::swizzle_, {vector}, extra);
}

bool Module::has_literal_parts(Id construct, double value) const {
    const auto parts = operands(construct);
    return inst_[construct].type != Type::mat3_ &&
           std::all_of(parts.begin(), parts.end(), [&](Id part) {
               return inst_[part].op == Op::literal_ && inst_[part].value == value;
           });
}

bool Module::has_constant_parts(Id construct) const {
    for (const Id part : operands(construct)) {
        if (inst_[part].op == Op::literal_) continue;
        if (inst_[construct].type != Type::mat3_ || inst_[part].op != Op::construct_) return false;
        for (const Id scalar : operands(part))
            if (inst_[scalar].op != Op::literal_) return false;
    }
    return true;
}

uint32_t Module::add_parameter(Parameter parameter) {
    parameters.push_back(std::move(parameter));
    return static_cast<uint32_t>(parameters.size() - 1);
}

uint32_t Module::add_resource(const Resource& resource) {
    const auto found = std::ranges::find_if(resources, [&](const Resource& known) {
        return known.file == resource.file && known.options == resource.options;
    });
    const auto index = static_cast<uint32_t>(found - resources.begin());
    if (found == resources.end())
        resources.push_back(resource);
    else
        found->readers.insert(found->readers.end(), resource.readers.begin(),
                              resource.readers.end());
    return index;
}

void Module::problem(std::string message, std::string expected) {
    problems.push_back({RuleId::node_build, current_node, std::move(message), std::move(expected)});
}

}  // namespace wrinkle
