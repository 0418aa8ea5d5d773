// Tests of `wrinkle export --to materialx`: documents that mean the same as the graph, by the
// specification (the oracle) and by importing them again.
#include <span>

#include "base/standard_outputs.h"
#include "materialx/support.h"

namespace wrinkle::test {
namespace {

class MaterialXExport : public MaterialXTest {
protected:
    // Exports a.json to the folder `out` of the document a.mtlx.
    Ran export_graph(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words = {"export", "a.json", "--to",  "materialx", "-o",
                                          "out",    "--mesh", "plane", "--size",    "32"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    Ran import_export() const { return run({"import", "out/a.mtlx", "-o", "out/b.json"}); }

    std::string exported() const { return get("out/a.mtlx"); }
    bool has(const std::string& text) const { return exported().find(text) != std::string::npos; }

    // Expects equal outputs of both graphs, all but those of `lost`.
    void expect_same(const OraclePoint& point, const std::string& lost) const {
        const json::Value before = values("a.json", point), after = values("out/b.json", point);
        for (const json::Member& member : before.children()) {
            const std::string key(member.key);
            if (key == lost) continue;
            ASSERT_FALSE(after.find(key).is(json::Kind::null)) << key;
            expect_near(after.find(key), numbers_of(member.value), key);
        }
    }

    // Expects the outputs of a.json as values of the exported document.
    void expect_specified(const OraclePoint& point, const std::string& lost) const {
        const materialx::Document document = read(exported());
        const Oracle oracle(document, images, point);
        for (const json::Member& member : values("a.json", point).children()) {
            const std::string key(member.key);
            if (key == lost) continue;
            const std::string_view synonym = find_standard_output(key)->synonym;
            const bool is_shader = key != "displacement";
            expect_near(member.value,
                        oracle.input(synonym.empty() ? key : std::string(synonym),
                                     is_shader ? "a_shader" : "a_displacement"),
                        key);
        }
    }

    static std::vector<double> numbers_of(const json::Value& value) {
        if (value.is(json::Kind::number)) return {value.as_number()};
        std::vector<double> numbers;
        for (size_t i = 0; i < value.size(); ++i)
            numbers.push_back(value.at(i).as_number());
        return numbers;
    }
};

struct RoundTrip {
    const char* document;
    const char* lost = "";  // an output without a counterpart
};
constexpr RoundTrip round_trips[] = {
    {"arithmetic"}, {"constants"}, {"definition"},    {"gltf", "occlusion"},  {"image"},
    {"interface"},  {"normal"},    {"normal_turned"}, {"place_offset_first"}, {"place_scale_first"},
    {"standard"},   {"tiled"}};

TEST_F(MaterialXExport, DocumentsMeanTheSameAfterARoundTrip) {
    for (const RoundTrip& trip : round_trips) {
        SCOPED_TRACE(trip.document);
        ASSERT_EQ(import(document_text(trip.document)).code, 0);
        const Ran ran = export_graph();
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.err.empty(), std::string_view(trip.lost).empty()) << ran.err;
        EXPECT_EQ(ran.out.find("a_"), std::string::npos) << "baked: " << ran.out;
        const Ran again = import_export();
        ASSERT_EQ(again.code, 0) << again.err;
        EXPECT_EQ(again.err, "");
        for (const OraclePoint& point : some_points()) {
            expect_same(point, trip.lost);
            expect_specified(point, trip.lost);
        }
    }
}

// "x" and "y" are the coordinates of uv0, less 0.5.
constexpr std::pair<const char*, const char*> operations[] = {
    {"absolute", R"("x": @x)"},
    {"add", R"("a": @x, "b": @y)"},
    {"arccosine", R"("x": @x)"},
    {"arcsine", R"("x": @x)"},
    {"arctangent", R"("x": @x)"},
    {"arctangent2", R"("y": @x, "x": @y)"},
    {"ceiling", R"("x": @x)"},
    {"clamp", R"("x": @x, "low": -0.1, "high": 0.2)"},
    {"compare", R"("a": @x, "b": @y, "comparison": "less", "yes": @y, "no": 0.25)"},
    {"compare", R"("a": @x, "b": @y, "comparison": "greater_equal", "yes": 3, "no": @x)"},
    {"cosine", R"("angle": @x)"},
    {"divide", R"("a": @x, "b": @y)"},
    {"exponential", R"("x": @x)"},
    {"floor", R"("x": @x)"},
    {"fraction", R"("x": @x)"},
    {"hypotenuse", R"("a": @x, "b": @y)"},
    {"maximum", R"("a": @x, "b": @y)"},
    {"minimum", R"("a": @x, "b": @y)"},
    {"mix", R"("a": @x, "b": 0.75, "mask": @y)"},
    {"modulo", R"("x": @x, "divisor": 0.3)"},
    {"multiply", R"("a": @x, "b": @y)"},
    {"negate", R"("x": @x)"},
    {"power", R"("base": @x, "exponent": 1.5)"},
    {"remap", R"("x": @x, "from_high": 0.4, "to_low": @y)"},
    {"round", R"("x": @x)"},
    {"safe_power", R"("base": @x, "exponent": 1.5)"},
    {"sign", R"("x": @x)"},
    {"sine", R"("angle": @x)"},
    {"smoothstep", R"("low": -0.4, "high": 0.3, "x": @x)"},
    {"square_root", R"("x": @x)"},
    {"step", R"("edge": 0.1, "x": @x)"},
    {"subtract", R"("a": @x, "b": @y)"},
    {"tangent", R"("angle": @x)"},
};

// A graph with an operation as each of some outputs of numbers.
std::string graph_of(std::span<const std::pair<const char*, const char*>> rows) {
    std::string nodes =
        R"("u": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
        "x": {"type": "subtract", "in": {"a": {"from": "u.x"}, "b": 0.5}},
        "y": {"type": "subtract", "in": {"a": {"from": "u.y"}, "b": 0.5}})";
    std::string outputs;
    size_t row = 0;
    for (const StandardOutput& output : standard_output_table) {
        const bool is_number = output.type == "float" && output.name != "occlusion";
        if (!is_number || output.name == "thin_walled" || row == rows.size()) continue;
        const auto& [type, inputs] = rows[row++];
        std::string in = inputs;
        for (const char* axis : {"x", "y"})
            for (size_t at; (at = in.find("@" + std::string(axis))) != in.npos;)
                in.replace(at, 2, R"({"from": ")" + std::string(axis) + R"(.result"})");
        const std::string name = "n" + std::to_string(row);
        nodes += R"(, ")" + name + R"(": {"type": ")" + type + R"(", "in": {)" + in + "}}";
        outputs += (outputs.empty() ? "" : ", ") + ("\"" + std::string(output.name)) +
                   R"(": {"from": ")" + name + R"(.result"})";
    }
    EXPECT_EQ(row, rows.size());
    return R"({"wrinkle": 1, "nodes": {)" + nodes + R"(}, "outputs": {)" + outputs + "}}";
}

TEST_F(MaterialXExport, ArithmeticMeansTheSameAfterARoundTrip) {
    const std::span all(operations);
    for (const auto rows : {all.first(16), all.subspan(16)}) {
        put("a.json", graph_of(rows));
        const Ran ran = export_graph();
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.out, "README.txt\na.mtlx\n");
        const Ran again = import_export();
        ASSERT_EQ(again.code, 0) << again.err;
        for (const OraclePoint& point : some_points())
            expect_same(point, "");
    }
}

