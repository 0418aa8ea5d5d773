// Tests of lowering graphs: parameters, wires, sub-graphs, muted nodes, fields, images.
#include "lower/lower.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>

#include "ir/inspect.h"
#include "lower/check.h"
#include "lower/fixture.h"

namespace wrinkle {
namespace {

using test::graph;
using test::lowered;
using test::value;

Lowered lowered(const std::string& text) {
    Diagnostics diagnostics;
    const Project project = test::project(text, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    return lowered(project);
}

Lowered lowered(const std::map<std::string, std::string>& files) {
    const test::Files written(files);
    Diagnostics diagnostics;
    const Project project = load_project(written.folder / "main.json", {}, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    return lowered(project);
}

// "bump.amount=1, strap/weave.scale=(1, 8)"
std::string parameters(const Module& module) {
    std::string text;
    for (const Parameter& p : module.parameters) {
        text += (text.empty() ? "" : ", ") + (p.graph_input ? "input" : module.nodes[p.node].path) +
                "." + p.port + "=";
        for (int i = 0; i < info(p.type).lanes; ++i)
            text += (i ? "," : "") + std::to_string(static_cast<int>(p.value[i] * 100));
    }
    return text;
}

TEST(Lower, UnconnectedNumbersAreParameters) {
    const Module m = lowered(graph(R"("v": {"type": "vector", "in": {"offset": [1, 2, 3]}})",
                                   R"("x": {"from": "v.scale"}, "y": {"from": "v.offset"},
                                      "color": {"from": "v.tint"})"))
                         .module;
    EXPECT_EQ(parameters(m), "v.scale=100,100, v.offset=100,200,300, v.tint=100,100,100");
    EXPECT_EQ(value(m).op, Op::parameter_);
    EXPECT_EQ(m.outputs[2].port_type, uint32_t{WR_PORT_color});
    ASSERT_EQ(m.named.size(), 3u);
    EXPECT_EQ(m.named[1].name, "offset");
}

TEST(Lower, OnlyWhatOutputsNeedIsBuilt) {
    const Module m = lowered(graph(R"("a": {"type": "number"}, "b": {"type": "number"})",
                                   R"("roughness": {"from": "b.value"})"))
                         .module;
    ASSERT_EQ(m.nodes.size(), 2u);
    EXPECT_EQ(m.nodes[1].path, "b");
    EXPECT_EQ(m.titles[m.nodes[1].title], "Number");
}

TEST(Lower, HardRangesClampLiteralsAndWires) {
    const Module m = lowered(graph(R"("v": {"type": "vector", "in": {"scale": [9, -1]}},
                                      "n": {"type": "number", "in": {"value": {"from": "surface.facing"}}})",
                                   R"("a": {"from": "v.scale"}, "b": {"from": "n.value"})"))
                         .module;
    EXPECT_EQ(parameters(m), "v.scale=800,0, v.offset=0,0,0, v.tint=100,100,100");
    const Inst& top = value(m, 1);
    EXPECT_EQ(top.op, Op::min_);
    EXPECT_EQ(m[top.arg[0]].op, Op::max_);
}

TEST(Lower, OptionsAreBaked) {
    const Module m = lowered(graph(R"("o": {"type": "options"}, "p": {"type": "options",
                                      "in": {"mode": "third", "octaves": 7, "tile": true}})",
                                   R"("a": {"from": "o.value"}, "b": {"from": "p.value"})"))
                         .module;
    EXPECT_TRUE(m.is_literal(m.outputs[0].value, 140));
    EXPECT_TRUE(m.is_literal(m.outputs[1].value, 271));
    EXPECT_EQ(parameters(m), "");
}

TEST(Lower, GraphInputsAreParametersOfTheGraph) {
    const Module m = lowered(graph(R"("s": {"type": "scale", "in": {"gradient": {"from": "input.h"},
                                                       "amount": {"from": "input.k"}}})",
                                   R"("normal": {"from": "s.gradient"})",
                                   R"("inputs": {"k": {"type": "float", "default": 0.25},
                                    "h": {"type": "height"}}, )"))
                         .module;
    EXPECT_EQ(parameters(m), "input.h=0, input.k=25");
    EXPECT_EQ(value(m).op, Op::resolve_);
    EXPECT_EQ(m.outputs[0].port_type, uint32_t{WR_PORT_normal});
}

