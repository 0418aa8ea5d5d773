// Tests of the 2D view: values by hand, and the panel by the pointer.
#include "editor/view/preview/flat.h"

#include <gtest/gtest.h>

#include <cmath>

#include "graph/read.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

// half = u / 2; bump is its slope as a height; painted is (u, 0.25, 1) as a color.
const char* const halves = R"({"wrinkle": 1, "inputs": {
        "level": {"type": "float", "default": 0.25}},
    "presets": {"High": {"level": 0.75}},
    "nodes": {
        "split": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
        "half": {"type": "multiply", "in": {"a": {"from": "split.x"}, "b": 0.5}},
        "level": {"type": "add", "in": {"a": {"from": "input.level"}}},
        "hill": {"type": "height_scale", "in": {"height": {"from": "half.result"}}},
        "bump": {"type": "gradient_from_height", "in": {"height": {"from": "hill.height"}}}},
    "outputs": {"normal": {"from": "bump.gradient"}, "height": {"from": "level.result"}},
    "layout": {"split": [0, 0], "half": [260, 0], "level": [260, 300], "hill": [520, 0],
        "bump": [780, 0]}})";

FlatImage image_of(const std::string& node, const FlatArea& area, int channel = -1,
                   bool fits_range = true, const std::string& preset = "") {
    FlatJob job;
    job.version = 3;
    job.document = parsed(halves);
    job.model = make_model(job.document, ".", built_in_registry());
    job.node = node;
    job.area = area;
    job.channel = channel;
    job.fits_range = fits_range;
    job.preset = preset;
    return FlatPainter()(job);
}

constexpr FlatArea unit{0, 0, 1.0 / 16, 16, 16};

TEST(FlatImages, HoldTheValuesAtTheCentersOfTexels) {
    const FlatImage image = image_of("half", unit);
    EXPECT_EQ(image.version, 3U);
    ASSERT_EQ(image.values.values.size(), 256U);
    for (const double u : {0.01, 0.4, 0.99}) {
        const double center = (std::floor(u * 16) + 0.5) / 16;
        EXPECT_NEAR((*values_at(image, u, 0.5))[0], center / 2, 1e-6) << u;
    }
    EXPECT_FALSE(values_at(image, -0.01, 0.5) || values_at(image, 0.5, 1.01));
}

TEST(FlatImages, CountTheVisibleValues) {
    const FlatImage image = image_of("half", unit);
    EXPECT_NEAR(image.range.least, 0.5 / 32, 1e-6);
    EXPECT_NEAR(image.range.most, 15.5 / 32, 1e-6);
    EXPECT_NEAR(image.mean, 0.25, 1e-6);
    uint32_t sum = 0;
    for (const uint32_t count : image.histogram)
        sum += count;
    EXPECT_EQ(sum, 256U);
    EXPECT_EQ(image.histogram.front(), 16U) << "one column of 16 texels";
}

TEST(FlatImages, OtherTilesAreEvaluatedAndNotRepeated) {
    const FlatImage image = image_of("half", {2, -1, 1.0 / 16, 16, 16});
    EXPECT_NEAR((*values_at(image, 2.5, -0.5))[0], (2.5 + 1.0 / 32) / 2, 1e-6);
}

TEST(FlatImages, GrayIsOverTheRangeOrFromZeroToOne) {
    const auto red = [](const FlatImage& image, size_t x) { return int{image.texels[x * 4]}; };
    const FlatImage over_range = image_of("half", unit);
    EXPECT_EQ(red(over_range, 0), 0);
    EXPECT_EQ(red(over_range, 15), 255);
    const FlatImage fixed = image_of("half", unit, -1, false);
    EXPECT_NEAR(red(fixed, 0), 255 * 0.5 / 32, 1);
    EXPECT_NEAR(red(fixed, 15), 255 * 15.5 / 32, 1);
}

TEST(FlatImages, AChannelIsGray) {
    // The gradient of u / 2 over a plane with position = uv is (0.5, 0, 0).
    const FlatImage image = image_of("bump", unit, 0, false);
    EXPECT_EQ(image.values.lanes, 3U);
    EXPECT_NEAR((*values_at(image, 0.5, 0.5))[0], 0.5, 1e-5);
    EXPECT_NEAR(image.mean, 0.5, 1e-5) << "of the channel only";
    for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(int{image.texels[c]}, 127.5, 1);
}

TEST(FlatImages, UsesThePresetThatIsShown) {
    EXPECT_NEAR((*values_at(image_of("level", unit), 0.5, 0.5))[0], 0.25, 1e-6);
    EXPECT_NEAR((*values_at(image_of("level", unit, -1, true, "High"), 0.5, 0.5))[0], 0.75, 1e-6);
}

TEST(FlatImages, AMissingNodeHasNoValues) {
    const FlatImage image = image_of("missing", unit);
    EXPECT_EQ(image.values.node, "");
    EXPECT_FALSE(values_at(image, 0.5, 0.5));
}

