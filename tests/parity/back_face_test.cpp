// T13: tests of back faces for every node that makes a bump. The oracle is geometry: the front has
// the bump g; a solid (mirror) shows -n with the same outward bump, a thin sheet (flip) the other
// side of the bumped front, and `none` the front's own normal.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "certify/points.h"
#include "parity/compare.h"
#include "parity/node_graph.h"

namespace wrinkle::test {
namespace {

using glm::dvec3;

bool is_bump(const Port& port) {
    return port.kind == Port::Kind::output &&
           (port.type == PortType::gradient_ || port.type == PortType::derivative_ ||
            port.type == PortType::height_);
}

// Resolves the node's output as `bump` and `normal`, with a rule for back faces. The choice
// "opposite" is replaced by "toward", so that normals that point inward are mirrored.
Compiled resolved(std::string text, const std::string& port, std::string_view rule) {
    const std::string from = R"({"from": "subject.)" + port + R"("})";
    const auto cut = [&](const std::string& begin, const std::string& with, size_t length) {
        const size_t at = text.find(begin);
        ASSERT_NE(at, std::string::npos);
        text.replace(at, length == 0 ? text.find(',', at) - at : length, with);
    };
    cut("\"back_faces\"", "\"back_faces\": \"" + std::string(rule) + "\"", 0);
    cut("\"nodes\": {",
        "\"nodes\": {\"r\": {\"type\": \"resolve\", \"in\": {\"gradient\": " + from +
            "}}, \"g\": {\"type\": \"gradient_scale\", \"in\": {\"gradient\": " + from + "}}, ",
        10);
    cut("\"outputs\": {",
        R"("outputs": {"bump": {"from": "g.gradient"}, "normal": {"from": "r.normal"}}})",
        std::string::npos);
    if (const size_t at = text.find("\"opposite\""); at != std::string::npos)
        text.replace(at, 10, "\"toward\"");
    Diagnostics diagnostics;
    const Project project = load_project(read_document(text, "subject.json", diagnostics),
                                         image_folder(), {}, diagnostics);
    MaterialOptions options;
    options.uniform_parameters = true;
    options.given_differentials = true;
    Compiled compiled = compile_material(project, all_nodes(), options, diagnostics);
    EXPECT_TRUE(compiled.ok) << to_text(diagnostics) << text;
    return compiled;
}

dvec3 vector_at(const std::vector<double>& values, size_t point) {
    return {values[3 * point], values[3 * point + 1], values[3 * point + 2]};
}

struct Rule {
    std::string_view name;
    double bump;  // sign of the front's bump, relative to the visible normal
    double turn;
};
constexpr Rule rules[] = {{"mirror", 1, -1}, {"flip", -1, -1}, {"none", 1, 1}};

void expect_back(const std::string& text, const std::string& port, PointSet points) {
    const size_t count = points.count;
    points.at(SurfaceInput::facing_).assign(count, 1);
    PointSet behind = points;
    behind.at(SurfaceInput::facing_).assign(count, -1);
    for (const Rule& rule : rules) {
        const Compiled compiled = resolved(text, port, rule.name);
        if (!compiled.ok) return;
        const Values front = on_cpu<double>(compiled.module, points, test_image);
        const Values back = on_cpu<double>(compiled.module, behind, test_image);
        for (size_t i = 0; i < count; ++i) {
            const dvec3 n = glm::normalize(vector_at(points.at(SurfaceInput::normal_), i));
            const dvec3 gamma = vector_at(front[0], i);
            const dvec3 in_front = glm::normalize(n - gamma);
            const dvec3 seen = glm::normalize(n * rule.turn - gamma * rule.bump);
            ASSERT_LE(glm::distance(vector_at(front[1], i), in_front), 1e-6) << text;
            ASSERT_LE(glm::distance(vector_at(back[1], i), seen), 1e-6)
                << rule.name << ", point " << i << ", output " << port << "\n"
                << text;
        }
    }
}

TEST(EveryBump, T13_IsMirroredFlippedOrKeptOnBackFaces) {
    const PointSet points = certify::random_points(40, 5);
    int bumps = 0;
    for (const NodeType& type : all_nodes().list())
        for (const Port& port : type.ports) {
            if (!is_bump(port)) continue;
            for (const Inputs inputs : {Inputs::defaults, Inputs::numbers})
                expect_back(compile_harness(type, inputs, 9).text, port.name, points);
            ++bumps;
        }
    EXPECT_GE(bumps, 14);
}

}  // namespace
}  // namespace wrinkle::test
