// Closing the functions that lowering left open (ir/open_input.h). Part of expand(), which
// meets a function's body before the first call of it: what the body gives has become ordinary
// arithmetic over the function's inputs and their derivatives.
//
// Closing makes a Region of kind function of it. Its parameters are
//   1. the inputs that it reads,
//   2. derivatives of inputs that it reads, along what each OpenInput says (a bump inside of a
//      height from outside needs the height's change to the next pixel),
//   3. what it computes without reading an input: the surface point and what follows from it alone.
//      That stands outside, is computed once, and is passed.
// A caller differentiates its own arguments for 2. A result that is differentiated outside is so by
// a derived function (ir/derive.h). Constant stack; linear in the bodies.
#pragma once

#include <unordered_map>
#include <vector>

#include "ir/copy.h"
#include "ir/gradient_frame.h"

namespace wrinkle {

// Whether a vec3 that crosses a function's border is a gradient: tangent to the surface as it is.
// The target has the side tables.
bool is_tangent(const Module& source, const Module& target, Id vector);

class OpenFunctions {
public:
    OpenFunctions(Module& target, ScreenDerivatives& screen, const Module& source);

    // A call of an open function: of the function closed; poison of any other call. `mapped` are
    // the arguments and then what the function gives.
    Id call(const Module& source, Id id, std::span<const Id> mapped);
    Id result(const Module& source, Id id, Id tuple);
    // Whether the value depends on an input of a function that is open.
    bool in_function(Id id);
    // Names of what was moved into functions. After that no function is open any more.
    // `result` is the target as it was given back.
    void finish(Module& result) const;

private:
    struct Closed {
        bool done = false;
        uint32_t region = 0;           // 0: it computes nothing
        std::vector<Id> params;        // in the target: inputs, derivatives, what is captured
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
