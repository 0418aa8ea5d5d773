// Tests of the handles in the 2D view: points by hand and on the edges that the evaluator finds,
// values after moves, and drags by the pointer.
#include "editor/model/document/uv_handles.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "editor/model/document/field.h"
#include "editor/view/preview/flat_values.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

// A graph with the node `n`.
Document with_node(const std::string& type, const std::string& in) {
    return parsed(R"({"wrinkle": 1, "inputs": {"c": {"type": "vec2"}, "s": {"type": "vec2"},
        "r": {"type": "float"}}, "nodes": {"other": {"type": "uv_rotate"}, "n": {"type": ")" +
                  type + R"(", "in": {)" + in + R"(}}}, "outputs": {}})");
}

const NodeType& type_of(const Document& document) {
    return *built_in_registry().find(document.find("n")->type);
}

std::vector<UvHandle> handles_of(const Document& document) {
    return uv_handles(*document.find("n"), type_of(document));
}

glm::dvec2 at(const Document& document, std::string_view port) {
    for (const UvHandle& handle : handles_of(document))
        if (handle.port == port) return handle.at;
    ADD_FAILURE() << "no handle " << port;
    return {NAN, NAN};
}

Document moved(const Document& document, std::string_view port, glm::dvec2 to, bool snaps = false) {
    return with_handle_at(document, *document.find("n"), type_of(document), port, to, snaps);
}

void expect_at(glm::dvec2 a, glm::dvec2 b, double most = 1e-9) {
    EXPECT_LE(glm::distance(a, b), most) << a.x << " " << a.y << ", not " << b.x << " " << b.y;
}

TEST(UvHandles, AreWhereTheValuesAre) {
    const Document box =
        with_node("sd_box", R"("center": [0.4, 0.5], "size": [0.6, 0.2], "rotation": 90)");
    expect_at(at(box, "center"), {0.4, 0.5});
    expect_at(at(box, "size"), {0.4 - 0.1, 0.5 + 0.3});
    EXPECT_LT(at(box, "rotation").x, 0.4 - 0.1);
    EXPECT_NEAR(at(box, "rotation").y, 0.5, 1e-9);
    EXPECT_EQ(handles_of(box).size(), 3U) << "the radius is of the corners";
    const Document line = with_node("sd_segment", R"("a": [0.1, 0.2], "b": [0.7, 0.3])");
    expect_at(at(line, "a"), {0.1, 0.2});
    expect_at(at(line, "b"), {0.7, 0.3});
}

// Value of the node at a point, by the evaluator.
double value_at(const Document& document, glm::dvec2 uv) {
    TextureStore textures;
    const Model model = make_model(document, ".", built_in_registry());
    const auto values = evaluate_flat(model, document, "n", "",
                                      {uv.x - 0.5e-6, uv.y - 0.5e-6, 1e-6, 1, 1}, textures);
    return values && !values->values.empty() ? values->values[0] : NAN;
}

TEST(UvHandles, AreOnTheEdgeOfTheShape) {
    const std::string turned = R"("center": [0.3, 0.6], "rotation": 25)";
    const Document box = with_node("sd_box", turned);
    EXPECT_NEAR(value_at(box, at(box, "size")), 0, 1e-5);
    const Document circle = with_node("sd_circle", turned);
    EXPECT_NEAR(value_at(circle, at(circle, "radius")), 0, 1e-5);
    const Document gradient =
        with_node("gradient_shape", turned + R"(, "shape": "linear", "size": 0.2)");
    EXPECT_NEAR(value_at(gradient, at(gradient, "size")), 1, 1e-3);  // a mean over a pixel
}

TEST(UvHandles, OfEveryTypeAreWhereTheyWereMovedTo) {
    size_t types = 0;
    for (const NodeType& type : built_in_registry().list()) {
        const Document start = with_node(type.id, "");
        types += !handles_of(start).empty();
        for (const UvHandle& handle : handles_of(start)) {
            SCOPED_TRACE(type.id + "." + std::string(handle.port));
            const Document same = moved(start, handle.port, handle.at);
            expect_at(at(same, handle.port), handle.at, 1e-6);
            const glm::dvec2 to(0.83, 0.71);
            const Document changed = moved(start, handle.port, to);
            const glm::dvec2 found = at(changed, handle.port);
            const bool has_center = handles_of(start)[0].port == "center";
            const glm::dvec2 middle = has_center ? at(changed, "center") : glm::dvec2(0);
            if (handle.kind == UvHandle::Kind::distance)
                EXPECT_NEAR(glm::distance(found, middle), glm::distance(to, middle), 1e-6);
            else if (handle.kind == UvHandle::Kind::angle)
                expect_at(glm::normalize(found - middle), glm::normalize(to - middle), 1e-6);
            else
                expect_at(found, to, 1e-6);
        }
    }
    EXPECT_GE(types, 20U);
}

