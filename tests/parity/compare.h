// The back ends of core/certify for tests: failures are test failures.
#pragma once

#include <gtest/gtest.h>

#include "certify/compare.h"
#include "glslang/validate.h"

namespace wrinkle::test {

using certify::Comparison;
using certify::ImageOf;
using certify::Reference;
using certify::Values;

template <class T>
Values on_cpu(const Module& module, const PointSet& points, const ImageOf& images) {
    std::string why;
    auto values = certify::on_cpu<T>(module, points, images, why);
    EXPECT_TRUE(values) << why;
    return values ? std::move(*values) : Values{};
}

// Returns an empty result and reports a test failure if the source does not compile.
inline Values on_gpu(const Shader& shader, const PointSet& points, const ImageOf& images) {
    EXPECT_EQ(compile_errors(shader), "");
    std::string why;
    auto values = certify::on_gpu(shader, points, images, why);
    EXPECT_TRUE(values) << why << shader.source;
    return values ? std::move(*values) : Values{};
}
inline Values on_gpu(const Module& module, const PointSet& points, const ImageOf& images) {
    return on_gpu(certify::given_text(module), points, images);
}

inline Reference make_reference(const Module& module, const PointSet& points,
                                const ImageOf& images) {
    std::string why;
    auto reference = certify::make_reference(module, points, images, why);
    EXPECT_TRUE(reference) << why;
    return reference ? std::move(*reference) : Reference{};
}

}  // namespace wrinkle::test