TEST(Lower, StandardOutputsConvert) {
    const Module m =
        lowered(graph(R"("b": {"type": "bump", "in": {"height": {"from": "surface.facing"}}})",
                      R"("normal": {"from": "b.gradient"}, "mine": {"from": "b.gradient"},
                         "height": {"from": "surface.facing"})"))
            .module;
    EXPECT_EQ(value(m, 0).op, Op::resolve_);
    EXPECT_EQ(value(m, 1).op, Op::gradient_vector_);
    EXPECT_EQ(value(m, 2).op, Op::input_);
    EXPECT_EQ(m.outputs[2].port_type, uint32_t{WR_PORT_height});
}

TEST(Lower, SubgraphsAreInstancesWithPorts) {
    const Lowered result = lowered({
        {"main.json",
         graph(R"("left": {"type": "graph:sub/strap.json", "in": {"size": 0.75}},
                  "right": {"type": "graph:sub/strap.json"},
                  "both": {"type": "sum", "in": {"a": {"from": "left.bump"},
                                                 "b": {"from": "right.bump"}}})",
               R"("normal": {"from": "both.gradient"}, "height": {"from": "left.height"})")},
        {"sub/strap.json",
         graph(R"("n": {"type": "number", "in": {"value": {"from": "input.size"}}},
                  "weave": {"type": "graph:weave.json", "in": {"x": {"from": "n.value"}}})",
               R"("bump": {"from": "weave.g"}, "height": {"from": "n.value"})",
               R"("inputs": {"size": {"type": "float", "default": 0.5}}, )")},
        {"sub/weave.json",
         graph(R"("b": {"type": "bump", "in": {"height": {"from": "input.x"}}})",
               R"("g": {"from": "b.gradient"})", R"("inputs": {"x": {"type": "height"}}, )")},
    });
    const Module& m = result.module;
    std::vector<std::string> paths;
    for (const NodeInstance& node : m.nodes)
        paths.push_back(node.path);
    std::sort(paths.begin(), paths.end());
    EXPECT_EQ(paths,
              (std::vector<std::string>{"", "both", "left", "left/n", "left/weave", "left/weave/b",
                                        "right", "right/n", "right/weave", "right/weave/b"}));
    EXPECT_EQ(parameters(m), "left.size=75, right.size=50");
    EXPECT_EQ(value(m, 1).op, Op::min_) << "the inner node's hard range";
}

TEST(Lower, ASubgraphsStandardOutputConverts) {
    const Module m =
        lowered(
            {{"main.json",
              graph(R"("s": {"type": "graph:s.json"})", R"("mine": {"from": "s.normal"})")},
             {"s.json", graph(R"("b": {"type": "bump"})", R"("normal": {"from": "b.gradient"})")}})
            .module;
    EXPECT_EQ(m.outputs[0].port_type, uint32_t{WR_PORT_normal});
    EXPECT_EQ(value(m).op, Op::resolve_);
}

TEST(Lower, MutedNodesPassTheirFirstInputOfEachType) {
    const Module m =
        lowered(graph(R"("m": {"type": "many", "muted": true, "in": {"value": 5, "height": 6,
                                "gradient": {"from": "surface.normal"}}})",
                      R"("a": {"from": "m.value"}, "b": {"from": "m.height"},
                         "c": {"from": "m.normal"}, "d": {"from": "m.gradient"},
                         "e": {"from": "m.pair"})"))
            .module;
    EXPECT_EQ(parameters(m), "m.value=500, m.height=600");
    EXPECT_EQ(value(m, 0).op, Op::parameter_);
    EXPECT_EQ(value(m, 1).op, Op::parameter_);
    EXPECT_EQ(value(m, 2).op, Op::mul_) << "no input of type normal: the surface's";
    EXPECT_EQ(value(m, 3).op, Op::gradient_vector_);
    EXPECT_EQ(m[value(m, 3).arg[0]].op, Op::gradient_from_normal_);
    EXPECT_TRUE(m.is_literal(m.outputs[4].value, 0));
}

