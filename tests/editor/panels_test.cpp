// Tests of the panels: values edited in place, problems with their fixes, pages of nodes and keys.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <map>

#include "base/text.h"
#include "editor/model/document/field.h"
#include "editor/view/commands/commands.h"
#include "editor/view/panels/help.h"
#include "editor/view/panels/panels.h"
#include "headless.h"
#include "wrinkle/plugin.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;

TEST_F(Headless, TabGoesThroughAllValuesOfANode) {
    texture("rivets_normal.png");
    texture("weave_normal.png");
    open(R"({ "wrinkle": 1, "nodes": { "map": { "type": "tangent_normal_map" } } })");
    play(R"(
        click node:map
        key Enter
        assert target choice:textures/weave_normal.png
        key Down
        key Tab
        type 0.5
        key Tab
        assert value map.strength 0.5
        assert target choice:surface
        key Up
        key Enter
        assert value map.scale "surface")");
    play(R"(
        key Enter
        key Down
        key Enter
        assert value map.image "textures/weave_normal.png"
        double field:map.direction.0
        type 2
        key Tab
        type 3
        key Tab
        type 4
        key Enter)");
    const NodeType& type = *built_in_registry().find("tangent_normal_map");
    const auto numbers =
        numbers_at(*state.document().find("map"), type.ports[type.find_input("direction")]);
    EXPECT_EQ(numbers, (std::array<double, 4>{2, 3, 4, 0}));
}

TEST_F(Headless, ALongListIsNarrowedByTyping) {
    for (const char* name : {"ball_cube.png", "ball_object.png", "bricks_height.png",
                             "patches_mask.png", "pebbles_height.png", "pebbles_slopes.png",
                             "rivets_normal.png", "weave_height.png", "weave_normal.png"})
        texture(name);
    open(R"({ "wrinkle": 1, "nodes": { "map": { "type": "tangent_normal_map" } } })");
    play(R"(
        click field:map.image
        type weave_n
        assert no-target choice:textures/rivets_normal.png
        key Enter
        assert value map.image "textures/weave_normal.png"
        click field:map.image
        type nothing like it
        key Enter
        assert value map.image "textures/weave_normal.png"
        key Escape)");
    EXPECT_EQ(state.popup.kind, Popup::Kind::none);
}

// Registry with a node type that has a color input; no built-in type has one.
Registry with_color_node() {
    static wr_port in = {}, out = {};
    in.size = out.size = sizeof(wr_port);
    in.kind = WR_KIND_INPUT;
    out.kind = WR_KIND_OUTPUT;
    in.type = out.type = WR_PORT_color;
    in.name = out.name = "color";
    in.doc = out.doc = "What is passed";
    in.default_kind = WR_DEFAULT_CONSTANT;
    in.default_value[0] = 0.5;
    static const wr_port* const ports[] = {&in, &out};
    static wr_node tint = {};
    tint.size = sizeof(wr_node);
    tint.version = 1;
    tint.id = "tint";
    tint.title = "Tint";
    tint.doc = "Passes a color.";
    tint.family = "test";
    tint.ports = ports;
    tint.port_count = 2;
    tint.build = [](const wr_builder* b) { b->output(b, 1, b->input(b, 0)); };
    static const wr_node* const nodes[] = {&tint};
    static wr_plugin plugin = {};
    plugin.size = sizeof(wr_plugin);
    plugin.abi = WR_ABI;
    plugin.id = "colors";
    plugin.version = "1";
    plugin.nodes = nodes;
    plugin.node_count = 1;
    Registry registry;
    Diagnostics problems;
    EXPECT_TRUE(registry.add_plugin(&plugin, "colors", problems)) << to_text(problems);
    return registry;
}

TEST_F(Headless, AColorIsPickedInOneStep) {
    static const Registry registry = with_color_node();
    state.registry = &registry;
    open(R"({ "wrinkle": 1, "nodes": { "c": { "type": "tint" } } })");
    play("assert errors 0\nclick field:c.color.0\nassert target color");
    play("click color+-60,-40\nclick color+-50,-60\nkey Enter\nassert dirty");
    EXPECT_NE(state.document().find("c")->find("color"), nullptr);
    play("key Ctrl+Z\nassert clean\nassert value c.color default");
}

// Half the height of the picker's square is 0.5 as displayed, 0.214 linear.
TEST_F(Headless, AColorIsPickedInDisplayValuesAndStoredLinear) {
    static const Registry registry = with_color_node();
    state.registry = &registry;
    open(R"({ "wrinkle": 1, "nodes": { "c": { "type": "tint", "in": { "color": [1, 0, 0] } } } })");
    play("click field:c.color.0");
    const auto picker = *state.targets.find("color");
    const float square = 188, middle = (square - (picker.y1 - picker.y0)) / 2;
    play("click color+-30," + std::to_string(static_cast<int>(middle)));
    const json::Value color = state.document().find("c")->find("color")->value;
    double value = 0;
    for (size_t i = 0; i < 3; ++i)
        value = std::max(value, color.at(i).as_number());
    EXPECT_NEAR(value, 0.214, 0.04);
}

