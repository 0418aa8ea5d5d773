// Tests of wires dragged without exact aim, and of wires between all pairs of types.
#include <algorithm>
#include <cmath>
#include <random>

#include "editor/model/document/knots.h"
#include "editor/model/document/wiring.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "headless.h"
#include "lower/conversion.h"

namespace wrinkle::editor {
namespace {

const Port* port_of_type(const NodeType& type, PortType wanted) {
    for (const Port& port : type.ports)
        if (port.type == wanted && port.is_value()) return &port;
    return nullptr;
}

// Not for a material: nodes with one have more ports, which a wire would snap to. Not a color ramp:
// its card has no pins for stops without wires.
const NodeType* type_with(PortType wanted) {
    if (wanted == PortType::material_) return nullptr;
    for (const NodeType& type : built_in_registry().list())
        if (port_of_type(type, wanted) && !is_ramp(&type)) return &type;
    return nullptr;
}

struct Tally {
    int connected = 0, offered = 0, explained = 0;
};

class TypePairs : public Headless {
protected:
    // Opens a graph with an input of type `from` and a node `b` with an input of type `to`. `b` is
    // a sub-graph if no node type has such an input.
    void open_pair(PortType from, PortType to) {
        const NodeType* taker = type_with(to);
        in = taker ? port_of_type(*taker, to)->name : "in";
        folder.write("taker.json", R"({"wrinkle":1,"inputs":{"in":{"type":")" +
                                       std::string(name_of(to)) + R"("}}})");
        open(R"({"wrinkle":1,"inputs":{"a":{"type":")" + std::string(name_of(from)) +
             R"("}},"nodes":{"b":{"type":")" + (taker ? taker->id : "graph:taker.json") +
             R"("}},"layout":{"b":[400,0]}})");
        state.status.clear();
    }

    void try_pair(const std::string& pair, bool legal, Tally& tally) {
        play("drag out:input.a pin:b." + in);
        const bool wired = link_at(state.document(), "b", in).has_value();
        EXPECT_EQ(wired, legal) << pair;
        tally.connected += wired;
        if (wired) return;
        EXPECT_NE(state.status.find(" is not a "), std::string::npos) << pair;
        EXPECT_EQ(state.status.find('\n'), std::string::npos);
        ASSERT_TRUE(state.offer.open) << pair;
        const bool offers = !state.offer.choices.empty();
        (offers ? tally.offered : tally.explained) += 1;
        if (!offers) {
            EXPECT_NE(state.status.find("It takes "), std::string::npos) << pair;
            play("key Escape\nassert clean");
            EXPECT_FALSE(state.offer.open);
            return;
        }
        const std::string between = state.offer.choices[0].type->id;
        play("key Enter\nassert status Insert");
        const auto through = link_at(state.document(), "b", in);
        ASSERT_TRUE(through) << pair;
        EXPECT_EQ(state.document().find(through->node)->type, between) << pair;
        each_wire(state.document(), [&](const Connection& wire) {
            EXPECT_EQ(wire_problem(state.model, state.document(), wire.from, wire.node, wire.port),
                      "")
                << pair;
        });
        play("key Ctrl+Z\nassert clean");
    }

    std::string in;
};

TEST_F(TypePairs, EachConnectsOffersOrExplains) {
    Tally tally;
    for (uint32_t f = 1; f <= port_type_count; ++f)
        for (uint32_t t = 1; t <= port_type_count; ++t) {
            const auto from = static_cast<PortType>(f), to = static_cast<PortType>(t);
            const bool legal = conversion(from, to) != Conversion::illegal;
            const std::string pair = std::string(name_of(from)) + " to " + std::string(name_of(to));
            open_pair(from, to);
            try_pair(pair, legal, tally);
        }
    std::printf("pairs: %d connect, %d offer a node, %d explain\n", tally.connected, tally.offered,
                tally.explained);
    EXPECT_GT(tally.offered, 20);
    EXPECT_EQ(tally.connected + tally.offered + tally.explained, 121);
}

TEST_F(Headless, AnOfferIsTakenWithOneClickOrLeft) {
    open(small_graph);
    play(R"(
        drag out:normal.normal pin:number.a
        assert target offer:normal_angle
        click offer:normal_angle
        assert wire normal.normal normal_angle.a
        assert wire normal_angle.angle number.a
        assert errors 0
        key Ctrl+Z
        assert clean
        drag out:normal.normal pin:number.a
        click canvas+0,300
        assert clean)");
    EXPECT_FALSE(state.offer.open);
}

// Two columns of nodes, drawn at zoom 0.3.
class FarOut : public Headless {
protected:
    void open_columns() {
        const char* const types[] = {
            "gradient_noise", "gradient_scale", "gradient_add", "resolve", "add",
            "height_scale",   "vec3_add",       "uv_transform"};
        std::string nodes, places;
        for (int i = 0; i < 16; ++i) {
            const std::string id = (i ? ",\"n" : "\"n") + std::to_string(i) + "\":";
            nodes += id + R"({"type":")" + types[i % 8] + "\"}";
            places +=
                id + "[" + std::to_string(i / 8 * 900) + "," + std::to_string(i % 8 * 240) + "]";
        }
        open(R"({"wrinkle":1,"nodes":{)" + nodes + R"(},"layout":{)" + places + "}}");
        state.view.zoom = 0.3F;
        state.view.pan = {200, 40};
        frame();
    }

    void drag(ImVec2 from, ImVec2 to) {
        queue.motion(from.x, from.y);
        queue.button(0, true);
        queue.motion((from.x + to.x) / 2, (from.y + to.y) / 2);
        queue.motion(to.x, to.y);
        queue.button(0, false);
        while (!queue.empty())
            frame();
        frame();
    }

    bool is_wired(const std::string& from, const std::string& to) const {
        for (const Wire& wire : state.layout.wires)
            if (wire.node == to && wire.from.node == from)
                return conversion(wire.from_type, wire.to_type) != Conversion::illegal;
        return false;
    }

    void start_again() {
        while (state.history.undo()) {
        }
        state.palette = {};
        state.offer = {};
        frame();
    }
};

TEST_F(FarOut, WiresNeedNoAiming) {
    open_columns();
    std::mt19937 random(3);
    int tried = 0, wired = 0;
    while (tried < 100) {
        const Card from = *state.layout.find("n" + std::to_string(random() % 8));
        const Card to = *state.layout.find("n" + std::to_string(8 + random() % 8));
        const Pin& out = from.pins[random() % from.pins.size()];
        const Pin& in = to.pins[random() % to.pins.size()];
        if (!out.output || in.output || conversion(out.type, in.type) == Conversion::illegal)
            continue;
        ++tried;
        const float turn = static_cast<float>(random() % 628) / 100;
        const float off = static_cast<float>(random() % 1200) / 100;
        drag(to_screen(state.view, pin_at(from, out)),
             to_screen(state.view, pin_at(to, in)) + ImVec2(std::cos(turn), std::sin(turn)) * off);
        const bool found = is_wired(from.id, to.id);
        wired += found;
        EXPECT_TRUE(found) << from.id << "." << out.port << " to " << to.id << "." << in.port
                           << " off " << off << ": " << state.status;
        start_again();
    }
    std::printf("at zoom 0.3, up to 12 px beside the pin: %d of 100 wires\n", wired);
    EXPECT_EQ(wired, 100);
}

}  // namespace
}  // namespace wrinkle::editor
