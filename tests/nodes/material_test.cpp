// Tests of materials on wires: a layer of a material is a layer of each channel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "base/standard_outputs.h"
#include "emit/emit.h"
#include "graph/subgraph.h"
#include "ir/cost.h"
#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

const std::string sources = R"(
    "maps": {"type": "tangent_normal_map", "in": {"image": "textures/weave_normal.png"}},
    "dots": {"type": "domes", "in": {"uv": {"from": "surface.uv1"}, "scale": 8}},
    "mask": {"type": "gradient_noise", "in": {"scale": 3, "amplitude": 1}})";

Compiled compiled(const std::string& nodes, const std::string& outputs) {
    Diagnostics diagnostics;
    const std::string text =
        R"({"wrinkle": 1, "nodes": {)" + nodes + R"(}, "outputs": {)" + outputs + "}}";
    const Project project = load_project(read_document(text, "test.json", diagnostics),
                                         WRINKLE_SOURCE_DIR "/graphs", {}, diagnostics);
    MaterialOptions options;
    Compiled made = compile_material(project, registry(), options, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    return made;
}

std::vector<std::string> output_names(const Compiled& made) {
    std::vector<std::string> names;
    for (const ModuleOutput& output : made.module.outputs)
        names.push_back(output.name);
    return names;
}

// The shader without comments and spaces, its words numbered in the order of their first use.
std::string shape_of(const Compiled& made) {
    EmitOptions options;
    options.name = "m";
    const std::string text = emit(made.module, options).source;
    const auto in_word = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    std::map<std::string, size_t> number;
    std::string shape;
    for (size_t i = 0; i < text.size();) {
        if (text.compare(i, 2, "//") == 0) {
            i = text.find('\n', i);
        } else if (!in_word(text[i])) {
            if (!std::isspace(static_cast<unsigned char>(text[i]))) shape += text[i];
            ++i;
        } else {
            const size_t end =
                static_cast<size_t>(std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(i),
                                                     text.end(), in_word) -
                                    text.begin());
            const std::string word = text.substr(i, end - i);
            const bool literal = std::isdigit(static_cast<unsigned char>(word[0])) != 0;
            shape +=
                " " +
                (literal ? word
                         : "w" + std::to_string(number.emplace(word, number.size()).first->second));
            i = end;
        }
    }
    return shape;
}

uint64_t operations_of(const Compiled& made) {
    uint64_t sum = 0;
    for (const Cost& cost : cost_by_node(made.module))
        sum += cost.ops;
    return sum;
}

const std::string two_layers = sources + R"(,
    "iron": {"type": "material", "in": {"normal": {"from": "maps.gradient"},
        "color": [0.5, 0.4, 0.3], "roughness": 0.5, "metalness": 1}},
    "paint": {"type": "material", "in": {"normal": {"from": "dots.height"},
        "color": [0.8, 0.1, 0.1], "roughness": 0.25}},
    "layers": {"type": "material_mix", "in": {"a": {"from": "iron.material"},
        "b": {"from": "paint.material"}, "mask": {"from": "mask.height"}}})";

const std::string by_hand = sources + R"(,
    "bump": {"type": "gradient_mix", "in": {"a": {"from": "maps.gradient"},
        "b": {"from": "dots.height"}, "mask": {"from": "mask.height"}}},
    "color": {"type": "vec3_mix", "in": {"a": [0.5, 0.4, 0.3], "b": [0.8, 0.1, 0.1],
        "mask": {"from": "mask.height"}}},
    "roughness": {"type": "mix", "in": {"a": 0.5, "b": 0.25, "mask": {"from": "mask.height"}}},
    "metalness": {"type": "mix", "in": {"a": 1, "b": 0, "mask": {"from": "mask.height"}}})";

TEST(Materials, OneWithoutChannelsHasItsColor) {
    const Compiled made =
        compiled(R"("m": {"type": "material"})", R"("material": {"from": "m.material"})");
    ASSERT_EQ(output_names(made), std::vector<std::string>{"color"});
    for (size_t lane = 0; lane < 3; ++lane)
        EXPECT_EQ(made.module.lanes_of(made.module.outputs[0].value)[lane], 0.8);
}

TEST(Materials, AreLayersOfTheirChannels) {
    const Compiled whole = compiled(two_layers, R"("material": {"from": "layers.material"})");
    const Compiled parts =
        compiled(by_hand, R"("normal": {"from": "bump.gradient"}, "color": {"from": "color.vector"},
            "roughness": {"from": "roughness.result"}, "metalness": {"from": "metalness.result"})");
    ASSERT_TRUE(whole.ok && parts.ok);
    EXPECT_EQ(output_names(whole),
              (std::vector<std::string>{"normal", "color", "roughness", "metalness"}));
    EXPECT_EQ(shape_of(whole), shape_of(parts));
    EXPECT_EQ(operations_of(whole), operations_of(parts));
}

