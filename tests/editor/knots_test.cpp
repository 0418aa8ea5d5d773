// Tests of color ramps: edits of stops, the strip on the card, and the editor in the popup.
#include "editor/model/document/knots.h"

#include "base/srgb.h"
#include "editor/view/preview/knot_values.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

const char* const ramp_graph = R"({
  "wrinkle": 1,
  "nodes": {
    "noise": { "type": "gradient_noise" },
    "split": { "type": "separate_vec2", "in": { "vector": { "from": "surface.uv0" } } },
    "rust": {
      "type": "ramp",
      "in": {
        "factor": { "from": "split.x" },
        "stops": 3,
        "color_1": [1, 0, 0],
        "position_2": 0.5,
        "color_2": { "from": "tint.color" },
        "color_3": [0, 0, 1]
      }
    },
    "tint": { "type": "color" }
  },
  "outputs": { "color": { "from": "rust.color" } },
  "layout": { "noise": [0, 400], "split": [0, 0], "tint": [0, 200], "rust": [272, 0] }
}
)";

struct RampDocument {
    Document document = parsed(ramp_graph);
    const NodeType& type = *built_in_registry().find("ramp");
    const Node& node() const { return *document.find("rust"); }
    std::vector<double> positions() const {
        std::vector<double> found;
        for (const RampStop& stop : stops_of(node(), type))
            found.push_back(stop.position);
        return found;
    }
    // The end of the wire to the color of a stop; "" for a value.
    std::string wire(size_t stop) const {
        const Input* input = node().find(repeated_name("color", stop));
        return input && input->kind == Input::Kind::link ? input->link.text() : "";
    }
};
using Positions = std::vector<double>;

TEST(Ramps, AreKnownByTheirPorts) {
    for (const NodeType& type : built_in_registry().list())
        EXPECT_EQ(is_ramp(&type), type.id == "ramp") << type.id;
    EXPECT_FALSE(is_ramp(nullptr));
}

TEST(Ramps, AStopIsAddedBetweenItsNeighboursAndTheirWiresMove) {
    RampDocument ramp;
    ASSERT_EQ(ramp.positions(), (Positions{0, 0.5, 1}));
    ramp.document = with_stop(ramp.document, ramp.node(), ramp.type, {0.25, {0, 1, 0}});
    EXPECT_EQ(ramp.positions(), (Positions{0, 0.25, 0.5, 1}));
    const auto stops = stops_of(ramp.node(), ramp.type);
    EXPECT_EQ(stops[0].color, (std::array<double, 3>{1, 0, 0}));
    EXPECT_EQ(stops[1].color, (std::array<double, 3>{0, 1, 0}));
    EXPECT_EQ(stops[3].color, (std::array<double, 3>{0, 0, 1}));
    EXPECT_EQ(ramp.wire(1), "");
    EXPECT_EQ(ramp.wire(2), "tint.color");
}

TEST(Ramps, RemovingAnAddedStopRestoresTheRamp) {
    RampDocument ramp;
    const auto before = ramp.node().inputs.size();
    for (const double position : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const size_t index = index_after(ramp.positions(), position);
        ramp.document = with_stop(ramp.document, ramp.node(), ramp.type, {position, {0, 1, 0}});
        ASSERT_EQ(ramp.positions().size(), 4U);
        ramp.document = without_item(ramp.document, ramp.node(), ramp_ports(&ramp.type), index);
        EXPECT_EQ(ramp.positions(), (Positions{0, 0.5, 1})) << position;
        EXPECT_EQ(ramp.wire(1), "tint.color") << position;
    }
    EXPECT_EQ(ramp.node().inputs.size(), before);
}

TEST(Ramps, HaveTwoToTenStops) {
    RampDocument ramp;
    for (int i = 0; i < 20; ++i)
        ramp.document = with_stop(ramp.document, ramp.node(), ramp.type, {0.3, {}});
    EXPECT_EQ(ramp.positions().size(), ramp_ports(&ramp.type).most());
    for (int i = 0; i < 20; ++i)
        ramp.document = without_item(ramp.document, ramp.node(), ramp_ports(&ramp.type), 0);
    EXPECT_EQ(ramp.positions().size(), 2U);
}

TEST(Ramps, ACountOutOfRangeIsReadAsTheDefault) {
    for (const int count : {-3, 0, 99}) {
        const Document document =
            parsed(R"({ "wrinkle": 1, "nodes": { "rust": { "type": "ramp", "in": { "stops": )" +
                   std::to_string(count) + " } } } }");
        const NodeType& type = *built_in_registry().find("ramp");
        const Node& node = *document.find("rust");
        EXPECT_EQ(stops_of(node, type).size(), 2U);
        EXPECT_TRUE(ramp_colors(node, built_in_registry()).empty());
        EXPECT_LE(stops_of(*with_stop(document, node, type, {0.5, {}}).find("rust"), type).size(),
                  ramp_ports(&type).most());
    }
}

