// Emits expressions with the fewest parentheses.
#pragma once

#include <string>
#include <vector>

#include "emit/emit_analysis.h"
#include "emit/language.h"
#include "emit/scope.h"
#include "emit/target.h"

namespace wrinkle {

struct ExpressionContext {
    const EmitAnalysis& analysis;
    const Values& values;
    const Target& target;
    const Language& language;
    // Names of region parameters, by level and index.
    std::vector<std::vector<std::string>> parameters;
};

// The member of the function's struct that holds an input.
std::string member_name(SurfaceInput input, Variant variant);

// Appends a use of the value: the temporary's name, or the value's expression, in parentheses if
// its precedence is below `least` (20 names, 18 calls, 17 postfix, ... as in the op table).
void write(const ExpressionContext& context, Id id, std::string& text, int least = 0);
std::string text_of(const ExpressionContext& context, Id id, int least = 0);
// Appends the value's expression, also for a temporary.
void write_definition(const ExpressionContext& context, Id id, std::string& text);

// Widths in characters for folding decisions: of a leaf; of an operation without its operands.
uint32_t leaf_width(const EmitAnalysis& analysis, const Symbols& symbols, Id leaf);
uint32_t own_width(const EmitAnalysis& analysis, const Symbols& symbols, Id id);

}  // namespace wrinkle