TEST(FlatAreas, HaveSquareTexelsAndALimit) {
    const FlatArea small = area_of({}, 300, 200);
    EXPECT_EQ(small.width, 300U);
    EXPECT_NEAR(small.texel * 200, FlatView().span, 1e-9);
    EXPECT_NEAR(small.u + small.texel * 150, 0.5, 1e-9);
    const FlatArea large = area_of({}, 3000, 2000);
    EXPECT_LE(large.width * large.height, 512U * 512U);
    EXPECT_NEAR(large.texel * large.height, FlatView().span, 1e-9);
}

class FlatViews : public Headless {
protected:
    void SetUp() override { open_in_2d(halves); }
    void open_in_2d(const std::string& text) {
        open(text);
        state.flat.maker = &maker_;
        play("key 7");
        settle();
    }
    void TearDown() override { state.flat.maker = nullptr; }
    void settle() {
        for (int i = 0; i < 3; ++i) {
            frame();
            maker_.wait_idle();
            frame();
        }
    }
    double middle() const {
        const FlatView& view = state.view.flat;
        const auto lanes = values_at(state.flat.shown, view.u, view.v);
        return lanes ? (*lanes)[0] : NAN;
    }

private:
    FlatMaker maker_{FlatPainter()};
};

TEST_F(FlatViews, ShowTheNodeOfTheOutputUntilOneIsSelected) {
    EXPECT_EQ(state.flat.shown.values.node, "bump");
    play("click node:half");
    settle();
    EXPECT_EQ(state.flat.shown.values.node, "half");
    EXPECT_NEAR(middle(), 0.25, 0.01);
    play("assert clean\nkey 1\nassert no-target flat\nassert target preview");
    play("click preview:view\nclick view:flat\nassert target flat");
}

TEST_F(FlatViews, ShowAChannelOfAMaterial) {
    open_in_2d(R"({"wrinkle": 1, "nodes": {"all": {"type": "material",
        "in": {"color": [0.5, 0.25, 1], "roughness": 0.75}}},
        "outputs": {"material": {"from": "all.material"}}})");
    EXPECT_EQ(flat_node(state), "all");
    EXPECT_EQ(state.flat.shown.values.channels, (std::vector<std::string>{"color", "roughness"}));
    EXPECT_EQ(state.flat.shown.values.channel, "color");
    EXPECT_EQ(middle(), 0.5);
    play("click flat:output\nclick flat:output:roughness");
    settle();
    EXPECT_EQ(state.flat.shown.values.channel, "roughness");
    EXPECT_EQ(middle(), 0.75);
    play("assert clean\nwheel flat 1");
}

TEST_F(FlatViews, TheWheelZoomsAtThePointerAndADragMoves) {
    play("click node:half");
    settle();
    const FlatView before = state.view.flat;
    play("wheel flat+60,20 5");
    settle();
    EXPECT_NEAR(state.view.flat.span, before.span / std::pow(1.1, 5), 1e-6);
    EXPECT_GT(state.view.flat.u, before.u) << "the pointer is at the right of the middle";
    EXPECT_LT(state.view.flat.v, before.v) << "and below it";
    EXPECT_NEAR(middle(), state.view.flat.u / 2, 0.01);
    const double u = state.view.flat.u;
    play("drag flat flat+50,0");
    settle();
    EXPECT_LT(state.view.flat.u, u);
    play("key Shift+F");
    EXPECT_EQ(state.view.flat, before);
}

TEST_F(FlatViews, TheValueUnderThePointerIsShown) {
    play("click node:level");
    settle();
    play("wheel flat 1");
    settle();
    EXPECT_NE(state.flat.at_pointer.find("   0.25"), std::string::npos) << state.flat.at_pointer;
    EXPECT_EQ(state.flat.at_pointer.rfind("u 0.5", 0), 0U) << state.flat.at_pointer;
}

TEST_F(FlatViews, FollowEditsAndPresets) {
    play("click node:level\nkey Shift+E\nclick preset\nclick preset:High");
    settle();
    EXPECT_NEAR(middle(), 0.75, 1e-6);
    play("click input:level:more\ntype 0.5\nkey Enter");
    settle();
    EXPECT_NEAR(middle(), 0.5, 1e-6);
}

TEST_F(FlatViews, ChannelsAndTheRangeOfGrayAreChosen) {
    play("assert no-target flat:range\nclick flat:1");
    EXPECT_EQ(state.view.flat.channel, 1);
    play("assert target flat:range\nclick flat:unit");
    EXPECT_FALSE(state.view.flat.fits_range);
    play("click flat:all");
    EXPECT_EQ(state.view.flat.channel, -1);
}

TEST_F(FlatViews, AMoveOfANodeEvaluatesNothing) {
    play("click node:half");
    settle();
    const uint64_t version = state.flat.requested.version;
    play("drag node:half node:half+40,80\nassert dirty");
    settle();
    EXPECT_EQ(state.flat.requested.version, version);
}

}  // namespace
}  // namespace wrinkle::editor
