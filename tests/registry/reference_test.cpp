#include <gtest/gtest.h>

#include <limits>

#include "registry/reference.h"
#include "wrinkle/plugin.h"

namespace wrinkle {
namespace {

void build_nothing(const wr_builder*) {}

wr_port port(uint32_t kind, uint32_t type, const char* name, const char* doc) {
    wr_port p{};
    p.size = sizeof p;
    p.kind = kind;
    p.type = type;
    p.name = name;
    p.doc = doc;
    return p;
}

Registry make_registry() {
    static const char* const names[] = {"soft", "hard"};
    static wr_port scale = port(WR_KIND_INPUT, WR_PORT_vec2, "scale", "Tiles | \"per\" unit");
    scale.default_kind = WR_DEFAULT_CONSTANT;
    scale.default_value[0] = scale.default_value[1] = 1;
    scale.soft_max = 8;
    scale.unit = "x";
    static wr_port uv = port(WR_KIND_INPUT, WR_PORT_vec2, "uv", "Where");
    uv.default_kind = WR_DEFAULT_SURFACE;
    uv.default_surface = WR_SURFACE_uv0;
    static wr_port mode = port(WR_KIND_CHOICE, 0, "mode", "How");
    mode.choices = names;
    mode.choice_count = 2;
    static wr_port image = port(WR_KIND_INPUT, WR_PORT_image, "image", "What");
    image.encoding = "srgb";
    static wr_port out = port(WR_KIND_OUTPUT, WR_PORT_color, "color", "The color");
    static const wr_port* const ports[] = {&scale, &uv, &mode, &image, &out};
    static const wr_node node = {sizeof node, 1, "picture", "Picture", "Reads an image.", "images",
                                 ports,       5, nullptr,   0,         build_nothing};
    static const wr_node* const nodes[] = {&node};
    static const wr_plugin plugin = {sizeof plugin, WR_ABI, "t", "1", nodes, 1, nullptr};
    Registry registry;
    Diagnostics diagnostics;
    EXPECT_TRUE(registry.add_plugin(&plugin, Registry::built_in, diagnostics))
        << to_text(diagnostics);
    return registry;
}

TEST(Reference, Text) {
    const Registry registry = make_registry();
    EXPECT_EQ(list_text(registry),
              "images\n"
              "    picture                  Reads an image.\n");
    EXPECT_EQ(page_text(*registry.find("picture")),
              "picture: Picture (images, version 1, built-in)\n"
              "Reads an image.\n"
              "\n"
              "  in\n"
              "    scale            vec2         Tiles | \"per\" unit (x, default [1, 1])\n"
              "    uv               vec2         Where (default surface.uv0)\n"
              "    mode             choice       How (soft | hard, default \"soft\")\n"
              "    image            image        What (required, a bare path is srgb)\n"
              "\n"
              "  out\n"
              "    color            color        The color\n");
}

TEST(Reference, Json) {
    EXPECT_EQ(
        list_json(make_registry()),
        "{\"version\": 1, \"nodes\": [\n"
        "{\"id\": \"picture\", \"title\": \"Picture\", \"doc\": \"Reads an image.\", \"family\": "
        "\"images\", \"version\": 1, \"origin\": \"built-in\", \"ports\": [\n"
        "  {\"name\": \"scale\", \"kind\": \"input\", \"type\": \"vec2\", \"doc\": \"Tiles | "
        "\\\"per\\\" unit\", \"unit\": \"x\", \"default\": [1, 1], \"slider\": [0, 8]},\n"
        "  {\"name\": \"uv\", \"kind\": \"input\", \"type\": \"vec2\", \"doc\": \"Where\", "
        "\"default\": {\"from\": \"surface.uv0\"}},\n"
        "  {\"name\": \"mode\", \"kind\": \"choice\", \"doc\": \"How\", \"default\": \"soft\", "
        "\"choices\": [\"soft\", \"hard\"]},\n"
        "  {\"name\": \"image\", \"kind\": \"input\", \"type\": \"image\", \"doc\": \"What\", "
        "\"required\": true, \"encoding\": \"srgb\"},\n"
        "  {\"name\": \"color\", \"kind\": \"output\", \"type\": \"color\", \"doc\": \"The "
        "color\"}]}\n"
        "]}\n");
}

TEST(Reference, MarkdownKeepsItsTables) {
    const std::string text = list_markdown(make_registry());
    EXPECT_NE(text.find("## images\n\n### Picture (`picture`)\n"), text.npos);
    EXPECT_NE(text.find("| `scale` | vec2 | Tiles \\| \"per\" unit | x, default [1, 1] |\n"),
              text.npos);
    EXPECT_NE(text.find("soft \\| hard"), text.npos);
}

TEST(Reference, SchemaCompletesAndLetsUnknownThingsPass) {
    const std::string text = graph_schema(make_registry());
    EXPECT_NE(text.find("{\"enum\": [\"picture\", \"reroute\"]}, {\"type\": \"string\"}"),
              text.npos);
    EXPECT_NE(text.find("\"mode\": {\"description\": \"How (soft | hard, default \\\"soft\\\")\", "
                        "\"default\": \"soft\", \"anyOf\": [{\"$ref\": \"#/$defs/input_wire\"}, "
                        "{\"enum\": [\"soft\", \"hard\"]}]}"),
              text.npos);
    EXPECT_NE(text.find("{\"$ref\": \"#/$defs/numbers2\"}"), text.npos);
    EXPECT_EQ(text.find("\"additionalProperties\": false"), text.npos);
}

TEST(Reference, AnOpenRangeIsNoNumberOfTheSchema) {
    wr_port octaves = port(WR_KIND_COUNT, 0, "octaves", "How many");
    octaves.hard_min = octaves.default_value[0] = 1;
    octaves.hard_max = std::numeric_limits<double>::infinity();
    const wr_port out = port(WR_KIND_OUTPUT, WR_PORT_float, "value", "The sum");
    const wr_port* const ports[] = {&octaves, &out};
    const wr_node node = {sizeof node, 1, "n", "N", "N.", "f", ports, 2, nullptr, 0, build_nothing};
    const wr_node* const nodes[] = {&node};
    const wr_plugin plugin = {sizeof plugin, WR_ABI, "t", "1", nodes, 1, nullptr};
    Registry registry;
    Diagnostics diagnostics;
    ASSERT_TRUE(registry.add_plugin(&plugin, "p.so", diagnostics)) << to_text(diagnostics);
    const std::string text = graph_schema(registry);
    EXPECT_NE(text.find("{\"type\": \"integer\", \"minimum\": 1}"), text.npos);
    EXPECT_EQ(text.find("inf"), text.npos);
}

}  // namespace
}  // namespace wrinkle
