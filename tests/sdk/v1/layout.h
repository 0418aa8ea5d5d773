// What one version of the contract fixes, as data: of the frozen header and of the present one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace wrinkle::testing {

struct Member {
    std::string of;    // "wr_port"
    std::string name;  // "default_value"
    std::string type;  // as the compiler mangles it
    size_t offset, size, alignment;
};

struct Constant {
    std::string name;
    uint64_t value;
};

struct Layout {
    std::vector<Member> members;      // of each struct in its order
    std::vector<Constant> sizes;      // of the structs
    std::vector<std::string> rows;    // of the tables, "WR_OPS: add, 21, 2, broadcast, ..."
    std::vector<Constant> constants;  // WR_ABI, WR_KIND_INPUT, ...
};

Layout frozen_layout();
Layout present_layout();

}  // namespace wrinkle::testing
