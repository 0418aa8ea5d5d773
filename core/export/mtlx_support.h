// The values of a module that nodes of MaterialX's standard library compute: arithmetic of floats
// and vectors, reads of images, uv sets, the position, and bumps in the frame of the mesh's
// tangents. Derivatives, integers, loops and other frames are not among them.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ir/module.h"

namespace wrinkle {

class MtlxSupport {
public:
    // Jacobian of a value of one or two components that is affine in uv0, one row per component.
    struct Linear {
        std::array<std::array<double, 2>, 2> rows{};

        double determinant() const { return rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]; }
    };

    // Parameters of the module become inputs of the node graph.
    explicit MtlxSupport(const Module& module);

    // Returns true if a node computes the value; of a gradient or derivative, its slopes along u
    // and v of uv0 in the scale `unit`.
    bool has(Id value) const { return supported_[value]; }
    // Returns true if a node computes the normal in the world's space.
    bool has_normal(Id value) const;
    // Precondition: has(frame).
    const Linear& uv_of(Id frame) const { return *linear_[module_.operands(frame)[0]]; }

private:
    bool is_supported(Id id) const;
    bool is_gradient_supported(Id id) const;
    bool has_all(std::span<const Id> operands) const;
    bool is_comparison(Id id) const;
    bool has_frame(Id frame) const;
    std::optional<Linear> linear_of(Id id) const;
    std::optional<Linear> linear_sum(Id id) const;
    std::optional<Linear> linear_product(Id id) const;

    const Module& module_;
    std::vector<bool> supported_;
    std::vector<std::optional<Linear>> linear_;
};

// Returns the numbers of a constant, empty for other values.
std::vector<double> mtlx_constant(const Module& module, Id value);

}  // namespace wrinkle
