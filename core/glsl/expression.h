// Expressions as text, with the fewest parentheses.
#pragma once

#include <string>
#include <vector>

#include "glsl/plan.h"
#include "glsl/scope.h"
#include "glsl/target.h"

namespace wrinkle {

// Names of what stands outside functions.
struct Symbols {
    std::vector<std::string> parameters;  // by index in Module::parameters; "" unused
    std::vector<std::string> resources;   // by index in Module::resources
    std::vector<std::string> functions;   // by region
};

// Literals with a type that shows: 1.0, 3, 3u, true; what has no spelling by its bits.
std::string literal_text(Type type, double value);

// How the text of an operation binds: 20 names, 18 calls, 17 postfix, ... as in the op table.
struct Piece {
    std::string text;
    int precedence = 20;
};

struct ExpressionContext {
    const Plan& plan;
    const Values& values;
    const Symbols& symbols;
    const Target& target;
    // Names of region parameters, by level and index.
    std::vector<std::vector<std::string>> parameters;
};

// The member of the function's struct that holds an input.
std::string member_name(SurfaceInput input, Variant variant);

Piece read(const ExpressionContext& context, Id id);    // a temporary's name, or its text
Piece define(const ExpressionContext& context, Id id);  // its text, even of a temporary

// Widths for folding decisions: of a leaf, and of an operation without its operands.
uint32_t leaf_width(const Plan& plan, Id leaf);
uint32_t own_width(const Plan& plan, Id id);

}  // namespace wrinkle
