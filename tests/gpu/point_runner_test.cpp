#include "gpu/point_runner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "fixture.h"

namespace wrinkle::gpu {
namespace {

using PointRunner = WithContext;

// Returns `count` different finite numbers of many magnitudes.
std::vector<float> numbers(size_t count) {
    std::vector<float> values;
    for (size_t i = 0; i < count; ++i) {
        const auto k = static_cast<float>(i);
        values.push_back((i % 2 ? -1.0F : 1.0F) *
                         std::ldexp(1.0F + k / 7919, static_cast<int>(i % 60) - 30));
    }
    return values;
}

TEST_F(PointRunner, BringsAttributesThereAndBackToTheLastBit) {
    constexpr size_t points = 2500;  // more than two rows
    PointJob job;
    job.points = points;
    job.outputs = 4;
    for (int components = 1; components <= 4; ++components)
        job.attributes.push_back({"a" + std::to_string(components), components,
                                  numbers(points * static_cast<size_t>(components))});
    job.body =
        "out0 = vec4(a1, 0.0, 0.0, 1.0); out1 = vec4(a2, 0.0, 1.0);"
        "out2 = vec4(a3, 1.0); out3 = a4;";
    const auto results = run_points(job, diagnostics);
    ASSERT_TRUE(results) << errors();
    ASSERT_EQ(results->size(), 4U);
    for (size_t k = 0; k < 4; ++k) {
        ASSERT_EQ((*results)[k].size(), points);
        for (size_t i = 0; i < points; ++i)
            ASSERT_EQ(std::memcmp((*results)[k][i].data(), &job.attributes[k].values[i * (k + 1)],
                                  (k + 1) * sizeof(float)),
                      0)
                << "attribute " << k << " of point " << i;
    }
}

TEST_F(PointRunner, CallsFunctionsWithUniforms) {
    PointJob job;
    job.points = 3;
    job.attributes = {{"x", 1, {1, 2, 3}}};
    job.globals =
        "uniform float factor;\nuniform vec2 shift;\nstruct S { float x; };\n"
        "float twice(S s) { return factor * s.x + shift.y; }\n";
    job.body = "S s;\ns.x = x;\nout0 = vec4(twice(s));";
    job.uniforms = {uniform_info("factor", Type::float_, {2}),
                    uniform_info("shift", Type::vec2_, {5, 0.5}),
                    uniform_info("unused", Type::vec3_, {1, 2, 3})};
    const auto results = run_points(job, diagnostics);
    ASSERT_TRUE(results) << errors();
    EXPECT_EQ((*results)[0][0][0], 2.5F);
    EXPECT_EQ((*results)[0][2][3], 6.5F);
}

TEST_F(PointRunner, HasAnyNumberOfOutputs) {
    PointJob job;
    job.points = 3;
    job.outputs = 19;
    job.attributes = {{"x", 1, {1, 2, 3}}};
    for (int k = 0; k < job.outputs; ++k)
        job.body += "out" + std::to_string(k) + " = vec4(x * " + std::to_string(k) + ".0);";
    const auto results = run_points(job, diagnostics);
    ASSERT_TRUE(results) << errors();
    ASSERT_EQ(results->size(), 19U);
    for (size_t k = 0; k < 19; ++k)
        EXPECT_EQ((*results)[k][2][0], 3.0F * static_cast<float>(k));
}

TEST_F(PointRunner, HasNothingToDoForNoPoints) {
    PointJob job;
    job.body = "out0 = vec4(1.0);";
    const auto results = run_points(job, diagnostics);
    ASSERT_TRUE(results) << errors();
    ASSERT_EQ(results->size(), 1U);
    EXPECT_TRUE(results->front().empty());
}

struct Refusal {
    const char* words;
    void (*spoil)(PointJob&);
};

TEST_F(PointRunner, RefusesWhatDoesNotFit) {
    const std::vector<Refusal> refusals{
        {"'x' has 2 values", [](PointJob& job) { job.attributes[0].values.pop_back(); }},
        {"'x' needs 1 to 4 components", [](PointJob& job) { job.attributes[0].components = 5; }},
        {"at least one output", [](PointJob& job) { job.outputs = 0; }},
        {"too large", [](PointJob& job) { job.points = size_t{1} << 40; }},
        {"no image is given for 'a.png'",
         [](PointJob& job) { job.samplers = {sampler_info("t", "a.png")}; }},
        {":2(", [](PointJob& job) { job.globals = "float f;\nfloat g = oops;\n"; }},
        {":200001(", [](PointJob& job) { job.body = "out0 = vec4(nonsense);"; }},
    };
    for (const Refusal& refusal : refusals) {
        PointJob job;
        job.points = 3;
        job.attributes = {{"x", 1, {1, 2, 3}}};
        job.body = "out0 = vec4(x);";
        refusal.spoil(job);
        Diagnostics said;
        EXPECT_FALSE(run_points(job, said));
        EXPECT_EQ(said.error_count(), 1U);
        EXPECT_TRUE(mentions(to_text(said), refusal.words)) << to_text(said);
    }
}

}  // namespace
}  // namespace wrinkle::gpu
