// Tests of everyday tasks, with the most actions that each may take: a click, a drag, a drop, a key
// outside text, or a typed text. Layering.TakesThreeActionsByDropping has base and detail.
#include <fstream>

#include "editor/model/document/expose.h"
#include "editor/model/document/inputs.h"
#include "editor/model/document/knots.h"
#include "editor/model/document/request.h"
#include "headless.h"
#include "json/write.h"

namespace wrinkle::editor {
namespace {

using Tasks = Headless;

TEST_F(Tasks, ARampToFourStopsTakesFour) {
    open(R"({ "wrinkle": 1, "nodes": { "paint": { "type": "ramp" } },
              "outputs": { "color": { "from": "paint.color" } } })");
    play(R"(
        click field:paint.stops
        click ramp:strip
        click ramp:add
        key Escape
        assert actions 4)");
    EXPECT_EQ(stops_of(*state.document().find("paint"), *state.type_of("paint")).size(), 4U);
}

TEST_F(Tasks, AGroupUsedTwiceTakesThree) {
    open(small_graph);
    play(R"(
        click node:softer
        key Ctrl+G
        key Ctrl+D
        assert nodes 5
        assert errors 0
        assert actions 3)");
    EXPECT_EQ(state.document().find("group")->type, state.document().find("group2")->type);
}

TEST_F(Tasks, AGraphOfTheFolderUsedTwiceTakesFour) {
    folder.write("other.json", small_graph);
    open(small_graph);
    play(R"(
        key Space
        type other
        key Enter
        key Space
        type other
        key Enter
        assert nodes 6
        assert errors 0
        assert actions 4)");
}

TEST_F(Tasks, FiveInputsAndTwoPresetsTakeEight) {
    open(R"({ "wrinkle": 1, "nodes": { "noise": { "type": "fbm" } },
              "outputs": { "height": { "from": "noise.height" } } })");
    const auto values =
        exposable_ports(*state.document().find("noise"), *state.type_of("noise")).size();
    ASSERT_GE(values, 5U);
    play(R"(
        click node:noise
        key E
        key Enter
        click preset:save
        key Enter
        drag input:gain input:gain+20,0
        click preset:save
        key Enter
        assert errors 0
        assert actions 8)");
    EXPECT_EQ(state.document().inputs.size(), values);
    ASSERT_EQ(state.document().presets.size(), 2U);
    EXPECT_NE(json::one_line(value_of_input(state.document(), "preset 1",
                                            *state.document().inputs.find("gain"))),
              json::one_line(state.document().inputs.find("gain")->default_value));
}

TEST_F(Tasks, RustOverPaintWithAnEdgeMaskTakesTwelve) {
    open(R"({ "wrinkle": 1 })");
    play(R"(
        key Space
        type material
        key Enter
        key Space
        type material_mix
        key Enter
        drag pin:material_mix.b canvas+-240,200
        type material
        key Enter
        drag pin:material_mix.mask canvas+240,250
        type edge_wear
        key Enter
        drag pin:edge_wear.height canvas+0,280
        type fbm
        key Enter
        click field:material2.color.0
        click color+-80,0
        assert errors 0
        assert actions 12)");
    for (const Connection& wire : {Connection{{"material", "material"}, "material_mix", "a"},
                                   Connection{{"material2", "material"}, "material_mix", "b"},
                                   Connection{{"edge_wear", "edges"}, "material_mix", "mask"},
                                   Connection{{"fbm", "height"}, "edge_wear", "height"}})
        EXPECT_TRUE(state.layout.wire_to({wire.node, wire.port})) << wire.node << "." << wire.port;
    EXPECT_EQ(link_at(state.document(), "", "material"), (Link{"material_mix", "material"}));
    EXPECT_TRUE(state.document().find("material2")->find("color"));
}

TEST_F(Tasks, AMasksPixelsTakeTwo) {
    open(small_graph);
    play(R"(
        click node:noise
        key 7
        assert target flat
        assert actions 2)");
}

TEST_F(Tasks, AnotherMeshAndLightTakeTwo) {
    folder.write("ball.obj", "v 0 0 0\n");
    folder.write("sky.hdr", "none");
    open(small_graph);
    play("drop ball.obj preview\ndrop sky.hdr preview\nassert actions 2");
    EXPECT_TRUE(state.view.preview_view.mesh.ends_with("ball.obj"));
    EXPECT_TRUE(state.view.preview_view.environment.ends_with("sky.hdr"));
}

TEST_F(Tasks, AMeshAndALightAreBrowsedFor) {
    folder.write("ball.obj", "v 0 0 0\n");
    folder.write("sky.hdr", "none");
    open(small_graph);
    play("click preview:mesh\nclick preview:mesh:browse\ntype ball\nkey Enter");
    EXPECT_TRUE(state.view.preview_view.mesh.ends_with("ball.obj"));
    play("click preview:light\nclick light:browse\ntype sky\nkey Enter");
    EXPECT_TRUE(state.view.preview_view.environment.ends_with("sky.hdr"));
    play("click preview:mesh\nclick preview:mesh:torus");
    EXPECT_EQ(state.view.preview_view.mesh, "torus");
}

TEST_F(Tasks, ANaiveBlendBesideTakesOne) {
    open(R"({ "wrinkle": 1, "nodes": {
        "a": { "type": "tangent_normal_map" }, "b": { "type": "tangent_normal_map" },
        "sum": { "type": "gradient_add", "in": { "a": { "from": "a.gradient" },
                                                 "b": { "from": "b.gradient" } } } },
        "outputs": { "normal": { "from": "sum.gradient" } } })");
    play("click compare:split\nassert actions 1");
    EXPECT_EQ(state.view.compare.mode, CompareView::Mode::split);
    const Requested shown =
        requested_document(state.document(), state.model, state.view.preview_request);
    EXPECT_EQ(shown.replaced, 1U) << shown.why_not;
}

TEST_F(Tasks, AnExportForThreeTakesTwo) {
    open(small_graph);
    play("key Ctrl+Shift+E\ndouble host:to:three\nfinish\nassert actions 2");
    const std::filesystem::path page = folder.path() / "graph_three/index.html";
    ASSERT_TRUE(std::filesystem::remove(page));
    play("key Ctrl+Shift+E\nkey Enter\nfinish\nassert actions 4");
    EXPECT_TRUE(std::filesystem::exists(page));
}

}  // namespace
}  // namespace wrinkle::editor
