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
    Id plain(Id id) const { return alias_[id]; }  // without detach
    Role role(Id id) const { return role_[id]; }

    // Operands as text needs them, of what the outputs use. Of a loop: its initial state, then what
    // its body captures.
    std::span<const Id> operands(Id id) const {
        return std::span(operands_).subspan(first_operand_[id],
                                            first_operand_[id + 1] - first_operand_[id]);
    }
    size_t used_count() const { return used_; }  // of what the outputs use
    std::string_view literal(Id id) const;       // its text
    bool single_call(Id result) const;           // the member of a call that has one
    bool is_splat(Id construct) const;           // one scalar in every lane
    // The members of a loop's or call's tuple, by index; poison where nothing reads one.
    const std::vector<Id>& members(Id tuple) const { return members_.at(tuple); }
    const std::vector<Id>& captures(uint32_t region) const { return captures_[region]; }

    // What the outputs use, in the order of a walk from the outputs, operands first.
    std::vector<bool> inputs_used;      // by `extra` of the input: see input_slot
    std::vector<bool> parameters_used;  // by index in Module::parameters
    struct UsedResource {
        uint32_t resource;
        uint32_t node;  // of the first sample
    };
    std::vector<UsedResource> resources;
    std::vector<uint32_t> functions;   // regions, callees first
    std::vector<uint32_t> first_name;  // by Id: 1 + index in Module::named, 0 for none
    std::vector<bool>
        is_gradient;        // by Id: what a resolve subtracts from the normal, and its terms
    bool implicit = false;  // samples with an implicit lod, or changes of inputs

    static size_t input_slot(SurfaceInput input, Variant variant) {
        return static_cast<size_t>(input) * 3 + static_cast<size_t>(variant);
    }

private:
    Role role_of(Id id) const;
    void find_aliases();
    void find_members();
    void find_captures(uint32_t region);
    void gather_operands(Id id, std::vector<Id>& result) const;
    void list_operands_and_literals();
    void walk();
    void use(Id id);
    void find_gradients();

    const Module* module_;
    bool given_;
    enum class Met : uint8_t { never, open, used };  // in the walk from the outputs
    bool is_used(Id id) const { return met_[id] == Met::used; }
    std::vector<Met> met_;  // by Id
    size_t used_ = 0;
    std::vector<Id> alias_;
    std::vector<Role> role_;
    std::vector<std::vector<Id>> captures_;
    std::vector<Id> operands_;             // of all
    std::vector<uint32_t> first_operand_;  // by Id, and the end of the last
    std::string literals_;                 // the texts of all
    std::vector<uint32_t> literal_end_;    // by Id: in literals_
    std::unordered_map<Id, std::vector<Id>> members_;
    std::vector<bool> seen_function_, seen_resource_;
};

}  // namespace wrinkle