TEST(Lower, MutedNodesPassTheFirstConnectedInputBeforeAConstantOne) {
    const auto passed = [](const std::string& inputs) {
        const Module m = lowered(graph(R"("p": {"type": "bump"}, "q": {"type": "scale", "in":
                                {"gradient": {"from": "p.gradient"}}},
                             "s": {"type": "sum", "muted": true, "in": {)" +
                                           inputs + "}}",
                                       R"("p": {"from": "p.gradient"}, "q": {"from": "q.gradient"},
                             "s": {"from": "s.gradient"})"))
                             .module;
        const Id value = m.outputs[2].value;
        return value == m.outputs[0].value ? "p" : value == m.outputs[1].value ? "q" : "neither";
    };
    EXPECT_STREQ(passed(R"("a": {"from": "p.gradient"}, "b": {"from": "q.gradient"})"), "p");
    EXPECT_STREQ(passed(R"("a": {"from": "q.gradient"}, "b": {"from": "p.gradient"})"), "q");
    EXPECT_STREQ(passed(R"("b": {"from": "q.gradient"})"), "q");
    EXPECT_STREQ(passed(""), "neither");
}

TEST(Lower, BackFacesTurnTheNormalThatNodesSee) {
    const auto normal = [](const std::string& rule) {
        Module m = lowered(graph("", R"("normal": {"from": "surface.normal"})",
                                 "\"back_faces\": \"" + rule + "\", "))
                       .module;
        return value(m).op;
    };
    EXPECT_EQ(normal("mirror"), Op::mul_);
    EXPECT_EQ(normal("flip"), Op::mul_);
    EXPECT_EQ(normal("none"), Op::normalize_);
}

TEST(Lower, ReroutesHaveTheTypeOfTheirSource) {
    const Module m =
        lowered(
            graph(
                R"("b": {"type": "bump"}, "q": {"type": "reroute", "in": {"in": {"from": "r.out"}}},
                         "r": {"type": "reroute", "in": {"in": {"from": "b.gradient"}}})",
                R"("normal": {"from": "q.out"})"))
            .module;
    EXPECT_EQ(value(m).op, Op::resolve_);
}

TEST(Lower, AnUnconnectedFieldIsItsDefault) {
    const Module m =
        lowered(graph(R"("f": {"type": "field_at"})", R"("a": {"from": "f.value"})")).module;
    EXPECT_EQ(parameters(m), "f.shape=0");
    EXPECT_EQ(value(m).op, Op::parameter_);
}

TEST(Lower, AFieldMovesWhatDependsOnItsDomain) {
    const Module m =
        lowered({{"main.json", graph(R"("p": {"type": "texture", "in": {"image": "a.png"}},
                                        "f": {"type": "field_at", "in": {"shape": {"from": "p.alpha"}}})",
                                     R"("a": {"from": "f.value"})")},
                 {"a.png", "no pixel is read"}})
            .module;
    const Inst& component = value(m);
    ASSERT_EQ(component.op, Op::swizzle_);
    const Inst& sample = m[component.arg[0]];
    ASSERT_EQ(sample.op, Op::sample_);
    EXPECT_EQ(m[sample.arg[0]].op, Op::add_) << "at uv0 + (3, 5)";
    ASSERT_EQ(m.resources.size(), 1u);
    EXPECT_EQ(m.resources[0].name, "a.png");
    EXPECT_EQ(m.resources[0].options.encoding, Encoding::srgb);
    ASSERT_EQ(m.resources[0].readers.size(), 1u);
    EXPECT_EQ(m.nodes[m.resources[0].readers[0].node].path, "p");
    EXPECT_EQ(m.resources[0].readers[0].port, "image");
}

TEST(Lower, SamplesInALoopKeepTheFootprintOutside) {
    const Module m =
        lowered({{"main.json", graph(R"("p": {"type": "texture", "in": {"image": "a.png"}},
                                        "f": {"type": "march", "in": {"shape": {"from": "p.alpha"}}})",
                                     R"("a": {"from": "f.value"})")},
                 {"a.png", ""}})
            .module;
    int found = 0;
    for (Id id = 1; id < m.size(); ++id) {
        if (m[id].op != Op::sample_grad_) continue;
        ++found;
        EXPECT_GT(m[id].level, 0);
        EXPECT_EQ(m[m[id].arg[1]].op, Op::ddx_);
        EXPECT_EQ(m[m[m[id].arg[1]].arg[0]].op, Op::input_) << "the uv where it stood";
        EXPECT_EQ(m[m[id].arg[2]].op, Op::ddy_);
    }
    EXPECT_EQ(found, 1);
}

TEST(Lower, ChangesBetweenPixelsInALoopAreThoseOutside) {
    const Module m = lowered({{"main.json", graph(R"("w": {"type": "width"},
                                        "f": {"type": "march", "in": {"shape": {"from": "w.value"}}})",
                                                  R"("a": {"from": "f.value"})")}})
                         .module;
    int found = 0;
    for (Id id = 1; id < m.size(); ++id) {
        if (m[id].op != Op::ddx_) continue;
        ++found;
        EXPECT_EQ(m[id].level, 0);
    }
    EXPECT_EQ(found, 1);
}

