// Tests of node previews: expected texels are computed by hand for a flat patch.
#include "editor/view/preview/node_previews.h"

#include <gtest/gtest.h>

#include <cmath>

#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"
#include "graph/read.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

NodePreviews pictures_of(const std::string& nodes, const std::filesystem::path& folder = ".") {
    Diagnostics problems;
    NodePreviewJob job;
    job.version = 7;
    job.document = read_document(R"({ "wrinkle": 1, "nodes": {)" + nodes + R"(}, "outputs": {} })",
                                 "graph.json", problems);
    for (const NodePtr& node : job.document.nodes)
        job.nodes.insert(node->id);
    job.model = make_model(job.document, folder, built_in_registry());
    return NodePainter()(job);
}

struct Texel {
    int r = -1, g = -1, b = -1, a = -1;
};

Texel texel_of(const NodePreviews& pictures, const std::string& node, uint32_t x, uint32_t y) {
    const auto place = pictures.places.find(node);
    if (place == pictures.places.end()) return {};
    const size_t at =
        4 * ((size_t{place->second} * NodePreviews::height + y) * NodePreviews::width + x);
    if (at + 4 > pictures.texels.size()) return {};
    const uint8_t* t = pictures.texels.data() + at;
    return {t[0], t[1], t[2], t[3]};
}

void expect_texel(Texel texel, int r, int g, int b) {
    EXPECT_NEAR(texel.r, r, 1);
    EXPECT_NEAR(texel.g, g, 1);
    EXPECT_NEAR(texel.b, b, 1);
    EXPECT_EQ(texel.a, 255);
}

constexpr const char* ramp = R"(
"split": { "type": "separate_vec2", "in": { "vector": { "from": "surface.uv0" } } },
"half": { "type": "multiply", "in": { "a": { "from": "split.x" }, "b": 0.5 } },
"hill": { "type": "height_scale", "in": { "height": { "from": "half.result" } } },
"bump": { "type": "gradient_from_height", "in": { "height": { "from": "hill.height" } } },
"normal": { "type": "resolve", "in": { "gradient": { "from": "bump.gradient" } } })";

TEST(NodePreviews, AHeightIsGrayOverItsRange) {
    const NodePreviews pictures = pictures_of(ramp);
    EXPECT_EQ(pictures.version, 7U);
    expect_texel(texel_of(pictures, "hill", 0, 20), 0, 0, 0);
    expect_texel(texel_of(pictures, "hill", NodePreviews::width - 1, 20), 255, 255, 255);
    const int middle = static_cast<int>(std::lround(64.0 / 127 * 255));
    expect_texel(texel_of(pictures, "half", 64, 3), middle, middle, middle);
}

TEST(NodePreviews, ASlopeIsTheColorOfItsNormal) {
    // h = u / 2 over a patch with u = x: the normal is (-1, 0, 2) / sqrt 5.
    const NodePreviews pictures = pictures_of(ramp);
    const auto shown = [](double v) { return static_cast<int>(std::lround(127.5 + 127.5 * v)); };
    const int r = shown(-1 / std::sqrt(5.0)), b = shown(2 / std::sqrt(5.0));
    for (const char* node : {"bump", "normal"})
        expect_texel(texel_of(pictures, node, 50, 40), r, shown(0), b);
}

TEST(NodePreviews, EveryNodeThatMakesSomethingHasOne) {
    const NodePreviews pictures = pictures_of(ramp);
    EXPECT_EQ(pictures.places.size(), 5U);
    EXPECT_EQ(pictures.texels.size(), 5U * 4 * NodePreviews::width * NodePreviews::height);
}

