// Reference interpreter of expanded modules, in double: the oracle for constant folding,
// derivatives and other back ends. It follows the semantics documented at the op table and shares
// no code with the code under test. Slow, short, without built-in textures.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "ir/module.h"

namespace wrinkle::test {

using Lanes = std::array<double, 9>;

struct Surroundings {
    std::map<uint32_t, Lanes> inputs;  // by input_extra(); missing inputs are 0
    // rgba of a resource at (u, v) and a lod; `sample` passes lod 0.
    std::function<Lanes(uint32_t, double, double, double)> texture;
    std::function<Lanes(uint32_t)> image_size;
};

class Interpreter {
public:
    Interpreter(const Module& module, const Surroundings& around)
        : module_(&module), around_(&around) {}

    Lanes value(Id root);

private:
    struct Scope {
        std::unordered_map<Id, Lanes> values;
        std::unordered_map<Id, std::vector<Lanes>> tuples;
    };
    std::vector<Id> body(std::span<const Id> roots, int level) const;
    std::vector<Id> reads(Id id) const;
    void run(std::span<const Id> list, Scope& scope);
    Lanes compute(Id id, Scope& scope);
    Lanes sample(const Inst& inst, const Scope& scope) const;
    std::vector<Lanes> call(Id id, Scope& scope);
    std::vector<Lanes> loop(Id id, Scope& scope);

    const Module* module_;
    const Surroundings* around_;
};

inline Lanes interpret(const Module& module, Id root, const Surroundings& around = {}) {
    return Interpreter(module, around).value(root);
}

// Applies one op to numbers, per component or as a unit; types as in the module.
Lanes apply_op(Op op, Type result, uint32_t extra, std::span<const Type> types,
               std::span<const Lanes> values);

}  // namespace wrinkle::test