TEST(Lower, ImagesMergeUnlessTheirOptionsDiffer) {
    const Module m =
        lowered(
            {{"main.json",
              graph(
                  R"("p": {"type": "texture", "in": {"image": "a.png"}},
                           "q": {"type": "texture", "in": {"image": {"file": "./a.png", "encoding": "srgb"}}},
                           "r": {"type": "texture", "in": {"image": {"file": "a.png", "wrap": "clamp",
                                                                     "filter": "nearest"}}})",
                  R"("a": {"from": "p.color"}, "b": {"from": "q.color"}, "c": {"from": "r.color"})")},
             {"a.png", ""}})
            .module;
    ASSERT_EQ(m.resources.size(), 2u);
    EXPECT_EQ(m.resources[0].readers.size(), 2u);
    EXPECT_EQ(m.resources[1].options.wrap, Wrap::clamp);
    EXPECT_EQ(m.resources[1].options.filter, Filter::nearest);
    EXPECT_EQ(m.outputs[0].value, m.outputs[1].value);
}

TEST(Lower, AnImageMayComeThroughASubgraphsInput) {
    const Module m =
        lowered({{"main.json", graph(R"("s": {"type": "graph:sub/s.json"},
                                                     "t": {"type": "graph:sub/s.json", "in": {"map": "top.png"}})",
                                     R"("a": {"from": "s.c"}, "b": {"from": "t.c"})")},
                 {"top.png", ""},
                 {"sub/inner.png", ""},
                 {"sub/s.json",
                  graph(R"("p": {"type": "texture", "in": {"image": {"from": "input.map"}}})",
                        R"("c": {"from": "p.color"})",
                        R"("inputs": {"map": {"type": "image", "default": "inner.png"}}, )")}})
            .module;
    ASSERT_EQ(m.resources.size(), 2u);
    EXPECT_EQ(m.resources[0].name, "inner.png");
    EXPECT_EQ(m.resources[1].name, "top.png") << "relative to the file that says it";
}

void* lower_a_long_chain(void*) {
    for (const char* type : {"scale", "reroute", "muted"}) {
        const bool reroute = std::string(type) == "reroute";
        const std::string in = reroute ? "in" : "gradient", out = reroute ? "out" : "gradient";
        std::string nodes = "\"n0\": {\"type\": \"bump\"}";
        std::string from = "n0.gradient";
        constexpr int length = 100000;
        for (int i = 1; i <= length; ++i) {
            const std::string id = "n" + std::to_string(i);
            nodes += ",\n\"" + id + "\": {\"type\": \"" + (reroute ? "reroute" : "scale") + "\"" +
                     (std::string(type) == "muted" ? ", \"muted\": true" : "") + ", \"in\": {\"" +
                     in + "\": {\"from\": \"" + from + "\"}}}";
            from = id + "." + out;
        }
        Diagnostics diagnostics;
        const Project project =
            test::project(graph(nodes, "\"normal\": {\"from\": \"" + from + "\"}"), diagnostics);
        MaterialOptions options;
        options.uniform_parameters = true;
        const Compiled compiled = compile_material(project, test::registry(), options, diagnostics);
        EXPECT_EQ(to_text(diagnostics), "");
        EXPECT_TRUE(compiled.ok);
    }
    return nullptr;
}

TEST(Lower, AChainOfAHundredThousandNodesNeedsNoStack) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, 256 * 1024);
    pthread_t thread;
    ASSERT_EQ(pthread_create(&thread, &attributes, lower_a_long_chain, nullptr), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
}

TEST(Lower, ManyNodesAreRefusedByALimit) {
    std::map<std::string, std::string> files;
    for (int i = 0; i < 12; ++i)
        files["g" + std::to_string(i) + ".json"] =
            graph("\"a\": {\"type\": \"graph:g" + std::to_string(i + 1) +
                      ".json\"}, \"b\": {\"type\": \"graph:g" + std::to_string(i + 1) +
                      ".json\"}, \"s\": {\"type\": \"sum\", \"in\": {\"a\": {\"from\": \"a.g\"}, "
                      "\"b\": {\"from\": \"b.g\"}}}",
                  R"("g": {"from": "s.gradient"})");
    files["g12.json"] = graph(R"("b": {"type": "bump"})", R"("g": {"from": "b.gradient"})");
    const test::Files written(files);
    Diagnostics diagnostics;
    const Project project = load_project(written.folder / "g0.json", {}, diagnostics);
    LowerOptions options;
    options.max_nodes = 1000;
    options.inline_up_to = 1'000'000;
    lower(project, Types(project, test::registry()), options, diagnostics);
    EXPECT_EQ(to_text(diagnostics),
              (written.folder / "g0.json").string() +
                  ": error: the graph needs more than 1000 nodes (each inlined use of a sub-graph "
                  "counts)\n");
}

}  // namespace
}  // namespace wrinkle
