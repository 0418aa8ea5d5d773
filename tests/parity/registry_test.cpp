// Tests of properties of every registered node: it is documented, its graph survives a round trip
// through the file, and its derivatives agree with central differences.
#include <gtest/gtest.h>

#include "certify/checks.h"
#include "certify/points.h"
#include "parity/compare.h"
#include "parity/node_graph.h"

namespace wrinkle::test {
namespace {

// Runs a check of core/certify on every node; findings are test failures. Returns the summed
// counts.
template <class Check>
certify::Report expect_none(Check check) {
    certify::Report all;
    for (const NodeType& type : all_nodes().list()) {
        certify::Report report;
        report.node = type.id;
        check(type, report);
        for (const certify::Finding& finding : report.findings)
            ADD_FAILURE() << to_text(to_diagnostic(finding, report, type.origin)) << "\n"
                          << finding.graph;
        all.derivatives += report.derivatives;
        all.kinks += report.kinks;
    }
    return all;
}

TEST(EveryNode, IsDocumented) {
    ASSERT_GE(all_nodes().list().size(), 20U);
    expect_none(certify::check_descriptor);
}

TEST(EveryNode, HasValidTextThatSurvivesARoundTrip) {
    expect_none([](const NodeType& type, certify::Report& report) {
        certify::check_text(type, bench(), report);
    });
}

TEST(EveryNode, HasTheDerivativeThatDifferencesSay) {
    size_t nodes = 0;
    const certify::Report all = expect_none([&](const NodeType& type, certify::Report& report) {
        certify::check_derivatives(type, bench(), report);
        nodes += report.derivatives > 0 ? 1 : 0;
    });
    EXPECT_GE(nodes, 40U);
    EXPECT_GE(all.derivatives, 20000U);
    EXPECT_LE(static_cast<double>(all.kinks), 0.02 * static_cast<double>(all.derivatives));
}

// A number has the same meaning as a literal and as a uniform; frames and errors do not depend on
// it.
TEST(EveryNode, MeansTheSameBakedAndUniform) {
    expect_none([](const NodeType& type, certify::Report& report) {
        certify::check_uniforms(type, bench(), report);
    });
}

// In single precision, at the smallest pixel sizes in use: eq. 3 divides by (pixel size)^2.
TEST(HeightGradient, IsTheSameAtEveryPixelSize) {
    const Subject subject =
        compile_harness(*all_nodes().find("gradient_from_height"), Inputs::wires, 41);
    ASSERT_TRUE(subject.compiled.ok);
    const PointSet points = certify::random_points(100, 29);
    Values expected;
    for (const double size : {1.0, 1e-3, 1e-6}) {
        PointSet scaled = points;
        for (auto& input : scaled.values)
            for (const Variant variant : {Variant::dx, Variant::dy})
                for (double& each : input[static_cast<size_t>(variant)])
                    each = static_cast<double>(static_cast<float>(each * size));
        const Values values = on_cpu<float>(subject.compiled.module, scaled, test_image);
        if (expected.empty()) expected = values;
        for (size_t k = 0; k < values[0].size(); ++k)
            EXPECT_NEAR(values[0][k], expected[0][k], 2e-5) << "pixel size " << size;
    }
}

}  // namespace
}  // namespace wrinkle::test
