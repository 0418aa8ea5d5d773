// One instruction; ir/module.h defines its semantics.
#pragma once

#include <array>
#include <cstdint>

#include "ir/op.h"
#include "ir/side_tables.h"

namespace wrinkle {

struct Inst {
    Op op = Op::poison_;
    Type type = Type::poison_;
    uint8_t level = 0;
    std::array<Id, 4> arg{};  // unused ones are 0; loop and call: arg[0] is an index into lists
    uint32_t extra = 0;       // see the comments of the op table
    double value = 0;         // literals only
    bool operator==(const Inst&) const = default;
};

}  // namespace wrinkle
