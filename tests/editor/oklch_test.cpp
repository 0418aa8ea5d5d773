// Tests of OKLCh and its row in the color picker, by the values that CSS Color 4 gives for the
// primaries of sRGB.
#include "editor/model/oklch.h"

#include "headless.h"

namespace wrinkle::editor {
namespace {

void expect_near(glm::dvec3 value, glm::dvec3 wanted, double tolerance) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(value[i], wanted[i], tolerance) << i;
}

TEST(Oklch, OfPrimariesIsThatOfCss) {
    const struct {
        glm::dvec3 linear, lch;
    } rows[] = {{{1, 0, 0}, {0.627955, 0.257683, 29.2339}},
                {{0, 1, 0}, {0.866440, 0.294827, 142.4953}},
                {{0, 0, 1}, {0.452014, 0.313214, 264.0520}}};
    for (const auto& [linear, lch] : rows) {
        expect_near(oklch_of(linear), lch, 1e-4);  // as many digits as the hue has
        expect_near(linear_of_oklch(lch), linear, 1e-4);
    }
    EXPECT_NEAR(oklch_of({1, 1, 1}).x, 1, 1e-6);
    EXPECT_NEAR(oklch_of({1, 1, 1}).y, 0, 1e-6);
}

TEST(Oklch, IsTurnedBackForEveryColor) {
    for (double r = 0; r <= 2; r += 0.25)
        for (double g = 0; g <= 2; g += 0.25)
            for (double b = 0; b <= 2; b += 0.25)
                expect_near(linear_of_oklch(oklch_of({r, g, b})), {r, g, b}, 1e-9);
}

TEST_F(Headless, ADragOfTheChromaKeepsLightnessAndHueAndIsOneStep) {
    open(R"({"wrinkle": 1, "nodes": {"m": {"type": "material", "in": {"color": "#a01818"}}},
        "outputs": {"material": {"from": "m.material"}}, "layout": {"m": [0, 0]}})");
    const auto color = [&] {
        const json::Value& value = state.document().find("m")->find("color")->value;
        return glm::dvec3(value.at(0).as_number(), value.at(1).as_number(),
                          value.at(2).as_number());
    };
    play("click field:m.color.0\nwait 5\ndrag color#C color#C+-40,0\nkey Enter");
    const glm::dvec3 before = oklch_of({0.351533, 0.009134, 0.009134}), after = oklch_of(color());
    EXPECT_LT(after.y, before.y - 0.02);
    EXPECT_GT(after.y, 0.01);
    EXPECT_NEAR(after.x, before.x, 1e-4);
    EXPECT_NEAR(after.z, before.z, 0.1);
    play("key Ctrl+Z");
    EXPECT_EQ(state.document().find("m")->find("color")->value.kind(), json::Kind::string);
}

}  // namespace
}  // namespace wrinkle::editor
