// Reads the values of a glTF accessor with checks of every range.
//
// Normalised integers are converted to floats as in glTF 2.0, section 3.6.2.2 (c / 255,
// max(c / 127, -1), and so on); sparse accessors are resolved. On failure the functions return
// std::nullopt and store one sentence in `why`.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace wrinkle {

struct AccessorFloats {
    int components = 0;
    size_t count = 0;
    std::vector<float> values;  // count * components
};

std::optional<AccessorFloats> read_floats(const tinygltf::Model& model, int accessor,
                                          uint64_t max_count, std::string& why);
// Reads scalar unsigned integers of 1, 2 or 4 bytes.
std::optional<std::vector<uint32_t>> read_indices(const tinygltf::Model& model, int accessor,
                                                  uint64_t max_count, std::string& why);

}  // namespace wrinkle
