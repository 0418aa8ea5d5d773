#include "export/blender_nodes.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/text.h"

namespace wrinkle {
namespace {

// An op that is one node of Math for each component, or one of Vector Math for two or three.
struct Call {
    Op op;
    const char* math;         // null: components of the result depend on all of the operands'
    const char* vector_math;  // null: none
    const char* inputs;       // operands a and b, and numbers
};

const Call* call_of(Op op) {
    static constexpr Call calls[] = {
        {Op::add_, "ADD", "ADD", "a b"},
        {Op::sub_, "SUBTRACT", "SUBTRACT", "a b"},
        {Op::mul_, "MULTIPLY", "MULTIPLY", "a b"},
        {Op::div_, "DIVIDE", "DIVIDE", "a b"},
        {Op::mod_, "WRAP", "WRAP", "a b 0"},
        {Op::neg_, "MULTIPLY", "MULTIPLY", "a -1"},
        {Op::min_, "MINIMUM", "MINIMUM", "a b"},
        {Op::max_, "MAXIMUM", "MAXIMUM", "a b"},
        {Op::abs_, "ABSOLUTE", "ABSOLUTE", "a"},
        {Op::sign_, "SIGN", nullptr, "a"},
        {Op::floor_, "FLOOR", "FLOOR", "a"},
        {Op::ceil_, "CEIL", "CEIL", "a"},
        {Op::fract_, "FRACT", "FRACTION", "a"},
        {Op::sqrt_, "SQRT", nullptr, "a"},
        {Op::inversesqrt_, "INVERSE_SQRT", nullptr, "a"},
        {Op::pow_, "POWER", nullptr, "a b"},
        {Op::exp_, "EXPONENT", nullptr, "a"},
        {Op::exp2_, "POWER", nullptr, "2 a"},
        {Op::log_, "LOGARITHM", nullptr, "a 2.7182817"},
        {Op::log2_, "LOGARITHM", nullptr, "a 2"},
        {Op::sin_, "SINE", "SINE", "a"},
        {Op::cos_, "COSINE", "COSINE", "a"},
        {Op::tan_, "TANGENT", "TANGENT", "a"},
        {Op::asin_, "ARCSINE", nullptr, "a"},
        {Op::acos_, "ARCCOSINE", nullptr, "a"},
        {Op::atan_, "ARCTANGENT", nullptr, "a"},
        {Op::atan2_, "ARCTAN2", nullptr, "a b"},
        {Op::lt_, "LESS_THAN", nullptr, "a b"},
        {Op::gt_, "GREATER_THAN", nullptr, "a b"},
        {Op::eq_, "COMPARE", nullptr, "a b 0"},
        {Op::and_, "MULTIPLY", nullptr, "a b"},
        {Op::or_, "MAXIMUM", nullptr, "a b"},
        {Op::not_, "SUBTRACT", nullptr, "1 a"},
        {Op::dot_, nullptr, "DOT_PRODUCT", "a b"},
        {Op::cross_, nullptr, "CROSS_PRODUCT", "a b"},
        {Op::length_, nullptr, "LENGTH", "a"},
        {Op::normalize_, nullptr, "NORMALIZE", "a"},
    };
    const auto found = std::ranges::find(calls, op, &Call::op);
    return found == std::end(calls) ? nullptr : found;
}

bool is_geometry(Op op) {
    const Call* call = call_of(op);
    return call && !call->math;
}

bool is_number(const std::string& text) {
    return !text.starts_with('[');
}

std::string socket(int node, int output) {
    return "[" + std::to_string(node) + ", " + std::to_string(output) + "]";
}

}  // namespace

BlenderNodes::BlenderNodes(const Module& module, std::function<std::string(uint32_t)> setting_of)
    : module_(module),
      setting_of_(std::move(setting_of)),
      supported_(module.size()),
      values_(module.size()),
      made_(module.size()) {
    for (Id id = 1; id < module.size(); ++id)
        supported_[id] = is_supported(id);
}

bool BlenderNodes::is_supported(Id id) const {
    const Inst& inst = module_[id];
    const auto operands = module_.operands(id);
    const bool is_known =
        inst.level == 0 && (is_float_type(inst.type) || inst.type == Type::bool_) &&
        std::ranges::all_of(operands, [&](Id operand) { return supported_[operand]; });
    if (!is_known) return false;
    switch (inst.op) {
        case Op::parameter_:
            return size_of(id) <= 3;
        case Op::input_:
            return inst.extra == input_extra(SurfaceInput::uv0_, Variant::value);
        case Op::sample_:
            return module_.resources[inst.extra].options.wrap != Wrap::mirror;
        case Op::literal_:
            return std::isfinite(static_cast<float>(inst.value));
        case Op::construct_:
        case Op::swizzle_:
        case Op::clamp_:
        case Op::mix_:
        case Op::step_:
        case Op::smoothstep_:
        case Op::select_:
        case Op::to_float_:
        case Op::le_:
        case Op::ge_:
        case Op::ne_:
            return true;
        default:
            return call_of(inst.op) && (!is_geometry(inst.op) || size_of(operands[0]) <= 3);
    }
}

std::string BlenderNodes::add(const char* type, const std::string& setting,
                              const std::vector<std::string>& inputs) {
    rows_ += "    (\"" + std::string(type) + "\", " + setting + ", " +
             json_quoted(origin_ ? module_.nodes[origin_].path : "") + ", [" +
             joined(inputs, ", ") + "]),\n";
    return socket(count_++, 0);
}

std::string BlenderNodes::component(Value& value, int index) {
    const auto at = static_cast<size_t>(value.size == 1 ? 0 : index);
    if (value.components[at].empty()) {
        add("ShaderNodeSeparateXYZ", "None", {value.vector});
        for (int i = 0; i < 3; ++i)
            value.components[static_cast<size_t>(i)] = socket(count_ - 1, i);
    }
    return value.components[at];
}

// Blender's vectors have three components; a number that is linked to one is each of them.
std::string BlenderNodes::vector(Value& value) {
    if (!value.vector.empty()) return value.vector;
    std::vector<std::string> three(value.components.begin(), value.components.begin() + 3);
    if (value.size == 1) three[1] = three[2] = three[0];
    if (value.size == 2) three[2] = "0";
    if (std::ranges::all_of(three, is_number))
        value.vector = "(" + joined(three, ", ") + ")";
    else
        value.vector = value.size == 1 ? three[0] : add("ShaderNodeCombineXYZ", "None", three);
    return value.vector;
}

BlenderNodes::Value BlenderNodes::apply(const char* math, const char* vector_math,
                                        const Operands& operands) {
    Value made;
    for (const Value* operand : operands)
        made.size = std::max(made.size, operand->size);
    const bool is_vector = vector_math && (made.size == 2 || made.size == 3);
    const std::string setting = json_quoted(is_vector ? vector_math : math);
    std::vector<std::string> inputs(operands.size());
    const auto fill = [&](const std::function<std::string(Value&)>& of) {
        for (size_t i = 0; i < operands.size(); ++i)
            inputs[i] = of(*operands[i]);
    };
    if (is_vector) {
        fill([&](Value& value) { return vector(value); });
        made.vector = add("ShaderNodeVectorMath", setting, inputs);
        return made;
    }
    for (int i = 0; i < made.size; ++i) {
        fill([&](Value& value) { return component(value, i); });
        made.components[static_cast<size_t>(i)] = add("ShaderNodeMath", setting, inputs);
    }
    return made;
}

BlenderNodes::Value BlenderNodes::apply(const char* operation, const Operands& operands) {
    return apply(operation, operation, operands);
}

// Operands have smaller ids, so the order of ids is that of the nodes.
std::string BlenderNodes::link(Id value) {
    std::vector<bool> needed(value + size_t{1});
    needed[value] = true;
    for (Id id = value; id > 0; --id)
        if (needed[id] && !made_[id])
            for (const Id operand : module_.operands(id))
                needed[operand] = true;
    for (Id id = 1; id <= value; ++id) {
        if (!needed[id] || made_[id]) continue;
        origin_ = module_.origin[id];
        values_[id] = emit(id);
        values_[id].size = size_of(id);
        made_[id] = true;
    }
    return size_of(value) == 1 ? component(values_[value], 0) : vector(values_[value]);
}

BlenderNodes::Value BlenderNodes::emit(Id id) {
    const Inst& inst = module_[id];
    const auto operand = [&](size_t i) -> Value& { return values_[inst.arg[i]]; };
    switch (inst.op) {
        case Op::literal_:
            return {1, {}, {shortest(static_cast<float>(inst.value))}};
        case Op::parameter_:
            return emit_parameter(id);
        case Op::input_:
            return {2, add("ShaderNodeUVMap", "None", {}), {}};
        case Op::sample_:
            return emit_sample(id);
        case Op::construct_:
            return emit_construct(id);
        case Op::swizzle_:
            return emit_swizzle(id);
        case Op::clamp_:
            return emit_clamp(id);
        case Op::mix_:
            return emit_mix(operand(0), operand(1), operand(2));
        case Op::select_:
            return emit_mix(operand(2), operand(1), operand(0));
        case Op::smoothstep_:
            return emit_smoothstep(id);
        case Op::to_float_:
            return operand(0);
        case Op::step_:
        case Op::le_:
        case Op::ge_:
        case Op::ne_:
            return emit_comparison(id);
        default:
            return is_geometry(inst.op) ? emit_geometry(id) : emit_call(id);
    }
}

BlenderNodes::Value BlenderNodes::emit_call(Id id) {
    const Inst& inst = module_[id];
    const Call& call = *call_of(inst.op);
    std::vector<Value> numbers;
    numbers.reserve(3);
    Operands inputs;
    std::istringstream words(call.inputs);
    for (std::string word; words >> word;) {
        const bool is_operand = word == "a" || word == "b";
        if (!is_operand) numbers.push_back({1, {}, {word}});
        inputs.push_back(is_operand ? &values_[inst.arg[word == "a" ? 0 : 1]] : &numbers.back());
    }
    return apply(call.math, call.vector_math, inputs);
}

BlenderNodes::Value BlenderNodes::emit_mix(Value& none, Value& all, Value& part) {
    Value difference = apply("SUBTRACT", {&all, &none});
    return apply("MULTIPLY_ADD", {&difference, &part, &none});
}

BlenderNodes::Value BlenderNodes::emit_clamp(Id id) {
    const auto& operands = module_[id].arg;
    Value raised = apply("MAXIMUM", {&values_[operands[0]], &values_[operands[1]]});
    return apply("MINIMUM", {&raised, &values_[operands[2]]});
}

// One minus the opposite.
BlenderNodes::Value BlenderNodes::emit_comparison(Id id) {
    const Inst& inst = module_[id];
    Value one{1, {}, {"1"}}, zero{1, {}, {"0"}};
    Value &a = values_[inst.arg[0]], &b = values_[inst.arg[1]];
    Value opposite = inst.op == Op::ne_     ? apply("COMPARE", nullptr, {&a, &b, &zero})
                     : inst.op == Op::step_ ? apply("LESS_THAN", nullptr, {&b, &a})
                     : inst.op == Op::le_   ? apply("GREATER_THAN", nullptr, {&a, &b})
                                            : apply("LESS_THAN", nullptr, {&a, &b});
    return apply("SUBTRACT", {&one, &opposite});
}

// The third component of a vector of two may have any value, except here.
BlenderNodes::Value BlenderNodes::emit_geometry(Id id) {
    const Inst& inst = module_[id];
    std::vector<std::string> inputs;
    for (const Id operand : module_.operands(id)) {
        Value& value = values_[operand];
        if (value.size == 2) {
            component(value, 0);
            value.vector.clear();  // is made of the components, and 0
        }
        inputs.push_back(vector(value));
    }
    const std::string made =
        add("ShaderNodeVectorMath", json_quoted(call_of(inst.op)->vector_math), inputs);
    if (size_of(id) > 1) return {size_of(id), made, {}};
    return {1, {}, {socket(count_ - 1, 1)}};
}

BlenderNodes::Value BlenderNodes::emit_smoothstep(Id id) {
    const Inst& inst = module_[id];
    Value made{size_of(id), {}, {}};
    const auto input = [&](size_t operand, int i) {
        return component(values_[inst.arg[operand]], i);
    };
    for (int i = 0; i < made.size; ++i)
        made.components[static_cast<size_t>(i)] =
            add("ShaderNodeMapRange", "\"SMOOTHSTEP\"", {input(2, i), input(0, i), input(1, i)});
    return made;
}

BlenderNodes::Value BlenderNodes::emit_construct(Id id) {
    Value made{size_of(id), {}, {}};
    size_t count = 0;
    for (const Id operand : module_.operands(id))
        for (int i = 0; i < size_of(operand); ++i)
            made.components[count++] = component(values_[operand], i);
    return made;
}

BlenderNodes::Value BlenderNodes::emit_swizzle(Id id) {
    const Inst& inst = module_[id];
    Value& from = values_[inst.arg[0]];
    const int size = size_of(id);
    bool is_same = !from.vector.empty() && size == 3;
    for (int i = 0; i < size; ++i)
        is_same = is_same && swizzle_component(inst.extra, i) == i;
    if (is_same) return {size, from.vector, from.components};
    Value made{size, {}, {}};
    for (int i = 0; i < size; ++i)
        made.components[static_cast<size_t>(i)] = component(from, swizzle_component(inst.extra, i));
    return made;
}

// The vector has the colors; the fourth component is the other output of the node, the alpha.
BlenderNodes::Value BlenderNodes::emit_sample(Id id) {
    const Inst& inst = module_[id];
    const std::string colors =
        add("ShaderNodeTexImage", setting_of_(inst.extra), {vector(values_[inst.arg[0]])});
    return {4, colors, {"", "", "", socket(count_ - 1, 1)}};
}

BlenderNodes::Value BlenderNodes::emit_parameter(Id id) {
    const int output = static_cast<int>(inputs_.size());
    inputs_.push_back(module_[id].extra);
    if (size_of(id) == 1) return {1, {}, {socket(0, output)}};
    return {size_of(id), socket(0, output), {}};
}

}  // namespace wrinkle