// Three outputs that nodes cannot compute, over the uv of a plane. Texel (20, 6) of 32.
constexpr const char* cells = R"({"wrinkle": 1,
    "inputs": {"scale": {"type": "float", "default": 3}, "tint": {"type": "color",
      "default": [0.2, 0.4, 0.8], "label": "Tint", "group": "Paint"}},
    "nodes": {
      "uv": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
      "at": {"type": "combine_vec3", "in": {"x": {"from": "uv.x"}, "y": {"from": "uv.y"}}},
      "noise": {"type": "value_noise", "in": {"point": {"from": "at.vector"},
        "scale": {"from": "input.scale"}}},
      "positive": {"type": "absolute", "in": {"x": {"from": "noise.value"}}},
      "slope": {"type": "combine_vec3", "in": {"x": {"from": "noise.value"}, "z": 1}},
      "bump": {"type": "gradient_from_tangent_normal", "in": {"normal": {"from": "slope.vector"}}},
      "resolve": {"type": "resolve", "in": {"gradient": {"from": "bump.gradient"}}}},
    "outputs": {"metalness": {"from": "noise.value"}, "roughness": {"from": "positive.result"},
      "normal": {"from": "resolve.normal"}, "color": {"from": "input.tint"},
      "specular_ior": {"from": "input.scale"}}})";

TEST_F(MaterialXExport, BakesOtherOutputs) {
    put("a.json", cells);
    const Ran ran = export_graph();
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out,
              "README.txt\na.mtlx\ntextures/a_metalness.exr\ntextures/a_normal.png\n"
              "textures/a_roughness.png\n");
    const Ran again = import_export();
    ASSERT_EQ(again.code, 0) << again.err;
    expect_same({{20.5 / 32, 6.5 / 32}, {}}, "");
}

// Slopes along the directions of a turned uv of uneven scale, with another map on top.
TEST_F(MaterialXExport, MapsOfATurnedUvAreTurned) {
    put("a.json", R"({"wrinkle": 1, "nodes": {
      "uv": {"type": "uv_transform", "in": {"scale": [3, 2], "rotation": 30}},
      "turned": {"type": "tangent_normal_map", "in": {"image": "normal.png", "uv": {"from": "uv.uv"},
        "strength": 0.7}},
      "plain": {"type": "tangent_normal_map", "in": {"image": "normal.png"}},
      "sum": {"type": "gradient_add", "in": {"a": {"from": "turned.gradient"},
        "b": {"from": "plain.gradient"}}},
      "normal": {"type": "resolve", "in": {"gradient": {"from": "sum.gradient"}}},
      "coat": {"type": "resolve", "in": {"gradient": {"from": "turned.gradient"}}}},
      "outputs": {"normal": {"from": "normal.normal"}, "coat_normal": {"from": "coat.normal"}}})");
    const Ran ran = export_graph();
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out, "README.txt\na.mtlx\ntextures/normal.png\n");
    ASSERT_EQ(import_export().code, 0);
    for (const OraclePoint& point : some_points()) {
        expect_same(point, "");
        expect_specified(point, "");
    }
}

TEST_F(MaterialXExport, InputsOfBakedOutputsAreFixed) {
    put("a.json", cells);
    ASSERT_EQ(export_graph().code, 0);
    EXPECT_TRUE(has(R"(<input name="tint" type="color3" value="0.2, 0.4, 0.8" uiname="Tint" )"
                    R"(uifolder="Paint")"))
        << exported();
    EXPECT_FALSE(has("scale"));
    EXPECT_TRUE(has(R"(<input name="specular_ior" type="float" value="3")"));
    EXPECT_NE(get("out/README.txt").find("Inputs of the node graph: tint."), std::string::npos);
}

}  // namespace
}  // namespace wrinkle::test
