// Helpers shared by tests of the expression language: initial numbers, and every application of an
// op that the type rules allow.
#pragma once

#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "ir/interpret.h"
#include "ir/module.h"

namespace wrinkle::test {

// One op on operands of these types.
struct Application {
    Op op;
    std::vector<Type> operands;
    uint32_t extra = 0;
    Type wanted = Type::poison_;
};
std::string text(const Application& application);

// Every application of an op of the table on numbers that type checks. Excludes leaves, opaque ops,
// textures and regions: those of tested_elsewhere().
std::vector<Application> applications();
bool tested_elsewhere(Op op);

// A parameter that serves as a leaf; tests set its value.
Id new_leaf(Module& module, Type type, std::string_view name = "x");
void set_leaf(Module& module, Id leaf, const Lanes& lanes);
Lanes get_leaf(const Module& module, Id leaf);

// Components in a range on which the op is defined.
class Numbers {
public:
    explicit Numbers(uint32_t seed) : random_(seed) {}
    double number(double low, double high) {
        return low + (high - low) * static_cast<double>(random_()) / 4294967295.0;
    }
    Lanes operand(const Application& application, size_t which);

private:
    std::mt19937 random_;
};

inline std::span<const double> lanes(const Lanes& values, Type type) {
    return std::span(values.data(), info(type).lanes);
}

}  // namespace wrinkle::test