TEST(NodePreviews, AFineBumpIsMagnified) {
    const TemporaryFolder folder;
    const std::filesystem::path weave =
        std::filesystem::path(WRINKLE_SOURCE_DIR) / "graphs/textures/weave_normal.png";
    std::filesystem::copy_file(weave, folder.path() / "weave.png");
    const auto woven = [&](const std::string& tiles) {
        return pictures_of(R"(
"tile": { "type": "uv_transform", "in": { "scale": )" +
                               tiles + R"( } },
"weave": { "type": "tangent_normal_map", "in": { "image": "weave.png", "uv": { "from": "tile.uv" } } },
"level": { "type": "add", "in": { "a": 0.25, "b": 0.25 } })",
                           folder.path());
    };
    const NodePreviews coarse = woven("[1, 1]"), fine = woven("[8, 8]");
    EXPECT_TRUE(coarse.magnified.empty());
    EXPECT_EQ(fine.magnified, (std::set<std::string, std::less<>>{"weave"}));
    for (const uint32_t x : {3U, 50U, 100U}) {
        const Texel texel = texel_of(coarse, "weave", x, 20);  // one tile is one unit in both
        expect_texel(texel_of(fine, "weave", x, 20), texel.r, texel.g, texel.b);
    }
}

TEST(NodePreviews, WhatIsNotFiniteIsMagenta) {
    const NodePreviews pictures = pictures_of(std::string(ramp) + R"(,
"large": { "type": "multiply", "in": { "a": { "from": "split.x" }, "b": 3e38 } },
"infinite": { "type": "multiply", "in": { "a": { "from": "large.result" }, "b": 3e38 } })");
    expect_texel(texel_of(pictures, "infinite", 5, 5), 255, 0, 255);
}

TEST(NodePreviews, ABrokenGraphHasNone) {
    EXPECT_TRUE(pictures_of(R"("a": { "type": "no_such_node" })").places.empty());
    EXPECT_TRUE(pictures_of("").places.empty());
    EXPECT_TRUE(pictures_of(R"(
"a": { "type": "sine", "in": { "angle": { "from": "b.result" } } },
"b": { "type": "sine", "in": { "angle": { "from": "a.result" } } })")
                    .places.empty());
}

TEST(NodePreviews, ANodeThatDependsOnNothingBrokenHasAThumbnail) {
    const NodePreviews whole = pictures_of(ramp);
    const NodePreviews pictures = pictures_of(std::string(ramp) + R"(,
"unknown": { "type": "no_such_node" },
"after": { "type": "sine", "in": { "angle": { "from": "unknown.value" } } },
"lost": { "type": "height_map", "in": { "image": "not_there.png" } },
"a": { "type": "sine", "in": { "angle": { "from": "b.result" } } },
"b": { "type": "sine", "in": { "angle": { "from": "a.result" } } })");
    EXPECT_EQ(pictures.places.size(), whole.places.size());
    for (const auto& [node, place] : whole.places)
        for (const uint32_t x : {0U, 50U, 127U}) {
            const Texel texel = texel_of(whole, node, x, 20);
            expect_texel(texel_of(pictures, node, x, 20), texel.r, texel.g, texel.b);
        }
}

class WithThumbnails : public Headless {
protected:
    void SetUp() override { state.node_feed.maker = &maker_; }
    void TearDown() override { state.node_feed.maker = nullptr; }
    void make() {
        frame();
        maker_.wait_idle();
        frame();
    }

private:
    NodePreviewMaker maker_{NodePainter()};
};

TEST_F(WithThumbnails, ThumbnailsAreMadeBeforeThereIsAnOutput) {
    open(R"({ "wrinkle": 1, "nodes": { "noise": { "type": "gradient_noise" } } })");
    make();
    EXPECT_TRUE(state.node_feed.previews.places.contains("noise"));
}

TEST_F(WithThumbnails, ThumbnailsOfTheFormerGraphAreForgotten) {
    open(small_graph);
    make();
    EXPECT_EQ(state.node_feed.previews.places.size(), 2U);
    open(R"({ "wrinkle": 1, "nodes": { "normal": { "type": "no_such_node" } } })");
    EXPECT_TRUE(state.node_feed.previews.places.empty());
    make();
    EXPECT_TRUE(state.node_feed.previews.places.empty());
}