TEST(Ramps, AStopStaysBetweenItsNeighbours) {
    RampDocument ramp;
    ramp.document = with_stop_at(ramp.document, ramp.node(), ramp.type, 0, 0.8);
    EXPECT_EQ(ramp.positions(), (Positions{0.5, 0.5, 1}));
    ramp.document = with_stop_at(ramp.document, ramp.node(), ramp.type, 2, -1);
    EXPECT_EQ(ramp.positions(), (Positions{0.5, 0.5, 0.5}));
}

// From red over black, the default of the wired color, to blue.
TEST(Ramps, TheStripHasTheColorsOfTheNode) {
    RampDocument ramp;
    Document document = ramp.document;
    const auto strip = ramp_colors(ramp.node(), built_in_registry());
    ASSERT_GT(strip.size(), 20U);
    for (size_t i = 0; i < strip.size(); ++i) {
        const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(strip.size());
        const auto middle = stops_of(ramp.node(), ramp.type)[1].color[0];
        const double red = u < 0.5 ? 1 + (middle - 1) * 2 * u : middle * (2 - 2 * u);
        EXPECT_NEAR(strip[i].r, srgb_from_linear(red), 0.02) << u;
    }
}

const char* const curve_graph = R"({
  "wrinkle": 1,
  "nodes": {
    "noise": { "type": "gradient_noise" },
    "shape": { "type": "curve", "in": { "value": { "from": "noise.value" }, "points": 3,
                                        "point_2": [0.5, 0.25] } }
  },
  "outputs": { "roughness": { "from": "shape.value" } },
  "layout": { "noise": [0, 0], "shape": [272, 0] }
}
)";

TEST(Curves, AreKnownByTheirPorts) {
    for (const NodeType& type : built_in_registry().list())
        EXPECT_EQ(is_curve(&type), type.id == "curve") << type.id;
}

TEST(Curves, GoThroughTheirPoints) {
    const Document document = parsed(curve_graph);
    const Node& node = *document.find("shape");
    const auto points = points_of(node, *built_in_registry().find("curve"));
    ASSERT_EQ(points.size(), 3U);
    const auto values = curve_values(node, built_in_registry());
    ASSERT_GT(values.size(), 20U);
    EXPECT_NEAR(values.front(), points[0].y, 0.02);
    EXPECT_NEAR(values[values.size() / 2], 0.25, 0.02);
    EXPECT_NEAR(values.back(), points[2].y, 0.02);
}

TEST(Curves, APointIsAddedInOrderAndStaysBetweenItsNeighbours) {
    Document document = parsed(curve_graph);
    const NodeType& type = *built_in_registry().find("curve");
    document = with_point(document, *document.find("shape"), type, {0.25, 0.75});
    const auto added = points_of(*document.find("shape"), type);
    ASSERT_EQ(added.size(), 4U);
    EXPECT_EQ(added[1], glm::dvec2(0.25, 0.75));
    EXPECT_EQ(added[2], glm::dvec2(0.5, 0.25));
    document = with_point_at(document, *document.find("shape"), type, 1, {0.9, -1});
    EXPECT_EQ(points_of(*document.find("shape"), type)[1], glm::dvec2(0.5, -1));
    document = without_item(document, *document.find("shape"), curve_ports(&type), 1);
    EXPECT_EQ(positions_of(points_of(*document.find("shape"), type)), (Positions{0, 0.5, 1}));
}

TEST_F(Headless, ASubgraphWithTheNamesOfARampIsNone) {
    folder.write("like.json", R"({ "wrinkle": 1, "inputs": {
        "factor": { "type": "float" }, "stops": { "type": "count", "default": 2, "limits": [1, 2] },
        "position_1": { "type": "float" }, "color_1": { "type": "color" },
        "position_2": { "type": "float" }, "color_2": { "type": "color" } } })");
    open(R"({ "wrinkle": 1, "nodes": { "like": { "type": "graph:like.json" } },
              "layout": { "like": [0, 0] } })");
    ASSERT_TRUE(state.type_of("like"));
    EXPECT_FALSE(is_ramp(state.type_of("like")));
    play("click node:like\nkey Enter");
}

TEST(Ramps, NeedAtLeastOneStop) {
    NodeType type = *built_in_registry().find("ramp");
    ASSERT_TRUE(is_ramp(&type));
    Port& count = type.ports[type.find_input("stops")];
    count.hard_min = 0;
    EXPECT_FALSE(is_ramp(&type));
    count.hard_min = 12;
    EXPECT_FALSE(is_ramp(&type));
}

