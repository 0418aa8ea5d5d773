// Reads of fields for a node's build(). Internal to core/lower.
//
// A field is a value made from a surface input, its domain, and read with another value of that
// input. A read of a small field copies its expression. A large field becomes a function of the
// input and of its screen derivatives, so that chains of nodes that read fields grow with their
// length.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "ir/derive.h"
#include "ir/module.h"

namespace wrinkle {

class FieldReads {
public:
    explicit FieldReads(Module& module) : module_(&module) {}

    // Returns `value` with the surface input `domain` replaced by `at`. `name` is that of the
    // function, if it becomes one: then its implicit samples become sample_grads, and if `at`
    // belongs to a loop or a function, their footprint is that of the surface point.
    Id read(Id value, SurfaceInput domain, Id at, const std::string& name);

private:
    struct Function {
        bool copied = false;     // each read copies the expression
        bool footprint = false;  // the function has the screen derivatives of `at` as parameters
        RegionUse use;
    };
    struct Directions {
        ForwardDiff x, y;
    };
    Function make_function(Id value, Id input, const std::string& name);
    static Id with_footprint(void* directions, Module& target, const Module& source, Id id,
                             std::span<const Id> mapped);

    Module* module_;
    std::map<std::pair<Id, SurfaceInput>, Function> functions_;
    std::optional<Directions> directions_;
};

}  // namespace wrinkle
