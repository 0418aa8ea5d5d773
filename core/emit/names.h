// Identifiers for generated code: legal in every target, unique, deterministic.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

// Name hint of a value: two words joined by an underscore, or only the second.
struct NameHint {
    std::string_view first, second;
    size_t size() const { return first.size() + !first.empty() + second.size(); }
};

// Names of global declarations.
struct Symbols {
    std::vector<std::string> parameters;  // by index in Module::parameters; "" unused
    std::vector<std::string> resources;   // by index in Module::resources
    std::vector<std::string> functions;   // by region
    std::string prefix;                   // begins the name of each function
    std::unordered_map<Id, std::string> constants;
    // By region, for languages without global images: the parameters for the images and the uniform
    // block that a function uses, and the arguments of its calls.
    std::vector<std::string> resource_parameters, resource_arguments;
    std::string material_parameters, material_arguments;  // the material's function
};

// Names of one scope. Names of `outer` are taken here too; `outer` must outlive this set.
class NameSet {
public:
    explicit NameSet(const NameSet* outer) : outer_(outer) {}

    // Returns the hint as a legal identifier, with "_2", "_3", ... appended if it is taken. The
    // view is valid as long as the set.
    std::string_view add(const NameHint& wanted);
    void reserve(size_t names) { next_.reserve(names); }
    std::string unique(std::string_view wanted) { return std::string(add({{}, wanted})); }

private:
    bool is_taken_outside(const std::string& name) const;

    const NameSet* outer_;
    std::unordered_map<std::string, uint32_t> next_;  // by name: the next number to append
};

// Returns the name of a surface input's differential: "dpdx", "duv0_dy"; for the input's value, the
// input's name.
std::string_view change_name(uint32_t input_extra);

// Returns one word that describes a value, for temporaries that are not a node's output: "texel",
// "sum", ...
std::string_view word_for(const Module& module, Id id);

// Sanitises text for a line comment: one line of at most 160 bytes without backslashes and control
// characters, including Unicode line separators and direction marks.
std::string comment_text(std::string_view text);
void append_comment_text(std::string& line, std::string_view text);

}  // namespace wrinkle