TEST_F(Headless, ACurveIsEditedInItsPopup) {
    open(curve_graph);
    EXPECT_EQ(state.layout.find("shape")->more, "8 more inputs");
    const auto points = [&] {
        return points_of(*state.document().find("shape"), *state.type_of("shape"));
    };
    play("click field:shape.points\nclick curve:plot+80,-40");
    ASSERT_EQ(points().size(), 4U);
    const glm::dvec2 added = points()[2];
    EXPECT_NEAR(added.x, 0.75, 0.02);
    EXPECT_NEAR(added.y, 0.5 + 40 / 220.0, 0.02);
    play("drag curve:point3 curve:point3+0,44");
    EXPECT_NEAR(points()[2].y, added.y - 0.2, 0.02);
    play("key Left\nkey Shift+Up\nkey Shift+Right");
    EXPECT_NEAR(points()[1].x, 0.51, 1e-6);
    EXPECT_NEAR(points()[1].y, 0.26, 1e-6);
    play("key Delete\nkey Insert\nkey Tab\nkey Escape\nassert no-target curve:plot");
    EXPECT_EQ(points().size(), 4U);
    for (int i = 0; i < 6; ++i)
        play("key Ctrl+Z");
    play("assert clean");
}

class RampEditor : public Headless {
protected:
    RampEditor() { open(ramp_graph); }
    std::vector<RampStop> stops() const {
        return stops_of(*state.document().find("rust"), *state.type_of("rust"));
    }
};

TEST_F(RampEditor, FourStopsInFiveActions) {
    play(R"(
        click field:rust.stops
        click ramp:strip
        assert actions 2)");
    ASSERT_EQ(stops().size(), 4U);
    const double added = stops()[2].position;
    EXPECT_NEAR(added, 0.5, 0.01);
    play("drag ramp:stop3 ramp:stop3+40,0\nkey Escape\nassert actions 4");
    EXPECT_NEAR(stops()[2].position, added + 0.125, 0.02);
    play("key Ctrl+Z");
    EXPECT_EQ(stops()[2].position, added);
    play("key Ctrl+Z\nassert clean");
    EXPECT_EQ(stops().size(), 3U);
}

TEST_F(RampEditor, IsUsedByTheKeyboardAlone) {
    play("click node:rust\nkey Enter");
    ASSERT_NE(state.popup.kind, Popup::Kind::none);
    play("key Escape\nclick field:rust.stops\nkey Insert");
    ASSERT_EQ(stops().size(), 4U);
    EXPECT_NEAR(stops()[1].position, 0.25, 1e-6);
    play("key Shift+Right\nkey Shift+Right");
    EXPECT_NEAR(stops()[1].position, 0.27, 1e-6);
    play("key Left\nkey Delete");
    ASSERT_EQ(stops().size(), 3U);
    EXPECT_NEAR(stops()[0].position, 0.27, 1e-6);
    play("key Escape\nkey Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+Z\nassert clean");
}

TEST_F(RampEditor, EnterInAFieldLeavesItOpen) {
    play("click field:rust.stops\nclick ramp:stop3\ndouble ramp:position\nkey Ctrl+A\ntype 0.8");
    play("key Enter\nassert target ramp:strip");
    EXPECT_NEAR(stops()[2].position, 0.8, 1e-6);
    play("key Enter\nassert no-target ramp:strip");
}

TEST_F(RampEditor, StaysInsideTheWindow) {
    const auto field = state.targets.find("field:rust.stops");
    ASSERT_TRUE(field);
    state.view.pan.y += ImGui::GetIO().DisplaySize.y - 300 - field->y0;
    play("wait\nclick field:rust.stops\nwait\nclick ramp:stop3\nwait");
    const auto pick = state.targets.find("ramp:color#pick");
    ASSERT_TRUE(pick);
    EXPECT_LE(pick->y1, ImGui::GetIO().DisplaySize.y);
}

TEST_F(RampEditor, AColorOnAWireIsNotReplaced) {
    play("click field:rust.stops\nclick ramp:stop2\nassert no-target ramp:color");
    play("click ramp:stop3\nassert target ramp:color\nclick ramp:remove");
    EXPECT_EQ(stops().size(), 2U);
    EXPECT_EQ(state.document().find("rust")->find("color_2")->link.text(), "tint.color");
}

TEST_F(RampEditor, TheCardShowsTheStripAndWiredStops) {
    const Card* card = state.layout.find("rust");
    ASSERT_TRUE(card);
    EXPECT_FALSE(card->strip.empty());
    std::vector<std::string> shown;
    for (const Pin& pin : card->pins)
        if (!pin.output) shown.push_back(pin.port);
    EXPECT_EQ(shown, (std::vector<std::string>{"factor", "color_2", "detail"}));
}

}  // namespace
}  // namespace wrinkle::editor
