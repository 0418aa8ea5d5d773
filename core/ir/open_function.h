// Closes the functions that lowering left open (ir/open_input.h). Part of expand(), which visits a
// function's body before its first call: the results of the body are then ordinary arithmetic over
// the function's inputs and their derivatives. A function stays open until then because expand()
// decides which derivatives a bump reads, so lowering does not know its parameters.
//
// Closing (lambda lifting) creates a Region of kind function. Its parameters are
//   1. the inputs that it reads,
//   2. derivatives of inputs that it reads, along the axes in OpenInput (a bump inside the function
//      from a height outside needs the height's derivative to the next pixel),
//   3. captured values, computed without reading an input: the surface point and values that depend
//      only on it. They are computed once outside the function, and passed.
// A caller differentiates its own arguments for 2. A result that is differentiated outside is
// differentiated by a derived function (ir/derive.h). Constant stack; linear in the bodies.
//
// A sub-graph with the bump of its squared input, called with uv0.x, as print() writes it open:
//
//   %8 float = region_param 0.0                       input 0 of the open functions
//   %9 float = mul %8 %8
//   %11 gradient = gradient_from_height %9
//   %12 vec3 = gradient_vector %11
//   @1 function half (float) -> %12
//   %13 tuple = call @1 %2
//
// and closed, with h' the input's change to the next pixel in x and in y:
//
//   %19 float = region_param 1.0                      1: h
//   %20 float = region_param 1.1                      2: h' in x
//   %21 float = region_param 1.2                      2: h' in y
//   %22 vec3 = region_param 1.3                       3: the normal
//   ...                                               3: position' in y and x, 2 / area
//   %28 vec2 = construct %20 %21
//   %29 vec2 = mul %28 %19                            half of the square's change
//   ...
//   @1 function half (float, float, float, vec3, vec3, float, vec3) -> %36
//   %39 tuple = call @1 %2 %37 %38 %6 %7 %18 %10
#pragma once

#include <unordered_map>
#include <vector>

#include "ir/gradient_frame.h"
#include "ir/module_cloner.h"

namespace wrinkle {

// Returns true if a vec3 that crosses a function's boundary is a gradient, so already tangent to
// the surface. `target` holds the side tables.
bool is_tangent(const Module& source, const Module& target, Id vector);

class OpenFunctions {
public:
    OpenFunctions(Module& target, ScreenDerivatives& screen, const Module& source);

    // For a call of an open function, returns a call of the closed function; no_id for any other
    // call. `mapped` holds the arguments, followed by the function's results.
    Id call(const Module& source, Id id, std::span<const Id> mapped);
    Id result(const Module& source, Id id, Id tuple);
    // Returns true if the value depends on an input of an open function.
    bool in_function(Id id);
    // Updates the names of values that were moved into functions; no function is open afterwards.
    // `result` is the target as the rebuild returned it.
    void finish(Module& result) const;

private:
    struct Closed {
        bool done = false;
        uint32_t region = 0;           // 0: no result to compute
        std::vector<Id> params;        // in the target: inputs, derivatives, captured values
        std::vector<uint32_t> member;  // by result in the source
        std::vector<bool> used;        // by result in the source
    };
    static constexpr uint32_t unused = ~0U;

    void close(const Region& open, std::span<const Id> results, Closed& closed);
    std::vector<Id> body(std::span<const Id> results, Closed& closed);
    std::string name_of(Id param) const;
    Id argument(Id param, uint32_t first_input, std::span<const Id> arguments);

    Module* target_;
    ScreenDerivatives* screen_;
    std::vector<Closed> closed_;   // by region of the source
    std::vector<bool> dependent_;  // by Id of the target
    std::unordered_map<Id, Id> moved_;
};

}  // namespace wrinkle
