// Names of a program's inputs, and its outputs at points as named columns.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cpu/evaluate.h"

namespace wrinkle {

// Returns the name of a surface input ("uv0") or of its differential per pixel ("dx.uv0").
std::string name_of(const InputNeed& need);
std::optional<InputNeed> find_input(std::string_view name);
std::vector<std::string> surface_input_names();  // without differentials
size_t lanes_of(const InputNeed& need);

enum class Precision : uint8_t { single, full };

struct OutputColumn {
    std::string name;
    uint32_t port_type = 0;  // WR_PORT_*
    size_t lanes = 1;
    std::vector<double> values;  // [point * lanes + lane]; exact floats in single precision
};

// Evaluates all outputs at all points. Precondition: every needed input is set and, for single
// precision, finite as a float.
std::vector<OutputColumn> evaluate_columns(const Program& program, const PointSet& points,
                                           std::span<const Texture> textures, Precision precision);

// A needed input value that is not finite in single precision; surfaces have only finite inputs.
struct FloatOverflow {
    size_t point = 0;
    InputNeed input;
    double value = 0;

    std::string message() const;  // "'uv0' holds 1e+40, which single precision does not"
};
std::vector<FloatOverflow> float_overflow(const Program& program, const PointSet& points);

}  // namespace wrinkle
