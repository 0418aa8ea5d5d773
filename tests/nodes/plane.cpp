#include "nodes/plane.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <tuple>

#include "graph/subgraph.h"
#include "image/texels.h"
#include "nodes/all.h"
#include "registry/plugin_loader.h"

namespace wrinkle::test {
namespace {

Registry make_registry() {
    Registry registry;
    Diagnostics diagnostics;
    EXPECT_TRUE(registry.add_plugin(built_in_nodes(), Registry::built_in, diagnostics));
    const std::vector<std::string> places{WRINKLE_RIPPLES};
    load_plugins(registry, places, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    return registry;
}

Compiled compiled(const std::string& nodes, const std::vector<std::string>& outputs,
                  Diagnostics& diagnostics) {
    std::string members;
    for (size_t i = 0; i < outputs.size(); ++i)
        members += (i ? ", \"value" + std::to_string(i) : "\"value") + R"(": {"from": ")" +
                   outputs[i] + R"("})";
    const std::string text =
        R"({"wrinkle": 1, "nodes": {)" + nodes + R"(}, "outputs": {)" + members + "}}";
    const auto folder = std::filesystem::path(WRINKLE_SOURCE_DIR) / "graphs";
    const Project project =
        load_project(read_document(text, "test.json", diagnostics), folder, {}, diagnostics);
    MaterialOptions options;
    options.given_differentials = true;
    return compile_material(project, registry(), options, diagnostics);
}

struct Property {
    SurfaceInput input;
    std::array<std::array<double, 4>, 3> by_variant;  // value, dx, dy
};

std::vector<Property> properties(double x, double y, const Scene& scene) {
    const double p = pixel;
    const auto& [n, v] = std::tie(scene.normal, scene.view);
    std::vector<Property> all{
        {SurfaceInput::position_, {{{x, y, 0}, {p, 0, 0}, {0, p, 0}}}},
        {SurfaceInput::normal_, {{{n[0], n[1], n[2]}}}},
        {SurfaceInput::tangent_, {{{1, 0, 0, 1}}}},
        {SurfaceInput::color0_, {{{0.2, 0.4, 0.6, 0.8}}}},
        {SurfaceInput::view_, {{{v[0], v[1], v[2]}}}},
        {SurfaceInput::facing_, {{{1}}}},
    };
    double scale = 1;
    for (const SurfaceInput set :
         {SurfaceInput::uv0_, SurfaceInput::uv1_, SurfaceInput::uv2_, SurfaceInput::uv3_}) {
        all.push_back({set, {{{scale * x, scale * y}, {scale * p, 0}, {0, scale * p}}}});
        scale += 1;
    }
    return all;
}

Texture texture_of(const Scene& scene, const Resource& resource) {
    const auto found = scene.pictures.find(resource.name);
    Image image = found == scene.pictures.end() ? scene.texture : found->second;
    if (image.empty()) {
        image = make_image(1, 1, 3);
        image.data.assign(3, 0.5f);
    }
    if (resource.options.decodes_texels()) decode_srgb(image);
    return Texture(build_mips(std::move(image)), resource.options);
}

// By output, point and component.
using Evaluated = std::vector<std::vector<std::vector<double>>>;

Evaluated evaluated(const Compiled& material, const Scene& scene, const PointSet& points) {
    std::string why;
    const Program program = compile_program(material.module, why);
    EXPECT_EQ(why, "");
    std::vector<Texture> textures;
    for (const Resource& resource : material.module.resources)
        textures.push_back(texture_of(scene, resource));
    Results results = make_results(program, points.count);
    evaluate<double>(program, points, textures, 0, points.count, results);
    Evaluated all(program.outputs.size());
    for (size_t k = 0; k < all.size(); ++k) {
        const size_t lanes = program.outputs[k].regs.size();
        for (size_t i = 0; i < points.count; ++i) {
            const auto first = results.values[k].begin() + static_cast<ptrdiff_t>(i * lanes);
            all[k].emplace_back(first, first + static_cast<ptrdiff_t>(lanes));
        }
    }
    return all;
}

}  // namespace

const Registry& registry() {
    static const Registry registry = make_registry();
    return registry;
}

PointSet plane_points(const Scene& scene, const std::vector<std::array<double, 2>>& points) {
    PointSet set;
    set.count = points.size();
    for (const auto& [x, y] : points)
        for (const Property& property : properties(x, y, scene))
            for (size_t variant = 0; variant < 3; ++variant) {
                auto& target = set.at(property.input, static_cast<Variant>(variant));
                const size_t lanes = info(info(property.input).type).lanes;
                for (size_t lane = 0; lane < lanes; ++lane)
                    target.push_back(property.by_variant[variant][lane]);
            }
    return set;
}

std::vector<std::vector<double>> values(const Scene& scene,
                                        const std::vector<std::array<double, 2>>& points) {
    return values(scene, plane_points(scene, points));
}

std::vector<std::vector<double>> values(const Scene& scene, const PointSet& points) {
    auto all = values(scene, {scene.output}, points);
    return all.empty() ? std::vector<std::vector<double>>() : std::move(all[0]);
}

std::vector<std::vector<std::vector<double>>> values(const Scene& scene,
                                                     const std::vector<std::string>& outputs,
                                                     const PointSet& points) {
    Diagnostics diagnostics;
    const Compiled material = compiled(scene.nodes, outputs, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "") << scene.nodes;
    return material.ok ? evaluated(material, scene, points) : Evaluated{};
}

std::vector<double> value_with_warnings(const std::string& nodes, const std::string& output) {
    Diagnostics diagnostics;
    const Scene scene{nodes, output};
    const Compiled material = compiled(nodes, {output}, diagnostics);
    EXPECT_EQ(diagnostics.error_count(), 0U) << to_text(diagnostics);
    if (!material.ok) return {};
    return evaluated(material, scene, plane_points(scene, {{0.3, 0.6}}))[0][0];
}

std::vector<double> value(const Scene& scene, double x, double y) {
    const auto all = values(scene, {{x, y}});
    return all.empty() ? std::vector<double>(4) : all[0];
}

std::string problems(const std::string& nodes, const std::string& output) {
    Diagnostics diagnostics;
    compiled(nodes, {output}, diagnostics);
    return to_text(diagnostics);
}

std::string one(const std::string& type, const std::string& in) {
    std::string members = in, more;
    const auto set = [&](const Port& port, const std::string& value) {
        members += (members.empty() ? "\"" : ", \"") + port.name + "\": " + value;
    };
    for (const Port& port : registry().find(type)->ports) {
        if (port.kind != Port::Kind::input) continue;
        if (port.type == PortType::image_) set(port, R"("textures/weave_normal.png")");
        if (port.type != PortType::material_) continue;
        set(port, R"({"from": "glossy.material"})");
        more = R"(, "glossy": {"type": "material", "in": {"roughness": 0.1}})";
    }
    return R"("n": {"type": ")" + type + R"(", "in": {)" + members + "}}" + more;
}

Image painted(uint32_t size, std::array<double, 3> (*formula)(double u, double v)) {
    Image image = make_image(size, size, 3);
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const auto color = formula((x + 0.5) / size, (y + 0.5) / size);
            for (uint32_t c = 0; c < 3; ++c)
                image.texel(x, y)[c] = static_cast<float>(color[c]);
        }
    return image;
}

}  // namespace wrinkle::test
