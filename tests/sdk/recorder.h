// A test host: every value is its own expression as text, "add(input:0, 2)". Expressions are
// compared independently of the order in which the compiler evaluates operands.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "wrinkle/plugin.h"

namespace wrinkle::testing {

class Recorder {
public:
    Recorder();
    wr_builder face{};

    std::map<uint32_t, int32_t> options;  // by port
    std::map<uint32_t, std::string> outputs;
    std::vector<std::string> errors;
    int open_regions = 0;

    void run(const wr_node* node) { node->build(&face); }

private:
    struct Region {
        std::string text;
        uint32_t kind;
    };
    static Recorder& self(const wr_builder* b) { return *static_cast<Recorder*>(b->host); }
    void give_ports();
    void give_ops();
    void give_regions();
    wr_value value(std::string text);
    std::string list(const wr_value* values, uint32_t count) const;

    std::vector<std::string> values_{"poison"};
    std::vector<Region> regions_{{"", 0}};
    std::vector<Region> recording_;
};

}  // namespace wrinkle::testing