TEST(UvHandles, AnglesTakeTheNearestTurnAndSnap) {
    const Document start = with_node("sd_box", R"("rotation": 170)");
    const glm::dvec2 left_below(0.5 - std::cos(0.1), 0.5 - std::sin(0.1));
    const double angle =
        moved(start, "rotation", left_below).find("n")->find("rotation")->value.as_number();
    EXPECT_NEAR(angle, 90 + 0.1 * 180 / 3.14159265358979, 1e-6);
    const double snapped =
        moved(start, "rotation", left_below, true).find("n")->find("rotation")->value.as_number();
    EXPECT_EQ(snapped, 90);
    const json::Value center =
        moved(start, "center", {0.234, 0.777}, true).find("n")->find("center")->value;
    EXPECT_NEAR(center.at(0).as_number(), 0.25, 1e-12);
    EXPECT_NEAR(center.at(1).as_number(), 0.8, 1e-12);
}

TEST(UvHandles, ValuesOnWiresHaveNone) {
    const auto ports = [](const std::string& in) {
        std::string names;
        for (const UvHandle& handle : handles_of(with_node("sd_box", in)))
            names += std::string(handle.port) + " ";
        return names;
    };
    EXPECT_EQ(ports(R"("uv": {"from": "surface.uv1"})"), "center size rotation ");
    EXPECT_EQ(ports(R"("uv": {"from": "other.uv"})"), "");
    EXPECT_EQ(ports(R"("center": {"from": "input.c"})"), "");
    EXPECT_EQ(ports(R"("size": {"from": "input.s"})"), "center rotation ");
    EXPECT_EQ(ports(R"("rotation": {"from": "input.r"})"), "center ");
    EXPECT_TRUE(handles_of(with_node("gradient_noise", "")).empty());
}

class HandleDrags : public Headless {
protected:
    void SetUp() override {
        open(R"({"wrinkle": 1, "nodes": {"n": {"type": "sd_circle"}}, "outputs": {},
            "layout": {"n": [0, 0]}})");
        play("key 7\nclick node:n");
    }
    double number(const char* port, size_t lane = 0) const {
        return numbers_at(*state.document().find("n"),
                          *input_port(built_in_registry().find("sd_circle"), port))[lane];
    }
    double radius() const { return number("radius"); }
};

TEST_F(HandleDrags, AreOneStepOfUndo) {
    const double before = radius();
    play("drag handle:radius handle:radius+40,0");
    const double pixel = state.flat.panel.pixel();
    EXPECT_NEAR(radius(), before + 40 * pixel, 2 * pixel);
    play("key Ctrl+Z");
    EXPECT_EQ(radius(), before);
    play("assert clean");
}

TEST_F(HandleDrags, OfTheCenterMoveTheOthers) {
    const auto before = *state.targets.find("handle:radius");
    play("drag handle:center handle:center+30,20");
    const auto after = *state.targets.find("handle:radius");
    EXPECT_NEAR(after.middle_x(), before.middle_x() + 30, 2);
    EXPECT_NEAR(after.middle_y(), before.middle_y() + 20, 2);
    EXPECT_DOUBLE_EQ(state.view.flat.u, FlatView().u) << "the view moved too";
}

TEST_F(HandleDrags, GoOnOutsideOfTheView) {
    play("stroke - left handle:center handle:center+0,-400 handle:center+0,-900");
    const double pixel = state.flat.panel.pixel();
    EXPECT_NEAR(number("center", 1), 0.5 + 900 * pixel, 2 * pixel);
}

TEST_F(HandleDrags, EndWithEscape) {
    const double before = radius();
    const auto handle = *state.targets.find("handle:radius");
    const auto run = [&] {
        while (!queue.empty())
            frame();
    };
    queue.motion(handle.middle_x(), handle.middle_y());
    queue.button(0, true);
    queue.motion(handle.middle_x() + 50, handle.middle_y());
    run();
    EXPECT_GT(radius(), before);
    queue.chord("Escape");
    queue.motion(handle.middle_x() + 80, handle.middle_y());
    run();
    EXPECT_EQ(radius(), before);
    queue.button(0, false);
    run();
    EXPECT_EQ(radius(), before);
    play("assert clean");
}

}  // namespace
}  // namespace wrinkle::editor
