// Writes the values of a module as nodes of a Blender node group: arithmetic of floats and vectors,
// comparisons, and reads of images anywhere in uv0. Derivatives, integers, loops, other properties
// of the surface and mirrored images are not among them. Where a quotient is by zero, or a root or
// logarithm of a negative number, Blender's nodes give 0.
//
// A node is a tuple of Python that texts/blender.py reads:
//
//     ("ShaderNodeMath", "ADD", "rust", [[0, 1], 0.5])
//
// its type, its operation or other setting, the name of the graph's node, and its inputs: numbers,
// vectors (0, 0, 1), and links [NODE, OUTPUT]. Node 0 is the input of the group.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

class BlenderNodes {
public:
    // `setting_of` returns the setting of an image's node.
    BlenderNodes(const Module& module, std::function<std::string(uint32_t resource)> setting_of);

    bool has(Id value) const { return supported_[value]; }

    // Returns the link to a value, or its numbers if it is constant; adds the nodes that it needs.
    // Precondition: has(value), and it has at most three components.
    std::string link(Id value);

    const std::string& rows() const { return rows_; }  // one node a line
    // Indices of the parameters that are used, in the order of the outputs of node 0.
    const std::vector<uint32_t>& inputs() const { return inputs_; }

private:
    // Links and numbers; missing ones are made of the others where they are needed.
    struct Value {
        int size = 1;
        std::string vector;
        std::array<std::string, 4> components{};
    };

    bool is_supported(Id id) const;
    int size_of(Id id) const { return info(module_.type(id)).lanes; }
    std::string add(const char* type, const std::string& setting,
                    const std::vector<std::string>& inputs);
    std::string component(Value& value, int index);
    std::string vector(Value& value);
    using Operands = std::vector<Value*>;
    Value apply(const char* math, const char* vector_math, const Operands& operands);
    Value apply(const char* operation, const Operands& operands);  // of the same name in both
    Value emit(Id id);
    Value emit_call(Id id);
    Value emit_mix(Value& none, Value& all, Value& part);
    Value emit_clamp(Id id);
    Value emit_comparison(Id id);
    Value emit_geometry(Id id);
    Value emit_smoothstep(Id id);
    Value emit_construct(Id id);
    Value emit_swizzle(Id id);
    Value emit_sample(Id id);
    Value emit_parameter(Id id);

    const Module& module_;
    std::function<std::string(uint32_t resource)> setting_of_;
    std::vector<bool> supported_;
    std::vector<Value> values_;  // by Id
    std::vector<bool> made_;
    std::vector<uint32_t> inputs_;
    std::string rows_;
    int count_ = 1;
    uint32_t origin_ = 0;  // of the node that is added
};

}  // namespace wrinkle
