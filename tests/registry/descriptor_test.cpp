// Tests of plugin descriptors, correct and faulty: one fault at a time, each with its exact report.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "registry/registry.h"
#include "wrinkle/plugin.h"

namespace wrinkle {
namespace {

void build(const wr_builder*) {}

// A plugin of one node with every kind of port; tests introduce one fault.
struct Sample {
    const char* choices[2] = {"soft", "hard"};
    wr_port height{}, mode{}, octaves{}, flag{}, image{}, field{}, out{};
    const wr_port* ports[7] = {&height, &mode, &octaves, &flag, &image, &field, &out};
    wr_rename rename{sizeof(wr_rename), 2, "size", "height"};
    const wr_rename* renames[1] = {&rename};
    wr_node node{};
    const wr_node* nodes[2] = {&node, &node};
    wr_plugin plugin{};

    static wr_port port(uint32_t kind, uint32_t type, const char* name) {
        wr_port p{};
        p.size = sizeof p;
        p.kind = kind;
        p.type = type;
        p.name = name;
        p.doc = "A port";
        p.unit = "";
        return p;
    }

    Sample() {
        height = port(WR_KIND_INPUT, WR_PORT_height, "height");
        height.default_kind = WR_DEFAULT_CONSTANT;
        height.default_value[0] = 0.5;
        height.hard_max = 1;
        height.unit = "m";
        mode = port(WR_KIND_CHOICE, 0, "mode");
        mode.choices = choices;
        mode.choice_count = 2;
        mode.default_value[0] = 1;
        octaves = port(WR_KIND_COUNT, 0, "octaves");
        octaves.hard_min = 1;
        octaves.hard_max = 8;
        octaves.default_value[0] = 4;
        flag = port(WR_KIND_FLAG, 0, "tile");
        image = port(WR_KIND_INPUT, WR_PORT_image, "image");
        image.encoding = "normal_gl";
        field = port(WR_KIND_FIELD, WR_PORT_float, "shape");
        field.default_surface = WR_SURFACE_uv0;
        field.default_kind = WR_DEFAULT_CONSTANT;
        out = port(WR_KIND_OUTPUT, WR_PORT_height, "height");
        node = {sizeof node, 2, "sample", "Sample", "A node.", "test", ports, 7, renames, 1, build};
        plugin = {sizeof plugin, WR_ABI, "test", "1", nodes, 1, nullptr};
    }
};

std::string refusal(const std::function<void(Sample&)>& spoil) {
    Sample sample;
    spoil(sample);
    Registry registry;
    Diagnostics diagnostics;
    EXPECT_FALSE(registry.add_plugin(&sample.plugin, "p.so", diagnostics));
    EXPECT_TRUE(registry.list().empty()) << "taken whole or not at all";
    return to_text(diagnostics);
}

TEST(Descriptor, IsCopiedWhole) {
    Sample sample;
    Registry registry;
    Diagnostics diagnostics;
    ASSERT_TRUE(registry.add_plugin(&sample.plugin, "p.so", diagnostics)) << to_text(diagnostics);
    sample = {};
    const NodeType* type = registry.find("sample");
    ASSERT_NE(type, nullptr);
    EXPECT_EQ(type->title, "Sample");
    EXPECT_EQ(type->version, 2u);
    EXPECT_EQ(type->origin, "p.so");
    ASSERT_EQ(type->ports.size(), 7u);
    const Port& height = type->ports[type->find_input("height")];
    EXPECT_EQ(height.type, PortType::height_);
    EXPECT_EQ(height.unit, "m");
    EXPECT_EQ(height.default_value[0], 0.5);
    EXPECT_TRUE(height.has_hard_range());
    EXPECT_FALSE(height.has_soft_range());
    EXPECT_EQ(type->find_output("height"), 6u) << "inputs and outputs have names of their own";
    EXPECT_EQ(type->find_output("mode"), NodeType::none);
    EXPECT_EQ(type->ports[1].choices, (std::vector<std::string>{"soft", "hard"}));
    EXPECT_EQ(type->ports[4].encoding, Encoding::normal_gl);
    EXPECT_TRUE(type->ports[4].is_required());
    EXPECT_EQ(type->ports[5].default_surface, uint32_t{WR_SURFACE_uv0});
    ASSERT_EQ(type->renames.size(), 1u);
    EXPECT_EQ(type->renames[0].old_name, "size");
}

TEST(Descriptor, MayBeNewerAndLarger) {
    struct Newer {
        wr_plugin known;
        uint64_t more;
    };
    Sample sample;
    Newer newer{sample.plugin, 7};
    newer.known.size = sizeof newer;
    Registry registry;
    Diagnostics diagnostics;
    EXPECT_TRUE(registry.add_plugin(&newer.known, "p.so", diagnostics)) << to_text(diagnostics);
}

TEST(Descriptor, RefusesWrongPlugins) {
    Registry registry;
    Diagnostics diagnostics;
    EXPECT_FALSE(registry.add_plugin(nullptr, "p.so", diagnostics));
    EXPECT_EQ(to_text(diagnostics), "p.so: error: its descriptor is null\n");
    EXPECT_EQ(refusal([](Sample& s) { s.plugin.size = 4; }),
              "p.so: error: its descriptor has the impossible size 4\n");
    EXPECT_EQ(refusal([](Sample& s) { s.plugin.abi = 9; }),
              "p.so: error: it is made for plugin interface 9 (this program has interface 1)\n");
    EXPECT_EQ(refusal([](Sample& s) { s.plugin.nodes = nullptr; }),
              "p.so: error: its list of nodes is null\n");
    EXPECT_EQ(refusal([](Sample& s) { s.plugin.node_count = ~0u; }),
              "p.so: error: it claims 4294967295 nodes (at most 10000)\n");
    EXPECT_EQ(refusal([](Sample& s) { s.plugin.id = nullptr; }),
              "p.so: error: the plugin's id is null\n");
}

TEST(Descriptor, RefusesWrongNodes) {
    EXPECT_EQ(refusal([](Sample& s) { s.nodes[0] = nullptr; }),
              "p.so: error: node 'number 0': its descriptor is null\n");
    EXPECT_EQ(refusal([](Sample& s) { s.node.size = 8; }),
              "p.so: error: node 'number 0': its descriptor has the impossible size 8\n");
    EXPECT_EQ(refusal([](Sample& s) { s.node.id = nullptr; }),
              "p.so: error: node 'number 0': the id is null\n");
    EXPECT_EQ(refusal([](Sample& s) { s.node.id = "Sample"; }),
              "p.so: error: node 'Sample': its id is not lower_snake_case (letters a-z, digits and "
              "_, at most 64)\n");
    EXPECT_EQ(refusal([](Sample& s) { s.node.id = "reroute"; }),
              "p.so: error: node 'reroute': this id is reserved\n");
    EXPECT_EQ(refusal([](Sample& s) { s.node.doc = nullptr; }),
              "p.so: error: node 'sample': the doc is null\n");
    EXPECT_EQ(refusal([](Sample& s) { s.node.title = "\xFF"; }),
              "p.so: error: node 'sample': the title is not valid UTF-8\n");
    EXPECT_EQ(refusal([](Sample& s) { s.node.build = nullptr; }),
              "p.so: error: node 'sample': its build function is null\n");
    EXPECT_EQ(refusal([](Sample& s) { s.node.port_count = 6; }),
              "p.so: error: node 'sample': it has no output\n");
    EXPECT_EQ(refusal([](Sample& s) { s.node.port_count = 1000000; }),
              "p.so: error: node 'sample': it claims 1000000 ports (at most 256)\n");
    EXPECT_EQ(refusal([](Sample& s) { s.plugin.node_count = 2; }),
              "p.so: error: node 'sample': the plugin has two nodes of this id\n");
    EXPECT_EQ(refusal([](Sample& s) { s.rename.version = 3; }),
              "p.so: error: node 'sample': port 'size' was renamed in version 3 (expected 2 to "
              "2)\n");
    EXPECT_EQ(refusal([](Sample& s) { s.node.version = s.node.rename_count = 0; }),
              "p.so: error: node 'sample': its version is 0 (versions count from 1)\n");
}

TEST(Descriptor, RefusesTextsWithoutAnEndAndControlCharacters) {
    const std::string endless(1 << 20, 'a');
    EXPECT_EQ(refusal([&](Sample& s) { s.node.id = endless.c_str(); }),
              "p.so: error: node 'number 0': the id has no end within 64 bytes\n");
    EXPECT_EQ(refusal([&](Sample& s) { s.node.doc = endless.c_str(); }),
              "p.so: error: node 'sample': the doc has no end within 4096 bytes\n");
    EXPECT_EQ(refusal([](Sample& s) { s.node.id = "two\nlines"; }),
              "p.so: error: node 'number 0': the id holds a control character (one line of "
              "text)\n");
    EXPECT_EQ(refusal([](Sample& s) { s.height.doc = "\x1B[31mred"; }),
              "p.so: error: node 'sample': port 'height': the doc holds a control character (one "
              "line of text)\n");
    EXPECT_EQ(refusal([](Sample& s) { s.image.encoding = "\xC3"; }),
              "p.so: error: node 'sample': port 'image': the encoding is not valid UTF-8\n");
}

std::string port_refusal(const std::function<void(Sample&)>& spoil) {
    const std::string text = refusal(spoil);
    const std::string prefix = "p.so: error: node 'sample': ";
    EXPECT_EQ(text.substr(0, prefix.size()), prefix);
    return text.substr(prefix.size());
}

TEST(Descriptor, RefusesWrongPorts) {
    const double nan = std::nan("");
    EXPECT_EQ(port_refusal([](Sample& s) { s.ports[2] = nullptr; }),
              "port number 2: its descriptor is null\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.height.name = nullptr; }),
              "port number 0: the name is null\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.height.name = "a b"; }),
              "port 'a b': its name is not lower_snake_case (letters a-z, digits and _, at most "
              "64)\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.height.name = "tile"; }),
              "port 'tile': there is another port of this name\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.height.kind = 7; }),
              "port 'height': its kind 7 does not exist\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.height.type = 12; }),
              "port 'height': its type 12 does not exist\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.out.type = 0; }),
              "port 'height': its type 0 does not exist\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.height.default_kind = 4; }),
              "port 'height': its kind of default 4 does not exist\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.height.default_value[0] = 2; }),
              "port 'height': its default 2 is outside its range 0 to 1\n");
    EXPECT_EQ(port_refusal([&](Sample& s) { s.height.default_value[0] = nan; }),
              "port 'height': its default is not finite\n");
    EXPECT_EQ(port_refusal([&](Sample& s) { s.height.soft_max = nan; }),
              "port 'height': a range ends before it begins\n");
    EXPECT_EQ(port_refusal([](Sample& s) {
                  s.height.default_kind = WR_DEFAULT_SURFACE;
                  s.height.default_surface = WR_SURFACE_uv0;
              }),
              "port 'height': its default surface.uv0 is not of type height\n");
}

TEST(Descriptor, RefusesWrongFieldsImagesAndOptions) {
    EXPECT_EQ(port_refusal([](Sample& s) { s.field.default_surface = 10; }),
              "port 'shape': its surface property 10 does not exist\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.field.type = WR_PORT_gradient; }),
              "port 'shape': a field of gradient cannot be (fields are of numbers or slopes)\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.image.default_kind = WR_DEFAULT_CONSTANT; }),
              "port 'image': a default of type image cannot be\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.image.encoding = "rgb"; }),
              "port 'image': its encoding \"rgb\" does not exist\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.mode.choices = nullptr; }),
              "port 'mode': it has no choices\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.choices[1] = nullptr; }),
              "port 'mode': the name of a choice is null\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.choices[1] = "soft"; }),
              "port 'mode': its choice 'soft' occurs twice\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.choices[1] = "Very hard"; }),
              "port 'mode': its choice \"Very hard\" is not lower_snake_case\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.mode.default_value[0] = 2; }),
              "port 'mode': its default 2 is outside 0 to 1\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.octaves.default_value[0] = 0.5; }),
              "port 'octaves': its default is not an integer\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.octaves.default_value[0] = 9; }),
              "port 'octaves': its default 9 is outside its range 1 to 8\n");
    EXPECT_EQ(port_refusal([](Sample& s) { s.flag.default_value[0] = 2; }),
              "port 'tile': its default 2 is outside 0 to 1\n");
}

TEST(Registry, NamesBothOriginsOfOneId) {
    Sample first, second;
    Registry registry;
    Diagnostics diagnostics;
    ASSERT_TRUE(registry.add_plugin(&first.plugin, Registry::built_in, diagnostics));
    EXPECT_FALSE(registry.add_plugin(&second.plugin, "p.so", diagnostics));
    EXPECT_EQ(to_text(diagnostics),
              "p.so: error: node 'sample': this id is taken: built-in has a node of the same id "
              "(give one of them another id)\n");
    EXPECT_EQ(registry.list().size(), 1u);
}

TEST(PortTypes, HaveNamesAndLanes) {
    EXPECT_EQ(port_type_names().size(), size_t{port_type_count});
    EXPECT_EQ(name_of(PortType::derivative_), "derivative");
    EXPECT_EQ(port_type_named("normal"), PortType::normal_);
    EXPECT_FALSE(port_type_named("vector"));
    EXPECT_EQ(lanes_of(PortType::color_), 3);
    EXPECT_EQ(lanes_of(PortType::vec4_), 4);
    EXPECT_EQ(lanes_of(PortType::image_), 0);
    ASSERT_EQ(surface_properties().size(), 10u);
    EXPECT_EQ(surface_properties()[WR_SURFACE_normal].type, PortType::normal_);
    EXPECT_EQ(surface_properties()[WR_SURFACE_tangent].type, PortType::vec4_);
}

}  // namespace
}  // namespace wrinkle
