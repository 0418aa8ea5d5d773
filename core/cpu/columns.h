// A program's outputs at points by their names, and how its inputs are called.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cpu/evaluate.h"

namespace wrinkle {

// "uv0", "dx.uv0": an input of the surface, or its change to the next pixel.
std::string name_of(const InputNeed& need);
std::optional<InputNeed> find_input(std::string_view name);
std::vector<std::string> surface_input_names();  // without changes
inline size_t lanes_of(const InputNeed& need) {
    return info(info(need.input).type).lanes;
}

enum class Precision : uint8_t { single, full };

struct OutputColumn {
    std::string name;
    uint32_t port_type = 0;  // WR_PORT_*
    size_t lanes = 1;
    std::vector<double> values;  // [point * lanes + lane]; of single precision exact floats
};

// Every output at every point. Every needed input is given, of single precision within it.
std::vector<OutputColumn> evaluate_columns(const Program& program, const PointSet& points,
                                           std::span<const Texture> textures, Precision precision);

// A needed number beyond float: in single precision it is infinite, which no surface has.
struct BeyondFloat {
    size_t point = 0;
    InputNeed input;
    double value = 0;

    std::string message() const;  // "'uv0' holds 1e+40, which single precision does not"
};
std::vector<BeyondFloat> beyond_float(const Program& program, const PointSet& points);

}  // namespace wrinkle
