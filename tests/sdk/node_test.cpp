// Tests of declarations: the contents of the descriptor, and the calls that a body makes through
// the C interface.
#include <gtest/gtest.h>

#include <stdexcept>

#include "sdk/recorder.h"
#include "wrinkle/node.h"

extern "C" const wr_plugin* plugin_in_c(void);

namespace wrinkle::testing {
namespace {

using namespace sdk;

// constinit: declaring a node must run no code, else lists could read nodes before their
// initialisation.
constinit Node scale = node("gradient_scale", "Scale", "Makes a bump stronger or weaker.")
                           .in<Gradient>("gradient", "The bump to scale")
                           .in<Float>("amount", 1, "Factor", slider(-2, 2), limits(-8, 8))
                           .out<Gradient>("gradient", "The scaled bump")
                           .body([](Gradient g, Float amount) { return g * amount; });

enum class Method { rnm, udn };
struct Everything {
    Float height;
    vec2 uv;
    Method method;
    int octaves;
    bool invert;
    Field<Float> relief;
    Image image;
};
constinit Node everything = node("everything", "Everything", "One port of each kind.")
                                .family("test")
                                .version(3)
                                .renamed(2, "old", "height")
                                .renamed(3, "relief_map", "relief")
                                .in<Height>("height", 0.5, "In metres", unit("m"))
                                .in<vec2>("uv", surface::uv1, "Where")
                                .choice("method", {"rnm", "udn"}, "How", 1)
                                .count("octaves", 4, 1, 8, "How many")
                                .flag("invert", true, "Which way")
                                .field<Float>("relief", surface::uv0, "The relief")
                                .out<Color>("color", "The color")
                                .in<Image>("image", "The picture", encoding("srgb"))
                                .out<Float>("count", "The count")
                                .body([](Everything in) {
                                    const vec4 texel = in.image.sample(in.uv);
                                    const Float read = in.relief(in.uv * in.height);
                                    const vec3 color =
                                        in.method == Method::udn ? texel.rgb() : vec3(read);
                                    return std::tuple{color, in.invert ? Float(in.octaves) : read};
                                });

constinit Node choosy =
    node("choosy", "Choosy", "Two choices.")
        .choice("first", {"a", "b", "c"}, "One")
        .in<Float>("x", {}, "A required number")
        .choice("second", {"d", "e"}, "Two")
        .out<Float>("y", "Out")
        .body([](int first, Float x, int second) { return first == 2 ? x : Float(second); });

constinit Node throwing = node("throwing", "Throwing", "Throws inside of a function.")
                              .flag("known", true, "Whether it is a std::exception")
                              .out<Float>("a", "Out")
                              .out<vec2>("b", "Out")
                              .body([](bool known) {
                                  function("f", [known](Float x) {
                                      if (known) throw std::runtime_error("no such thing");
                                      throw 42;
                                      return x;
                                  });
                                  return std::tuple{Float(0), vec2(0, 0)};
                              });

constinit Node failing =
    node("failing", "Failing", "Says so.").out<Float>("a", "Out").body([]() -> Float {
        fail("the width must not be 0");
        return Float(Raw{});
    });

constinit Node regions =
    node("regions", "Regions", "A function called twice, and a loop.")
        .in<Float>("x", 0, "In")
        .out<Float>("sum", "Out")
        .out<Float>("last", "Out")
        .body([](Float x) {
            const auto f = function("square", [](Float v) { return v * v; });
            const auto pair = function("pair", [](Float v, vec2 w) { return std::tuple{w, v}; });
            const auto [w, v] = pair(x, vec2(1, 2));
            const auto [t, h] = loop(8, std::tuple{x, v}, [&](Float a, Float b) {
                return std::tuple{a < b, a + x, f(b)};
            });
            return std::tuple{f(x) + f(w.x()), h};
        });

TEST(Descriptor, HoldsWhatWasDeclared) {
    const wr_node* n = scale.descriptor();
    EXPECT_EQ(n->size, sizeof(wr_node));
    EXPECT_STREQ(n->id, "gradient_scale");
    EXPECT_STREQ(n->title, "Scale");
    EXPECT_EQ(n->version, 1u);
    EXPECT_EQ(n->rename_count, 0u);
    ASSERT_EQ(n->port_count, 3u);
    const wr_port& amount = *n->ports[1];
    EXPECT_EQ(amount.size, sizeof(wr_port));
    EXPECT_EQ(amount.kind, WR_KIND_INPUT);
    EXPECT_EQ(amount.type, WR_PORT_float);
    EXPECT_STREQ(amount.doc, "Factor");
    EXPECT_EQ(amount.default_kind, WR_DEFAULT_CONSTANT);
    EXPECT_EQ(amount.default_value[0], 1);
    EXPECT_EQ(amount.soft_min, -2);
    EXPECT_EQ(amount.soft_max, 2);
    EXPECT_EQ(amount.hard_min, -8);
    EXPECT_EQ(amount.hard_max, 8);
    EXPECT_EQ(n->ports[0]->default_kind, WR_DEFAULT_NONE);
    EXPECT_EQ(n->ports[2]->kind, WR_KIND_OUTPUT);
    EXPECT_EQ(n->ports[2]->type, WR_PORT_gradient);
}

TEST(Descriptor, EveryKindOfPort) {
    const wr_node* n = everything.descriptor();
    ASSERT_EQ(n->port_count, 9u);
    const auto port = [n](uint32_t i) -> const wr_port& { return *n->ports[i]; };
    EXPECT_EQ(port(0).type, WR_PORT_height);
    EXPECT_STREQ(port(0).unit, "m");
    EXPECT_EQ(port(1).default_kind, WR_DEFAULT_SURFACE);
    EXPECT_EQ(port(1).default_surface, static_cast<uint32_t>(WR_SURFACE_uv1));
    EXPECT_EQ(port(2).kind, WR_KIND_CHOICE);
    ASSERT_EQ(port(2).choice_count, 2u);
    EXPECT_STREQ(port(2).choices[0], "rnm");
    EXPECT_STREQ(port(2).choices[1], "udn");
    EXPECT_EQ(port(2).default_value[0], 1);
    EXPECT_EQ(port(3).kind, WR_KIND_COUNT);
    EXPECT_EQ(port(3).default_value[0], 4);
    EXPECT_EQ(port(3).hard_max, 8);
    EXPECT_EQ(port(4).kind, WR_KIND_FLAG);
    EXPECT_EQ(port(4).default_value[0], 1);
    EXPECT_EQ(port(5).kind, WR_KIND_FIELD);
    EXPECT_EQ(port(5).default_surface, static_cast<uint32_t>(WR_SURFACE_uv0));
    EXPECT_EQ(port(6).type, WR_PORT_color);
    EXPECT_STREQ(port(7).encoding, "srgb");
    EXPECT_EQ(n->version, 3u);
    EXPECT_STREQ(n->family, "test");
    ASSERT_EQ(n->rename_count, 2u);
    EXPECT_EQ(n->renames[1]->version, 3u);
    EXPECT_STREQ(n->renames[1]->old_name, "relief_map");
    EXPECT_STREQ(n->renames[1]->new_name, "relief");
}

TEST(Descriptor, NamesOfSeveralChoicesStayApart) {
    const wr_node* n = choosy.descriptor();
    ASSERT_EQ(n->ports[0]->choice_count, 3u);
    EXPECT_STREQ(n->ports[0]->choices[2], "c");
    ASSERT_EQ(n->ports[2]->choice_count, 2u);
    EXPECT_STREQ(n->ports[2]->choices[0], "d");
    EXPECT_EQ(n->ports[1]->default_kind, WR_DEFAULT_NONE);
}

TEST(Body, RecordsItsFormula) {
    Recorder host;
    host.run(scale.descriptor());
    EXPECT_EQ(host.outputs[2], "gradient_scale(input:0, input:1)");
}

TEST(Body, TakesAStructAndGivesATuple) {
    Recorder host;
    host.options = {{2, 0}, {3, 5}, {4, 1}};
    host.run(everything.descriptor());
    EXPECT_EQ(host.outputs[8], "5");
    const std::string read = "field:5(mul(input:1, input:0))";
    EXPECT_EQ(host.outputs[6], "construct(" + read + ", " + read + ", " + read + ")");
}

TEST(Body, ChoicesAndFlagsAreBranchesWhileBuilding) {
    Recorder host;
    host.options = {{2, 1}, {3, 5}, {4, 0}};
    host.run(everything.descriptor());
    EXPECT_EQ(host.outputs[6], "swizzle[8451](sample:107(input:1))");  // 3 | 0<<4 | 1<<8 | 2<<12
    EXPECT_EQ(host.outputs[8], "field:5(mul(input:1, input:0))");
}

TEST(Body, ExceptionsBecomeErrorsAndPoison) {
    Recorder host;
    host.options = {{0, 1}};
    host.run(throwing.descriptor());
    EXPECT_EQ(host.errors, std::vector<std::string>{"no such thing"});
    EXPECT_EQ(host.outputs[1], "poison");
    EXPECT_EQ(host.outputs[2], "poison");
    EXPECT_EQ(host.open_regions, 0);
}

TEST(Body, WhatIsNoExceptionIsCaughtToo) {
    Recorder host;
    host.options = {{0, 0}};
    host.run(throwing.descriptor());
    ASSERT_EQ(host.errors.size(), 1u);
    EXPECT_EQ(host.outputs.size(), 2u);
    EXPECT_EQ(builder, nullptr);  // no state is left for the next body
}

TEST(Body, SaysWhatIsWrong) {
    Recorder host;
    host.run(failing.descriptor());
    EXPECT_EQ(host.errors, std::vector<std::string>{"the width must not be 0"});
    EXPECT_EQ(host.outputs[0], "poison");
}

TEST(Body, FunctionsAndLoopsAreRegions) {
    Recorder host;
    host.run(regions.descriptor());
    const std::string pair = "pair{p1, p0}(input:0, construct(1, 2))";
    EXPECT_EQ(
        host.outputs[1],
        "add(square{mul(p0, p0)}(input:0).0, square{mul(p0, p0)}(swizzle[1](" + pair + ".0)).0)");
    EXPECT_EQ(host.outputs[2],
              "loop{lt(p0, p1), add(p0, input:0), square{mul(p0, p0)}(p1).0}*8(input:0, " + pair +
                  ".1).1");
    EXPECT_EQ(host.open_regions, 0);
}

TEST(Body, GradientsSpeakOfFramesAndBases) {
    Recorder host;
    const UseBuilder use(&host.face);
    static constinit Node layered =
        node("layered", "Layered", "A bump on a base.")
            .in<vec2>("slope", 0, "In")
            .in<Normal>("base", surface::normal, "In")
            .out<Gradient>("g", "Out")
            .body([](vec2 slope, vec3 normal) {
                const Frame f = frame(surface::uv0, FrameMethod::guess, Scale::unit, vec3(0, 1, 0));
                return Gradient(Derivative(slope, f), Base(normal));
            });
    host.run(layered.descriptor());
    // The base is the third value: slope, normal, ... its number depends on the order of
    // evaluation.
    EXPECT_NE(host.outputs[2].find("gradient_from_derivative["), std::string::npos);
    EXPECT_NE(host.outputs[2].find("(derivative(input:0, frame[260](uv0, construct(0, 1, 0))))"),
              std::string::npos);
    EXPECT_EQ(builder, &host.face);  // a body restores the builder of the outer one
}

TEST(PluginTable, ListsNodesInOrder) {
    const Plugin plugin("test", "1.2", scale, choosy);
    const wr_plugin* p = plugin.descriptor();
    EXPECT_EQ(p->size, sizeof(wr_plugin));
    EXPECT_EQ(p->abi, WR_ABI);
    EXPECT_STREQ(p->version, "1.2");
    ASSERT_EQ(p->node_count, 2u);
    EXPECT_STREQ(p->nodes[1]->id, "choosy");
    EXPECT_EQ(p->get_extension("unknown/1"), nullptr);
}

TEST(PluginInC, WorksWithTheHeaderAlone) {
    const wr_plugin* p = plugin_in_c();
    ASSERT_EQ(p->node_count, 1u);
    Recorder host;
    host.run(p->nodes[0]);
    EXPECT_EQ(host.outputs[1], "mul(input:0, 2)");
}

}  // namespace
}  // namespace wrinkle::testing
