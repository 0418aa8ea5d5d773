// A test host that computes immediately, with the C library's meaning of every op: results that are
// undefined in the language are NaN or infinity here, which exposes missing guards.
#pragma once

#include <array>
#include <vector>

#include "wrinkle/plugin.h"

namespace wrinkle::testing {

class Calculator {
public:
    struct Number {
        std::array<double, 4> lane{};
        uint32_t lanes = 1;
        uint32_t type = WR_TYPE_float;
    };
    Calculator();
    wr_builder face{};
    const Number& operator[](wr_value id) const { return values_.at(id); }

private:
    static Calculator& self(const wr_builder* b) { return *static_cast<Calculator*>(b->host); }
    wr_value add(Number number);
    wr_value emit(uint32_t op, const wr_value* args, uint32_t count, uint32_t extra);

    std::vector<Number> values_{1};
};

}  // namespace wrinkle::testing