const char* const broken_graph = R"({
  "wrinkle": 1,
  "nodes": {
    "weave": { "type": "tangent_normal_map", "in": { "image": "textures/gone.png" } },
    "softer": { "type": "gradient_scale", "in": { "gradient": { "from": "weave.gradient" }, "amount": { "from": "normal2.normal" } } },
    "normal2": { "type": "resolve" },
    "odd": { "type": "no_such_type" },
    "normal": { "type": "resolve", "in": { "gradient": { "from": "softer.gradient" } } }
  },
  "outputs": { "normal": { "from": "normal.normal" } }
})";

TEST_F(Headless, ProblemsFrameTheirNodesAndAreFixedWhereThatIsCertain) {
    texture("weave_normal.png");
    open(broken_graph);
    const auto find = [&](std::string_view node) {
        const auto& list = state.built.problems.list();
        for (size_t i = 0; i < list.size(); ++i)
            if (list[i].node == node) return std::to_string(i + 1);
        return std::string("none");
    };
    ASSERT_NE(find("weave"), "none") << to_text(state.built.problems);
    ImGui::GetIO().DisplaySize.y = 2400;  // tall enough for all rows
    frame();
    frame();
    play("click problem:" + find("odd"));
    EXPECT_EQ(state.view.selected, std::set<std::string>{"odd"});
    EXPECT_FALSE(state.targets.find("fix:" + find("odd")));
    play("click fix:" + find("softer") + "\nassert no-wire normal2.normal softer.amount");
    play("click fix:" + find("weave") +
         "\nclick choice:textures/weave_normal.png\n"
         "assert value weave.image \"textures/weave_normal.png\"");
    EXPECT_EQ(find("weave"), "none") << to_text(state.built.problems);
}

TEST_F(Headless, TheKeyGoesFromProblemToProblem) {
    open(broken_graph);
    const auto& list = state.built.problems.list();
    ASSERT_GE(list.size(), 3U);
    for (size_t i = 0; i < list.size() + 1; ++i) {
        play("key F8");
        EXPECT_EQ(state.problems.current, i % list.size());
        EXPECT_TRUE(state.view.selected.contains(list[i % list.size()].node));
    }
    open(small_graph);
    play("key F8\nassert clean");
}

TEST_F(Headless, HelpIsOfTheSelectedNode) {
    open(small_graph);
    play("click node:softer\nkey F1\nassert target help:gradient_scale\nkey Escape");
    play("click canvas+0,320\nkey F1\nassert target help:shortcuts\nkey Escape\nwait");
    EXPECT_FALSE(state.help.open);
    const auto node = *state.targets.find("node:softer");
    queue.motion(node.middle_x(), node.middle_y());
    play("wait 60");
    play("assert target tip:gradient_scale");
    const auto field = *state.targets.find("field:softer.amount");
    queue.motion(field.middle_x(), field.middle_y());
    play("wait 60\nassert target tip:amount");
    play("key F1\nwait 60\nassert target help:shortcuts\nassert no-target tip:amount");
    play("key Escape\nwait 60\nassert target tip:amount");
}

TEST_F(Headless, EveryNodeHasAPage) {
    open(small_graph);
    for (const NodeType& type : built_in_registry().list()) {
        for (const Port& port : type.ports)
            EXPECT_FALSE(port_facts(port).empty());
        Node node;
        node.id = "it";
        node.type = type.id;
        open("{ \"wrinkle\": 1, \"nodes\": { \"it\": { \"type\": \"" + type.id + "\" } } }");
        state.view.selected = {"it"};
        play("key F1\nassert target help:" + type.id + "\nkey Escape");
    }
}

TEST(Shortcuts, StandInThePage) {
    const fs::path page = fs::path(WRINKLE_SOURCE_DIR) / "docs/editor.md";
    std::string text = text_of(page);
    const std::string begin = "## Shortcuts\n\n", table = begin + shortcuts_markdown();
    const size_t at = text.find(begin);
    ASSERT_NE(at, std::string::npos);
    if (std::getenv("WRINKLE_UPDATE_GOLDEN"))
        std::ofstream(page, std::ios::binary) << (text = text.substr(0, at) + table);
    EXPECT_EQ(text.substr(at), table) << "WRINKLE_UPDATE_GOLDEN=1 writes it";
}

TEST(Shortcuts, NeverMeanTwoThings) {
    std::map<std::string, std::string> keys;
    for (const Command& command : commands()) {
        if (command.keys.empty()) continue;
        std::vector<std::string> parts;
        for (const std::string_view part : split(command.keys, '+'))
            parts.emplace_back(part);
        std::sort(parts.begin(), parts.end() - 1);  // the order of modifiers is not significant
        std::string whole;
        for (const std::string& part : parts) {
            EXPECT_NE(key_named(part), 0) << command.keys;
            whole += part + "+";
        }
        const auto [other, fresh] = keys.emplace(whole, command.id);
        EXPECT_TRUE(fresh) << command.id << " and " << other->second << ": " << command.keys;
    }
}

TEST_F(Headless, EscapeClosesEveryMenuAndPopup) {
    open(small_graph);
    for (const char* opener :
         {"menu:File", "menu:Edit", "menu:View", "menu:Node", "menu:Preview", "menu:Help",
          "preview:more", "preview:mesh", "preview:light", "code:menu"}) {
        play(std::string("click ") + opener + "\nwait 3");
        EXPECT_TRUE(has_open_dialog(state)) << opener;
        play("key Escape\nwait 3");
        EXPECT_FALSE(has_open_dialog(state)) << opener;
    }
}

}  // namespace
}  // namespace wrinkle::editor
