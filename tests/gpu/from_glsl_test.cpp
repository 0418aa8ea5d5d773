#include "gpu/point_runner.h"

#include "emit/emit.h"
#include "fixture.h"
#include "ir/op.h"

namespace wrinkle::gpu {
namespace {

using FromGlslTest = WithRenderer;

Shader written_by_hand() {
    Shader shader;
    shader.source =
        "struct WrinkleSurface_hand {\n    vec3 position_relative;\n    vec2 uv0;\n};\n"
        "uniform vec2 bump_amount;\nuniform sampler2D bump_image;\n"
        "vec3 wrinkle_hand(WrinkleSurface_hand s) {\n"
        "    vec3 n = normalize(cross(dFdx(s.position_relative), dFdy(s.position_relative)));\n"
        "    return n * bump_amount.y * texture(bump_image, s.uv0).r;\n}\n";
    Reflection& reflection = shader.reflection;
    reflection.function = "wrinkle_hand";
    reflection.struct_name = "WrinkleSurface_hand";
    reflection.members = {
        {"position_relative", Type::vec3_, SurfaceInput::position_, Variant::value, true},
        {"uv0", Type::vec2_, SurfaceInput::uv0_, Variant::value, false}};
    OutputInfo normal;
    normal.output = normal.member = "normal";
    normal.type = Type::vec3_;
    reflection.outputs = {normal};
    UniformInfo amount;
    amount.name = "bump_amount";
    amount.type = Type::vec2_;
    amount.value = {3, 0.5, 0, 0};
    reflection.uniforms = {amount};
    SamplerInfo image;
    image.name = "bump_image";
    image.file = "two";
    image.options.filter = Filter::nearest;
    reflection.samplers = {image};
    return shader;
}

TEST_F(FromGlslTest, DrawsAGeneratedShader) {
    Image image = make_image(1, 1, 1);
    image.data = {8};
    ASSERT_TRUE(renderer->add_image({"two"}, build_mips(image), diagnostics)) << errors();
    show("plane");
    for (const Pixel& pixel : draw(written_by_hand(), View::normal)) {
        const glm::vec3 expected = pixel.covered ? glm::vec3(0, 0, 4) : glm::vec3(0);
        ASSERT_LT(glm::distance(pixel.value, expected), 1e-3);
    }
}

TEST_F(FromGlslTest, SaysWhichNodeADriverRefuses) {
    Shader shader = written_by_hand();
    shader.reflection.node_paths = {"", "bump"};
    shader.reflection.lines.assign(100, no_node);
    const size_t at = shader.source.rfind("return");
    ASSERT_NE(at, std::string::npos);
    shader.source.insert(at, "nonsense; ");
    const auto line = std::count(shader.source.begin(), shader.source.begin() + at, '\n');
    shader.reflection.lines[static_cast<size_t>(line)] = 1;
    Image image = make_image(1, 1, 1);
    image.data = {8};
    ASSERT_TRUE(renderer->add_image({"two"}, build_mips(image), diagnostics)) << errors();
    EXPECT_FALSE(renderer->set_material(shader, diagnostics));
    ASSERT_FALSE(diagnostics.list().empty());
    EXPECT_EQ(diagnostics.list()[0].node, "bump") << diagnostics.list()[0].message;
}

TEST_F(FromGlslTest, RunsAGeneratedShaderOnPoints) {
    Shader shader = written_by_hand();
    shader.source =
        "struct WrinkleSurface_hand { vec2 uv0; vec2 uv0_dx; };\nuniform vec2 bump_amount;\n"
        "struct WrinkleMaterial_hand { float a; vec2 b; vec4 c; };\n"
        "WrinkleMaterial_hand wrinkle_hand(WrinkleSurface_hand s) {\n"
        "    return WrinkleMaterial_hand(s.uv0.x * bump_amount.x, s.uv0 + s.uv0_dx,\n"
        "                                vec4(s.uv0, s.uv0_dx));\n}\n";
    shader.reflection.members = {{"uv0", Type::vec2_, SurfaceInput::uv0_, Variant::value, false},
                                 {"uv0_dx", Type::vec2_, SurfaceInput::uv0_, Variant::dx, false}};
    shader.reflection.samplers.clear();
    shader.reflection.result_name = "WrinkleMaterial_hand";
    shader.reflection.outputs.clear();
    for (const auto& [output, type] :
         {std::pair("a", Type::float_), std::pair("b", Type::vec2_), std::pair("c", Type::vec4_)}) {
        OutputInfo& info = shader.reflection.outputs.emplace_back();
        info.output = info.member = output;
        info.type = type;
    }
    PointJob job = point_job_from(shader);
    job.points = 2;
    job.attributes = {{"uv0", 2, {1, 2, 3, 4}}, {"uv0_dx", 2, {10, 20, 30, 40}}};
    const auto results = run_points(job, diagnostics);
    ASSERT_TRUE(results) << errors();
    ASSERT_EQ(results->size(), 3U);
    EXPECT_EQ((*results)[0][1], (std::array<float, 4>{9, 0, 0, 0}));
    EXPECT_EQ((*results)[1][0], (std::array<float, 4>{11, 22, 0, 0}));
    EXPECT_EQ((*results)[2][1], (std::array<float, 4>{3, 4, 30, 40}));
}

}  // namespace
}  // namespace wrinkle::gpu
