// Tests of properties of every node in the list.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/text.h"
#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

std::string output_of(const std::string& command) {
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return "cannot run " + command;
    char part[1024];
    while (const size_t size = fread(part, 1, sizeof part, pipe))
        text.append(part, size);
    pclose(pipe);
    return text;
}

bool is_one_line(const std::string& text) {
    return !text.empty() && text.find('\n') == std::string::npos;
}

// The frames allowed for a scale, as documented in the design.
bool goes_together(const std::string& scale, const std::string& frame) {
    return frame == "auto" || (frame == "exact") == (scale == "surface");
}

// Combinations of a node's choices, for evaluation one after the other.
struct Combination {
    std::string in;
    bool legal = true;
};
std::vector<Combination> combinations(const NodeType& type) {
    std::vector<Combination> all{{"", true}};
    std::string scale;
    for (const Port& port : type.ports) {
        if (port.kind != Port::Kind::choice) continue;
        std::vector<Combination> more;
        for (const Combination& given : all)
            for (const std::string& choice : port.choices) {
                const std::string member = "\"" + port.name + "\": \"" + choice + "\"";
                const size_t at = given.in.find("\"scale\": \"surface\"");
                const std::string with = at == std::string::npos ? "unit" : "surface";
                const bool legal = port.name != "frame" || goes_together(with, choice);
                more.push_back(
                    {given.in + (given.in.empty() ? "" : ", ") + member, given.legal && legal});
            }
        all = std::move(more);
    }
    return all;
}

// The node and, for its output of type material, one that splits it.
std::string shown(const NodeType& type, const std::string& in, const Port& port) {
    const std::string node = one(type.id, in);
    if (port.type != PortType::material_) return node;
    return node + R"(, "split": {"type": "material_split", "in": {"material": {"from": "n.)" +
           port.name + R"("}}})";
}
std::string link_of(const Port& port) {
    return port.type == PortType::material_ ? "split.roughness" : "n." + port.name;
}

std::string first_output(const NodeType& type) {
    for (const Port& port : type.ports)
        if (port.kind == Port::Kind::output && port.type != PortType::material_)
            return "n." + port.name;
    return "surface.normal";
}

TEST(EveryNode, IsDocumented) {
    for (const NodeType& type : registry().list()) {
        EXPECT_TRUE(is_one_line(type.title)) << type.id;
        EXPECT_TRUE(is_one_line(type.doc)) << type.id;
        EXPECT_NE(type.family, "other") << type.id;
        for (const Port& port : type.ports) {
            EXPECT_TRUE(is_one_line(port.doc)) << type.id << "." << port.name;
            const bool length = port.type == PortType::height_ && port.is_value();
            EXPECT_TRUE(!length || port.doc.find("length unit") != std::string::npos)
                << type.id << "." << port.name << " does not say its unit";
        }
    }
}

TEST(EveryNode, CompilesWithItsDefaultsAndEveryChoice) {
    for (const NodeType& type : registry().list())
        for (const Combination& given : combinations(type))
            for (const Port& port : type.ports) {
                if (port.kind != Port::Kind::output) continue;
                const std::string found = problems(shown(type, given.in, port), link_of(port));
                const std::string node = type.id + " " + given.in;
                EXPECT_TRUE(!given.legal || found.empty()) << node << ": " << found;
                const bool refused = !given.legal && port.type == PortType::gradient_;
                EXPECT_TRUE(!refused || found.find("frame") != std::string::npos) << node;
            }
}

TEST(EveryNode, IsFiniteAtItsDefaults) {
    for (const NodeType& type : registry().list())
        for (const Port& port : type.ports) {
            if (port.kind != Port::Kind::output) continue;
            Scene scene{shown(type, "", port), link_of(port)};
            for (const auto& lanes : values(scene, {{0, 0}, {0.3, 0.6}, {-700, 1e4}}))
                for (const double lane : lanes)
                    EXPECT_TRUE(std::isfinite(lane)) << type.id << "." << port.name;
        }
}

// A compile error that names the port, the number and the range.
TEST(EveryNode, RefusesCountsBeyondTheirRange) {
    size_t counts = 0;
    for (const NodeType& type : registry().list())
        for (const Port& port : type.ports) {
            if (port.kind != Port::Kind::count) continue;
            const auto low = static_cast<int>(port.hard_min),
                       high = static_cast<int>(port.hard_max);
            for (const int number : {low - 1, high + 1}) {
                const std::string in = "\"" + port.name + "\": " + std::to_string(number);
                const std::string found = problems(one(type.id, in), first_output(type));
                EXPECT_NE(found.find("error: node 'n': port '" + port.name + "' holds " +
                                     std::to_string(number) + " (expected an integer from " +
                                     std::to_string(low) + " to " + std::to_string(high) + ")"),
                          std::string::npos)
                    << type.id << ": " << found;
            }
            ++counts;
        }
    EXPECT_GT(counts, 20U);
}

// A warning that names the limit, of which the result is.
TEST(EveryNode, ClampsNumbersToTheirLimits) {
    size_t limits = 0;
    for (const NodeType& type : registry().list())
        for (const Port& port : type.ports) {
            if (port.kind != Port::Kind::input || !port.has_hard_range()) continue;
            if (port.type != PortType::float_ && port.type != PortType::height_) continue;
            const auto with = [&](double number) {
                return one(type.id, "\"" + port.name + "\": " + shortest(number));
            };
            const std::string output = first_output(type);
            const double beyond = port.hard_min - 0.5;
            const std::string found = problems(with(beyond), output);
            EXPECT_NE(found.find("warning: node 'n': port '" + port.name + "' holds " +
                                 shortest(beyond) + ", outside "),
                      std::string::npos)
                << type.id << ": " << found;
            EXPECT_NE(found.find(" is used)"), std::string::npos) << type.id << ": " << found;
            EXPECT_EQ(value_with_warnings(with(beyond), output),
                      value_with_warnings(with(port.hard_min), output))
                << type.id << "." << port.name;
            ++limits;
        }
    EXPECT_GT(limits, 60U);
}

TEST(Plugins, ExportOneSymbol) {
    for (const char* path : {WRINKLE_NODES_MODULE, WRINKLE_RIPPLES}) {
        const std::string symbols =
            output_of("nm -D --defined-only --format=posix '" + std::string(path) + "'");
        EXPECT_EQ(symbols.rfind("wrinkle_plugin T ", 0), 0u) << symbols;
        EXPECT_EQ(std::count(symbols.begin(), symbols.end(), '\n'), 1) << symbols;
    }
}

TEST(Plugins, RipplesAreRings) {
    const std::string ripples = one("ripples", R"("frequency": 2, "amplitude": 0.1)");
    EXPECT_NEAR(value({ripples, "n.height"}, 0, 0)[0], 0.1, 1e-9);
    EXPECT_NEAR(value({ripples, "n.height"}, 0.6, 0.8)[0], 0.1, 1e-9);    // two rings out
    EXPECT_NEAR(value({ripples, "n.height"}, 0.15, 0.2)[0], -0.1, 1e-9);  // in a trough
}

}  // namespace
}  // namespace wrinkle::test
