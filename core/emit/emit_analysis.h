// Use analysis before emission: the values that the outputs use, and the role of each instruction
// as an operand.
//
//   leaf     inlined at every use: literals, constants, parameters, surface inputs, region
//            parameters
//   view     a swizzle, a column, a member of a loop or of a call with several results: inlined at
//            every use, as a part of another value
//   value    everything else: a temporary, or folded into its only user
//
// A shader has no `detach`: operands() returns the detached values instead. The result of a call
// with one result has the call's arguments as operands.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "emit/language.h"
#include "ir/module.h"

namespace wrinkle {

enum class Role : uint8_t { leaf, view, value };

class EmitAnalysis {
public:
    // `given`: the caller of the shader supplies the differentials of inputs as members of the
    // surface struct, so they are leaves; otherwise they are computed by dFdx and dFdy.
    // `language` spells the literals.
    EmitAnalysis(const Module& module, const Language& language, bool given);

    const Module& module() const { return *module_; }
    Id strip_detach(Id id) const {
        while ((*module_)[id].op == Op::detach_)
            id = (*module_)[id].arg[0];
        return id;
    }
    std::vector<Id> strip_detach(std::vector<Id> ids) const {
        for (Id& id : ids)
            id = strip_detach(id);
        return ids;
    }
    // Precondition of role(), operands() and literal(): the outputs use the value.
    Role role(Id id) const { return values_[id].role; }

    // Operands as the emitter writes them. A loop's are its initial state, then the values that its
    // body captures.
    std::span<const Id> operands(Id id) const {
        const Value& value = values_[id];
        return value.literal ? std::span<const Id>()
                             : std::span(operands_).subspan(value.begin, value.count);
    }
    size_t used_count() const { return used_; }  // number of values that the outputs use
    std::string_view literal(Id id) const {      // spelling of a literal
        return std::string_view(literals_).substr(values_[id].begin, values_[id].count);
    }
    bool single_call(Id result) const;  // true if it is the result of a call with one result
    bool is_splat(Id construct) const;  // true if all components are the same scalar
    // Members of a loop's or call's tuple, by index; no_id if the member is not read.
    const std::vector<Id>& members(Id tuple) const { return members_.at(tuple); }
    // Returns the value's entry in Module::named; null if it has none.
    const Named* name(Id id) const {
        const uint32_t name = values_[id].name;
        return name > 0 ? &module_->named[name - 1] : nullptr;
    }
    // True for a leaf that is written as a named constant.
    bool is_named_constant(Id id) const { return values_[id].constant; }
    // True if the value depends on a texture read. Such a value is not in surface_group
    // (emit/scope.h).
    bool reads_texture(Id id) const { return values_[id].reads; }
    // True for a gradient that a resolve subtracts from the normal, and for the terms of its sum.
    bool is_gradient(Id id) const { return values_[id].gradient; }

    // Inputs, parameters, resources, constants and functions that the outputs use. The last three
    // are in post-order from the outputs.
    std::array<bool, size_t{3} * surface_input_count> inputs_used{};  // by input_slot()
    std::vector<bool> parameters_used;  // by index in Module::parameters
    struct UsedResource {
        uint32_t resource;
        uint32_t node;  // node of the first sample
    };
    std::vector<UsedResource> resources;
    std::vector<Id> constants;        // that have a name
    std::vector<uint32_t> functions;  // regions, callees first
    bool reads_sizes = false;         // image_size is used
    bool implicit = false;            // derivatives: implicit-lod samples, differentials of inputs

    static size_t input_slot(SurfaceInput input, Variant variant) {
        return static_cast<size_t>(input) * 3 + static_cast<size_t>(variant);
    }

private:
    enum class VisitState : uint8_t {
        never,
        open,
        used
    };  // in the depth-first walk from the outputs
    // The facts of one value that are queried often, packed together.
    struct Value {
        uint32_t begin = 0, count = 0;  // range in operands_; for a literal, in literals_
        uint32_t name = 0;              // 1 + index in Module::named, 0 for none
        Role role = Role::leaf;
        VisitState met = VisitState::never;
        bool gradient = false;
        bool literal : 1 = false;
        bool reads : 1 = false;     // reads a texture, directly or through an operand
        bool constant : 1 = false;  // a leaf with the name of a constant
    };

    void find_names();
    void use_constant(Id id);
    void find_members();
    void walk();
    void use(Id id);
    void list_operands(Id id);
    void list_captures(const Region& loop);
    bool finds_reads(const Inst& inst, std::span<const Id> operands) const;
    void use_input(uint32_t extra);
    void use_resource(Id sample);
    void use_function(uint32_t region);
    void use_normalize(const Inst& inst);
    Role role_of(Id id) const;
    void find_gradients();

    const Module* module_;
    const Language* language_;
    bool given_;
    std::vector<Value> values_;  // by Id
    size_t used_ = 0;
    std::vector<Id> operands_;   // operands of all used values, in visit order
    std::string literals_;       // spellings of all literals
    std::vector<Id> gradients_;  // worklist: gradients that resolves subtract
    std::unordered_map<Id, std::vector<Id>> members_;
    std::vector<bool> seen_function_, seen_resource_;
};

}  // namespace wrinkle