TEST(Materials, AreTheOneOrTheOtherAtTheEndsOfTheMask) {
    for (const auto& [mask, material] : {std::pair{"0", "iron"}, std::pair{"1", "paint"}})
        for (const std::string channel : {"normal", "color", "roughness", "metalness"}) {
            const auto split = [&](const std::string& from, const std::string& output) {
                return R"(, ")" + output + R"(": {"type": "material_split", "in": {"material":
                    {"from": ")" +
                       from + R"(.material"}}})";
            };
            const std::string nodes = two_layers + R"(, "end": {"type": "material_mix", "in": {
                "a": {"from": "iron.material"}, "b": {"from": "paint.material"}, "mask": )" +
                                      mask + "}}" + split("end", "mixed") + split(material, "own");
            EXPECT_EQ(value({nodes, "mixed." + channel}), value({nodes, "own." + channel}))
                << mask << " " << channel;
        }
}

// A material with a number in every channel; its tangents are an axis, a unit vector.
std::string full_material(const std::string& id, double first, const std::string& axis) {
    std::string in;
    double number = first;
    for (const StandardOutput& output : standard_output_table) {
        const std::string_view type = channel_type(output);
        if (type == "gradient") continue;
        number += 0.013;
        const std::string one = std::to_string(number);
        in += (in.empty() ? "\"" : ", \"") + std::string(output.name) + "\": ";
        if (type == "vec3")
            in += axis;
        else if (type == "color")
            in += "[" + one + ", " + std::to_string(1 - number) + ", " + one + "]";
        else
            in += one;
    }
    const std::string bump = std::to_string(first), made = "\"" + id;
    return made + R"(_bump": {"type": "gradient_from_volume", "in": {"volume": [)" + bump + ", " +
           bump + R"(, 0]}}, )" + made + R"(": {"type": "material", "in": {"normal": {"from": ")" +
           id + R"(_bump.gradient"}, "coat_normal": {"from": ")" + id + R"(_bump.gradient"}, )" +
           in + "}}, ";
}
std::string split_material(const std::string& id, const std::string& from) {
    return "\"" + id + R"(": {"type": "material_split", "in": {"material": {"from": ")" + from +
           R"("}}})";
}

// Every channel of these nodes at one point.
std::vector<std::vector<double>> channels_of(const std::string& nodes, const std::string& split) {
    const Scene scene{nodes, ""};
    std::vector<std::string> outputs;
    for (const StandardOutput& output : standard_output_table)
        outputs.push_back(split + "." + std::string(output.name));
    std::vector<std::vector<double>> all;
    for (const auto& points : values(scene, outputs, plane_points(scene, {{0.3, 0.6}})))
        all.push_back(points.at(0));
    return all;
}

// Also where a channel is absent in one of them: the default is mixed.
TEST(Materials, AreTheOneOrTheOtherInEveryChannel) {
    const std::string both = full_material("a", 0.05, "[0, 1, 0]") +
                             full_material("b", 0.3, "[0, 0, 1]") +
                             R"("bare": {"type": "material", "in": {}}, )";
    const auto own = [&](const std::string& id) {
        return channels_of(both + split_material("s", id + ".material"), "s");
    };
    const auto mixed = [&](const std::string& a, const std::string& b, const std::string& mask) {
        return channels_of(both + R"("m": {"type": "material_mix", "in": {"a": {"from": ")" + a +
                               R"(.material"}, "b": {"from": ")" + b + R"(.material"}, "mask": )" +
                               mask + "}}, " + split_material("s", "m.material"),
                           "s");
    };
    for (const auto& [a, b] : {std::pair{"a", "b"}, {"a", "bare"}, {"bare", "b"}}) {
        EXPECT_EQ(mixed(a, b, "0"), own(a)) << a << b;
        EXPECT_EQ(mixed(a, b, "1"), own(b)) << a << b;
        const auto there = mixed(a, b, "0.3"), back = mixed(b, a, "0.7");
        for (size_t k = 0; k < there.size(); ++k)
            for (size_t lane = 0; lane < there[k].size(); ++lane)
                EXPECT_NEAR(there[k][lane], back[k][lane], 1e-6)
                    << standard_output_table[k].name << a << b;
        EXPECT_NE(there, own(a));
    }
}

