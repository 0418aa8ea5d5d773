// What the printing of a module needs to know before any text exists: what the outputs use, and how
// each instruction counts as an operand.
//
//   leaf     written wherever it is read: literals, constants, parameters, surface inputs, region
//            parameters
//   view     a swizzle, a column, a member of a loop or of a call with several results: written
//            wherever it is read, as a part of something else
//   value    everything else: a temporary, or folded into its one reader
//
// `detach` means nothing to a shader: operands() looks through it, and through the tuple of a call
// with one result.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

enum class Role : uint8_t { leaf, view, value };

class Plan {
public:
    // `given`: changes of inputs are members of the struct, and so leaves.
    Plan(const Module& module, bool given);

    const Module& module() const { return *module_; }
    Id plain(Id id) const {  // without detach
        while ((*module_)[id].op == Op::detach_)
            id = (*module_)[id].arg[0];
        return id;
    }
    Role role(Id id) const { return values_[id].role; }  // of what the outputs use

    // Operands as text needs them, of what the outputs use. Of a loop: its initial state, then what
    // its body captures.
    std::span<const Id> operands(Id id) const {
        const Value& value = values_[id];
        return value.literal ? std::span<const Id>()
                             : std::span(operands_).subspan(value.begin, value.count);
    }
    size_t used_count() const { return used_; }  // of what the outputs use
    std::string_view literal(Id id) const {      // its text
        return std::string_view(literals_).substr(values_[id].begin, values_[id].count);
    }
    bool single_call(Id result) const;  // the member of a call that has one
    bool is_splat(Id construct) const;  // one scalar in every lane
    // The members of a loop's or call's tuple, by index; poison where nothing reads one.
    const std::vector<Id>& members(Id tuple) const { return members_.at(tuple); }
    // What the value is called in Module::named; none: null.
    const Named* name(Id id) const {
        const uint32_t name = values_[id].name;
        return name > 0 ? &module_->named[name - 1] : nullptr;
    }
    // True if the value comes from a texture: the surface point has none.
    bool reads_texture(Id id) const { return values_[id].reads; }
    // What a resolve subtracts from the normal, and its terms.
    bool is_gradient(Id id) const { return values_[id].gradient; }

    // What the outputs use, in the order of a walk from the outputs, operands first.
    std::array<bool, size_t{3} * surface_input_count> inputs_used{};  // see input_slot
    std::vector<bool> parameters_used;  // by index in Module::parameters
    struct UsedResource {
        uint32_t resource;
        uint32_t node;  // of the first sample
    };
    std::vector<UsedResource> resources;
    std::vector<uint32_t> functions;  // regions, callees first
    bool implicit = false;            // samples with an implicit lod, or changes of inputs

    static size_t input_slot(SurfaceInput input, Variant variant) {
        return static_cast<size_t>(input) * 3 + static_cast<size_t>(variant);
    }

private:
    enum class Met : uint8_t { never, open, used };  // in the walk from the outputs
    // What is asked of a value again and again, close together.
    struct Value {
        uint32_t begin = 0, count = 0;  // of its operands among all; of a literal its letters
        uint32_t name = 0;              // 1 + index in Module::named, 0 for none
        Role role = Role::leaf;
        Met met = Met::never;
        bool gradient = false;
        bool literal : 1 = false;
        bool reads : 1 = false;  // a texture, or a value that does
    };

    void find_names();
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
    bool given_;
    std::vector<Value> values_;  // by Id
    size_t used_ = 0;
    std::vector<Id> operands_;   // of all, as they are met
    std::string literals_;       // the texts of all
    std::vector<Id> gradients_;  // that resolves subtract
    std::unordered_map<Id, std::vector<Id>> members_;
    std::vector<bool> seen_function_, seen_resource_;
};

}  // namespace wrinkle