TEST_F(WithThumbnails, APreviewIsEnlargedAtThePointer) {
    open(small_graph);
    make();
    const Card& card = *state.layout.find("noise");
    const ImVec2 middle = to_screen(
        state.view, card.at + ImVec2(card.size.x / 2, card.preview_y + node_preview_height / 2));
    const auto rest_at = [&](ImVec2 at) {
        queue.motion(at.x - 2, at.y);
        frame();
        queue.motion(at.x, at.y);
        for (int i = 0; i < 70; ++i)
            frame();
    };
    rest_at(middle);
    EXPECT_TRUE(state.targets.find("tip:noise"));
    const auto shown = state.targets.find("tip:preview");
    ASSERT_TRUE(shown);
    EXPECT_GT(shown->x1 - shown->x0, 2 * NodePreviews::width);
    rest_at(to_screen(state.view, card.at + ImVec2(card.size.x / 2, 10)));
    EXPECT_TRUE(state.targets.find("tip:gradient_noise"));
    EXPECT_TRUE(state.targets.find("tip:preview"));
}

TEST_F(Headless, ThePictureOfAMapIsTheMap) {
    const std::string name = texture("rivets_normal.png");
    const NodePreviews pictures = pictures_of(
        R"("map": { "type": "image", "in": { "image": ")" + name + R"(" } })", folder.path());
    ASSERT_TRUE(pictures.places.contains("map"));
    size_t other = 0;
    const Texel first = texel_of(pictures, "map", 0, 0);
    for (uint32_t x = 0; x < NodePreviews::width; ++x)
        other += texel_of(pictures, "map", x, 32).r != first.r;
    EXPECT_GT(other, 10U);
}

// Returns the y offset of the preview on the node's card; negative if there is none.
float picture_of(const State& state, const std::string& node) {
    const Card* card = state.layout.find(node);
    return card ? card->preview_y : -2;
}

TEST_F(Headless, ACardShowsWhatItMakesWhereThatIsAnotherKindOfThing) {
    open(small_graph);
    play("click node:softer");
    EXPECT_GT(picture_of(state, "noise"), 0);   // a height from a point
    EXPECT_GT(picture_of(state, "normal"), 0);  // a normal from a gradient
    EXPECT_LT(picture_of(state, "softer"), 0);  // a gradient from a gradient
    const float height = state.layout.find("softer")->size.y;
    play("key V");
    EXPECT_GT(picture_of(state, "softer"), 0);
    EXPECT_GT(state.layout.find("softer")->size.y, height + node_preview_height);
    play("key V");
    EXPECT_LT(picture_of(state, "softer"), 0);
    play("key Shift+V");
    EXPECT_LT(picture_of(state, "noise"), 0);
    EXPECT_FALSE(state.dirty());
}

TEST_F(Headless, PicturesFollowWhatChangesThemAndNothingElse) {
    open(small_graph);
    NodePreviewMaker maker{NodePainter()};
    state.node_feed.maker = &maker;
    const auto newest = [&] {
        frame();
        maker.wait_idle();
        frame();
        return state.node_feed.previews;
    };
    const NodePreviews first = newest();
    EXPECT_EQ(first.places.size(), 2U);
    play("drag node:noise node:noise+0,120");
    EXPECT_EQ(newest().version, first.version) << "moving made them anew";
    play("double field:noise.scale\ntype 9\nkey Enter");
    const NodePreviews second = newest();
    EXPECT_GT(second.version, first.version);
    EXPECT_NE(second.texels, first.texels);
    play("double field:noise.scale\ntype 0/0\nkey Enter\nkey Escape");
    play("drag pin:normal.gradient canvas+0,330\nkey Escape");
    EXPECT_EQ(newest().places.size(), 2U);
}

}  // namespace
}  // namespace wrinkle::editor