// Three bumps added by nodes, in each order and grouping.
TEST(Materials, AddedBumpsMayChangePlaces) {
    const std::string bumps =
        R"("a": {"type": "gradient_from_height", "in": {"height": {"from": "w.height"}}},
           "w": {"type": "waves", "in": {"amplitude": 0.1}},
           "b": {"type": "gradient_from_tangent_normal", "in": {"normal": [0.3, -0.2, 0.8]}},
           "c": {"type": "gradient_from_volume", "in": {"volume": [0.7, -0.4, 0.1]}}, )";
    std::array<std::string, 3> order{"a", "b", "c"};
    std::vector<std::vector<double>> all;
    const auto link = [](const std::string& id) { return R"({"from": ")" + id + R"(.gradient"})"; };
    do {
        const std::string sum =
            R"("ab": {"type": "gradient_add", "in": {"a": )" + link(order[0]) + R"(, "b": )" +
            link(order[1]) + R"(}}, "sum": {"type": "gradient_add", "in": {"a": )" + link("ab") +
            R"(, "b": )" + link(order[2]) + R"(}}, "r": {"type": "resolve", "in": {"gradient": )" +
            link("sum") + "}}";
        all.push_back(value({bumps + sum, "r.normal"}));
    } while (std::next_permutation(order.begin(), order.end()));
    ASSERT_EQ(all.size(), 6U);
    for (const auto& normal : all)
        for (size_t lane = 0; lane < 3; ++lane)
            EXPECT_NEAR(normal[lane], all[0][lane], 1e-6);
}

TEST(Materials, HaveTheDefaultsOfTheTable) {
    const auto split = [](const std::string& channel, const std::string& in) {
        return value({R"("m": {"type": "material", "in": {)" + in + R"(}},
            "n": {"type": "material_split", "in": {"material": {"from": "m.material"}}})",
                      "n." + channel});
    };
    EXPECT_EQ(split("roughness", ""), std::vector<double>{0.3});
    EXPECT_EQ(split("coat_ior", R"("coat_weight": 1)"), std::vector<double>{1.6});
    EXPECT_EQ(split("emission_luminance", ""), std::vector<double>{0});
    EXPECT_EQ(split("emission_luminance", R"("emission": [1, 0, 0])"), std::vector<double>{100});
    EXPECT_EQ(split("normal", ""), (std::vector<double>{0, 0, 0}));
    EXPECT_EQ(split("tangent", ""), (std::vector<double>{1, 0, 0}));
}

// Opacity 0.5 over opacity 0.5: three quarters are covered, two thirds of that by the upper one.
TEST(Materials, CoverByTheirOpacity) {
    const std::string nodes = R"(
        "low": {"type": "material", "in": {"roughness": 0, "opacity": 0.5}},
        "high": {"type": "material", "in": {"roughness": 0.6, "opacity": 0.5}},
        "over": {"type": "material_over", "in": {"base": {"from": "low.material"},
                 "top": {"from": "high.material"}}},
        "n": {"type": "material_split", "in": {"material": {"from": "over.material"}}})";
    EXPECT_NEAR(value({nodes, "n.roughness"})[0], 0.4, 1e-6);
    EXPECT_NEAR(value({nodes, "n.opacity"})[0], 0.75, 1e-6);
}

// The figures of reference: heights of the two, amount, mask.
TEST(Materials, AreLayeredByHeight) {
    constexpr double cases[][4] = {{0.6, 0.3, 0.5, 0},
                                   {0.6, 0.5, 0.5, 1.0 / 3},
                                   {0.4, 0.5, 0.5, 2.0 / 3},
                                   {0.6, 0.3, 0.6, 1.0 / 3}};
    for (const auto& [low, high, amount, mask] : cases) {
        const std::string nodes = R"(
            "low": {"type": "material", "in": {"height": )" +
                                  std::to_string(low) + R"(}},
            "high": {"type": "material", "in": {"height": )" +
                                  std::to_string(high) + R"(}},
            "n": {"type": "material_layer", "in": {"base": {"from": "low.material"}, "range": 1,
                 "top": {"from": "high.material"}, "amount": )" +
                                  std::to_string(amount) + "}}";
        EXPECT_NEAR(value({nodes, "n.mask"})[0], mask, 1e-5);
    }
}

TEST(Materials, KeepTheOutputsThatTheGraphWrites) {
    const Compiled made = compiled(two_layers, R"("material": {"from": "layers.material"},
        "specular_roughness": {"from": "mask.height"}, "mine": {"from": "mask.height"})");
    EXPECT_EQ(output_names(made),
              (std::vector<std::string>{"normal", "color", "metalness", "roughness", "mine"}));
}

TEST(Materials, AreOutputsOfOneNameOnly) {
    EXPECT_EQ(problems(two_layers, "layers.material"),
              "test.json:10:99: error: output 'value' is a material (name it 'material'; each of "
              "its channels is then an output)\n");
}

}  // namespace
}  // namespace wrinkle::test
