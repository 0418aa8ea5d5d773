// Tests of wrinkle import of MaterialX documents: values of the graph against the specification.
#include <cmath>

#include "materialx/support.h"

namespace wrinkle::test {
namespace {

// An output and the input of the shader that it is.
struct SameValue {
    const char* output;
    const char* input;
    double factor = 1;
};

struct Case {
    const char* document;
    std::vector<SameValue> same;
    std::vector<std::pair<const char*, double>> numbers = {};
};

const std::vector<Case> node_cases = {
    {"constants",
     {{"color", "base_color"}, {"roughness", "specular_roughness"}, {"emission", "emission_color"}},
     {{"metalness", 0.75}, {"coat_weight", 0.5}, {"emission_luminance", 0}}},
    {"image", {{"color", "base_color"}, {"roughness", "specular_roughness"}}},
    {"tiled", {{"color", "base_color"}}},
    {"place_scale_first", {{"color", "base_color"}}},
    {"place_offset_first", {{"color", "base_color"}}},
    {"normal", {{"normal", "normal"}, {"color", "base_color"}}, {{"roughness", 0.2}}},
    {"normal_turned", {{"normal", "geometry_normal"}, {"coat_normal", "geometry_coat_normal"}}},
    {"arithmetic", {{"color", "base_color"}, {"roughness", "specular_roughness"}}},
    {"interface", {{"color", "base_color"}}},
    {"definition", {{"color", "base_color"}}},
};

// Numbers are worked out by hand from the definitions of the shading models.
const std::vector<Case> model_cases = {
    {"gltf",
     {{"color", "base_color"},
      {"occlusion", "occlusion"},
      {"roughness", "roughness"},
      {"metalness", "metallic"},
      {"opacity", "alpha"},
      {"fuzz_color", "sheen_color"},
      {"emission", "emissive"}},
     {{"coat_weight", 0.6},
      {"coat_ior", 1.5},
      {"coat_darkening", 0},
      {"fuzz_weight", 1},
      {"fuzz_roughness", 0.629961},
      {"emission_luminance", 300}}},
    {"standard",
     {{"color", "base_color"},
      {"metalness", "metalness"},
      {"subsurface_radius_scale", "subsurface_radius"}},
     {{"base_weight", 0.7},
      {"roughness", 0.2},
      {"coat_weight", 0.5},
      {"coat_roughness", 0.1},
      {"coat_ior", 1.5},
      {"coat_darkening", 0},
      {"fuzz_weight", 0.25},
      {"fuzz_roughness", 0.617801},
      {"emission_luminance", 200},
      {"subsurface_weight", 0.5},
      {"thin_film_weight", 1},
      {"thin_film_thickness", 0.55},
      {"thin_film_ior", 1.5},
      {"opacity", 0.5}}},
};

class MaterialXImport : public MaterialXTest {
protected:
    void check_values(const Case& each) {
        SCOPED_TRACE(each.document);
        const std::string text = document_text(each.document);
        const Ran ran = import(text);
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.err, "");
        const materialx::Document document = read(text);
        for (const OraclePoint& point : some_points()) {
            const json::Value found = values("a.json", point);
            const Oracle oracle(document, images, point);
            for (const SameValue& same : each.same)
                expect_near(found.find(same.output), oracle.input(same.input), same.output);
            for (const auto& [output, number] : each.numbers)
                expect_near(found.find(output), {number}, output);
        }
        EXPECT_EQ(run({"check", "a.json"}).err, "");
        EXPECT_EQ(run({"format", "--check", "a.json"}).code, 0);
    }
};

TEST_F(MaterialXImport, ValuesAreThoseOfTheSpecification) {
    for (const Case& each : node_cases)
        check_values(each);
    for (const Case& each : model_cases)
        check_values(each);
}

TEST_F(MaterialXImport, DisplacementIsScaled) {
    const std::string text = document_text("arithmetic");
    ASSERT_EQ(import(text).code, 0);
    const OraclePoint point = some_points().front();
    const double height =
        Oracle(read(text), images, point).input("displacement", "Displaced").front();
    expect_near(values("a.json", point).find("displacement"), {0.2 * height}, "displacement");
}

TEST_F(MaterialXImport, InterfacesAreExposed) {
    ASSERT_EQ(import(document_text("interface")).code, 0);
    const json::Value inputs = parsed(get("a.json")).find("inputs");
    EXPECT_EQ(inputs.find("tiling").find("type").as_string(), "vec2");
    EXPECT_EQ(inputs.find("tiling").find("slider").at(1).as_number(), 10);
    EXPECT_EQ(inputs.find("tint").find("label").as_string(), "Tint");
    EXPECT_EQ(inputs.find("tint").find("group").as_string(), "Paint");
    EXPECT_EQ(inputs.find("tint").find("default").at(1).as_number(), 0.6);
}

// heighttonormal has the slope dh/du / 16 of a height of the uv set, here 4/5 per unit of u.
TEST_F(MaterialXImport, HeightsHaveSlopesPerUnitOfUv) {
    Image ramp = make_image(8, 8, 1);
    for (uint32_t y = 0; y < 8; ++y)
        for (uint32_t x = 0; x < 8; ++x)
            ramp.texel(x, y)[0] = static_cast<float>(0.1 * x);
    images["ramp.exr"] = ramp;
    save("ramp.exr", ramp);
    const std::string graph = R"(<image name="h" type="float">
      <input name="file" type="filename" value="ramp.exr"/></image>
      <heighttonormal name="n" type="vector3"><input name="in" type="float" nodename="h"/>
      <input name="scale" type="float" value="8"/></heighttonormal>
      <normalmap name="m" type="vector3"><input name="in" type="vector3" nodename="n"/></normalmap>)";
    ASSERT_EQ(
        import(surface(graph, R"(<input name="geometry_normal" type="vector3" nodename="m"/>)"))
            .code,
        0);
    const double slope = 0.8 * 8 / 16, length = std::hypot(slope, 1.0);
    expect_near(values("a.json", {{0.5, 0.5}, {}}).find("normal"), {-slope / length, 0, 1 / length},
                "normal");
}

}  // namespace
}  // namespace wrinkle::test
