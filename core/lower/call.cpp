#include "lower/call.h"

#include "base/text.h"
#include "ir/surface.h"

namespace wrinkle {
namespace {

bool is_surface(Lowering& caller, Id id) {
    Module& m = caller.module();
    if (m[id].op == Op::input_) return variant_of(m[id].extra) == Variant::value;
    return id == caller.surface(WR_SURFACE_normal) || id == unit_normal(m);
}

std::string key_of(const BoundImage& image) {
    const ImageLiteral& literal = image.literal;
    const int encoding = literal.encoding ? static_cast<int>(*literal.encoding) : -1;
    return "image " + json_quoted(literal.file) + " " + std::to_string(image.file) + " " +
           std::to_string(encoding) + " " + std::to_string(static_cast<int>(literal.wrap)) + " " +
           std::to_string(static_cast<int>(literal.filter));
}

// Binds one input unchanged; returns false if it must become a leaf.
bool bind_as_it_is(Lowering& caller, uint32_t node, uint32_t port, BoundInput& bound,
                   std::string& key) {
    const Module& m = caller.module();
    const Id id = caller.input(node, port);
    bound.value = id;
    if (caller.graph().nodes[node].type->ports[port].type == PortType::image_) {
        bound.image = caller.bound_image(id);
        key += bound.image ? key_of(*bound.image) : "no image";
    } else if (id == poison) {
        key += "nothing";
    } else if (m[id].op == Op::gradient_zero_) {
        key += "flat";
    } else if (is_surface(caller, id)) {
        key += "%" + std::to_string(id);
    } else {
        return false;
    }
    return true;
}

OpenInput leaf_for(const Module& m, const Port& port, Id argument, const ValueAnalysis& facts) {
    OpenInput leaf;
    leaf.type = m.type(argument);
    leaf.name = port.name;
    leaf.dependencies = facts.dependencies(argument);
    leaf.discontinuous = facts.is_discontinuous(argument);
    leaf.samples_texture = facts.samples_texture(argument);
    leaf.tangent = port.type == PortType::gradient_;
    return leaf;
}

}  // namespace

CallInputs call_inputs(Lowering& caller, uint32_t node, const std::vector<bool>& needed,
                       ValueAnalysis& facts) {
    Module& m = caller.module();
    CallInputs inputs;
    inputs.bound.resize(needed.size());
    for (uint32_t p = 0; p < needed.size(); ++p) {
        inputs.key += p > 0 ? ", " : "";
        if (!needed[p] || bind_as_it_is(caller, node, p, inputs.bound[p], inputs.key)) continue;
        const Port& port = caller.graph().nodes[node].type->ports[p];
        Id argument = inputs.bound[p].value;
        if (port.type == PortType::gradient_) argument = m.add(Op::gradient_vector_, {argument});
        facts.update();
        const OpenInput leaf = leaf_for(m, port, argument, facts);
        inputs.key += std::to_string(leaf.dependencies) + (leaf.discontinuous ? " jumps" : "") +
                      (leaf.samples_texture ? " reads" : "");
        inputs.arguments.push_back(argument);
        inputs.leaf_of.push_back(p);
        inputs.leaves.push_back(leaf);
    }
    return inputs;
}

uint32_t add_leaves(Module& module, CallInputs& inputs) {
    const auto first = static_cast<uint32_t>(module.open_inputs.size());
    for (size_t i = 0; i < inputs.leaves.size(); ++i)
        inputs.bound[inputs.leaf_of[i]].value = module.add_open_input(inputs.leaves[i]);
    for (size_t i = 0; i < inputs.leaves.size(); ++i) {
        Id& value = inputs.bound[inputs.leaf_of[i]].value;
        if (inputs.leaves[i].tangent)
            value = module.add(Op::gradient_from_volume_, {value}, poison);
    }
    return first;
}

}  // namespace wrinkle
