// The ABI of one version of plugin.h as data; the frozen and the current header are compared.
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
    std::vector<Member> members;      // members of the structs, in order
    std::vector<Constant> sizes;      // sizes of the structs
    std::vector<std::string> rows;    // rows of the tables, "WR_OPS: add, 21, 2, broadcast, ..."
    std::vector<Constant> constants;  // WR_ABI, WR_KIND_INPUT, ...
};

Layout frozen_layout();
Layout present_layout();

}  // namespace wrinkle::testing
