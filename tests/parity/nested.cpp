#include "parity/nested.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/text.h"
#include "parity/node_graph.h"

namespace wrinkle::test {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

// Replaces <a.b by {"from": "a.b"}.
std::string with_wires(const std::string& text) {
    std::string result;
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '<') {
            result += text[i] == '\'' ? '"' : text[i];
            continue;
        }
        const size_t end = text.find_first_of(", }", i);
        result += "{\"from\": \"" + text.substr(i + 1, end - i - 1) + "\"}";
        i = end - 1;
    }
    return result;
}

// A node of a random graph: a node type, its wired inputs by type, and an output. No uv is bent:
// the footprint of a height map's taps is known to first order inside of a function, to second
// order outside (docs/graph-format.md).
struct Kind {
    const char* type;
    std::vector<std::pair<const char*, const char*>> inputs;  // port, type
    const char* output;
    const char* gives;
    const char* more = "";  // literals
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> list{
        {"add", {{"a", "float"}, {"b", "float"}}, "result", "float"},
        {"multiply", {{"a", "float"}}, "result", "float", ", 'b': 0.75"},
        {"sine", {{"angle", "float"}}, "result", "float"},
        {"floor", {{"x", "float"}}, "result", "float"},
        {"separate_vec2", {{"vector", "vec2"}}, "x", "float"},
        {"vec2_add", {{"a", "vec2"}, {"b", "vec2"}}, "vector", "vec2"},
        {"uv_transform", {{"uv", "vec2"}}, "uv", "vec2", ", 'scale': [2, 3], 'rotation': 30"},
        {"vec3_scale", {{"vector", "vec3"}, {"factor", "float"}}, "vector", "vec3"},
        {"fbm", {{"point", "vec3"}}, "height", "height", ", 'octaves': 2"},
        {"waves", {{"uv", "vec2"}}, "height", "height", ", 'count': 2"},
        {"checker", {{"uv", "vec2"}, {"amplitude", "float"}}, "height", "height"},
        {"height_map", {{"image", "image"}, {"uv", "vec2"}}, "height", "height"},
        {"height_add", {{"a", "height"}, {"b", "height"}}, "height", "height"},
        {"height_scale", {{"height", "height"}, {"amount", "float"}}, "height", "height"},
        {"height_map", {{"image", "image"}, {"uv", "vec2"}}, "gradient", "gradient"},
        {"tangent_normal_map", {{"image", "image"}, {"uv", "vec2"}}, "gradient", "gradient"},
        {"tangent_normal_map",
         {{"image", "image"}, {"uv", "vec2"}},
         "gradient",
         "gradient",
         ", 'frame': 'derived'"},
        {"derivative_map",
         {{"image", "image"}, {"uv", "vec2"}},
         "gradient",
         "gradient",
         ", 'scale': 'surface'"},
        {"gradient_from_height", {{"height", "height"}}, "gradient", "gradient"},
        {"gradient_add", {{"a", "gradient"}, {"b", "gradient"}}, "gradient", "gradient"},
        {"gradient_mix",
         {{"a", "gradient"}, {"b", "gradient"}, {"mask", "float"}},
         "gradient",
         "gradient"},
        {"gradient_scale", {{"gradient", "gradient"}}, "gradient", "gradient", ", 'amount': 0.5"},
        {"gradient_from_normal", {{"normal", "normal"}}, "gradient", "gradient"},
        {"resolve", {{"gradient", "gradient"}}, "normal", "normal"},
    };
    return list;
}

constexpr const char* input_types[] = {"float",    "vec2",   "vec3", "height",
                                       "gradient", "normal", "image"};

// One file: values by type, and nodes that add more of them.
class RandomGraph {
public:
    RandomGraph(std::mt19937& random, int level, int deepest)
        : random_(random), level_(level), deepest_(deepest) {}

    std::string text() {
        std::string inputs;
        surface();
        for (const char* type : input_types) {
            if (level_ == 0) break;
            const std::string name = std::string("in_") + type;
            values_[type].push_back("<input." + name);
            inputs += (inputs.empty() ? "'" : ", '") + name + "': {'type': '" + type + "'}";
        }
        for (int i = 0; i < 5; ++i)
            add(kinds()[random_() % kinds().size()]);
        for (const char* use : {"p", "q", "r"})
            if (level_ < deepest_) call(use);
        for (int i = 0; i < 5; ++i)
            add(kinds()[random_() % kinds().size()]);
        return graph_text(inputs, nodes_, outputs());
    }

private:
    void surface() {
        for (const char* each : {"surface.uv0", "surface.uv1"})
            values_["vec2"].push_back(std::string("<") + each);
        values_["vec3"].push_back("<surface.position");
        values_["normal"].push_back("<surface.normal");
        values_["image"].push_back("'IMAGE_A'");
        values_["image"].push_back("'IMAGE_B'");
        add({"separate_vec2", {{"vector", "vec2"}}, "y", "float"});
        add({"waves", {{"uv", "vec2"}}, "height", "height"});
        add({"gradient_from_height", {{"height", "height"}}, "gradient", "gradient"});
    }

    // Returns a random value; newer ones are more likely.
    std::string value(const std::string& type) {
        const std::vector<std::string>& known = values_.at(type);
        size_t newest = 0;
        for (int i = 0; i < 4; ++i)
            newest = std::max(newest, random_() % known.size());
        return known[newest];
    }

    void write(const std::string& name, const std::string& type, const std::string& inputs) {
        nodes_ += (nodes_.empty() ? "'" : ", '") + name + "': {'type': '" + type + "', 'in': {" +
                  inputs + "}}";
    }

    void add(const Kind& kind) {
        std::string inputs;
        for (const auto& [port, type] : kind.inputs)
            inputs += (inputs.empty() ? "'" : ", '") + std::string(port) + "': " + value(type);
        const std::string name = "n" + std::to_string(count_++);
        write(name, kind.type, inputs + kind.more);
        values_[kind.gives].push_back("<" + name + "." + kind.output);
    }

    // Some inputs are left open, if the type has a default.
    void call(const std::string& name) {
        std::string inputs;
        for (const std::string type : input_types) {
            const bool open = type != "image" && random_() % 4 == 0;
            if (!open) inputs += (inputs.empty() ? "'in_" : ", 'in_") + type + "': " + value(type);
        }
        const std::string file = std::to_string(
            level_ + 1 + (level_ + 1 < deepest_ ? static_cast<int>(random_() % 2) : 0));
        write(name, "graph:" + file + ".json", inputs);
        for (const char* type : input_types)
            if (std::string(type) != "image") values_[type].push_back("<" + name + ".out_" + type);
    }

    std::string outputs() {
        if (level_ == 0)
            return "'height': " + value("height") + ", 'normal': " + value("gradient") +
                   ", 'extra': " + value("float") + ", 'turned': " + value("normal");
        std::string text;
        for (const std::string type : input_types)
            if (type != "image")
                text += (text.empty() ? "'out_" : ", 'out_") + type + "': " + value(type);
        return text;
    }

    std::mt19937& random_;
    const int level_, deepest_;
    int count_ = 0;
    std::map<std::string, std::vector<std::string>> values_;
    std::string nodes_;
};

}  // namespace

std::string graph_text(const std::string& inputs, const std::string& nodes,
                       const std::string& outputs) {
    return with_wires("{'wrinkle': 1, 'inputs': {" + inputs + "}, 'nodes': {" + nodes +
                      "}, 'outputs': {" + outputs + "}}");
}

Nested::Nested(const Texts& texts) {
    const std::string pictures = image_folder();
    for (const auto& [name, text] : texts)
        folder_.put(name + ".json", replaced(replaced(text, "IMAGE_A", pictures + "/a.exr"),
                                             "IMAGE_B", pictures + "/b.exr"));
    Diagnostics diagnostics;
    project_ = load_project(folder_.path() / "main.json", {"/", {}}, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << to_text(diagnostics);
}

Compiled Nested::compile(const Options& options) const {
    MaterialOptions material;
    material.uniform_parameters = options.uniform;
    material.given_differentials = options.given;
    material.vertex_tangents = options.vertex_tangents;
    material.lower.inline_up_to = options.functions ? 0 : ~0ULL;
    Diagnostics diagnostics;
    Compiled compiled = compile_material(project_, all_nodes(), material, diagnostics);
    EXPECT_TRUE(compiled.ok) << to_text(diagnostics);
    return compiled;
}

uint32_t function_count(const Module& module) {
    uint32_t count = 0;
    for (uint32_t i = 1; i < module.region_count(); ++i)
        count +=
            module.region(i).kind == RegionKind::function && !module.region(i).result_names.empty();
    return count;
}

Texts tower_texts(int levels) {
    Texts texts;
    for (int level = 0; level < levels; ++level) {
        const std::string file = "{'type': 'graph:" + std::to_string(level + 1) + ".json', 'in': ";
        const std::string from = level == 0 ? "<waves.height" : "<input.relief";
        const std::string nodes =
            "'low': {'type': 'height_scale', 'in': {'height': " + from + ", 'amount': 0.5}}, " +
            "'left': " + file + "{'relief': <low.height}}, 'high': {'type': 'height_scale', " +
            "'in': {'height': " + from + ", 'amount': 0.75}}, 'right': " + file +
            "{'relief': <high.height}}, 'both': {'type': 'height_add', 'in': {'a': " +
            "<left.relief, 'b': <right.relief}}";
        texts[level == 0 ? "main" : std::to_string(level)] =
            level == 0
                ? graph_text("", nodes + ", 'waves': {'type': 'waves'}",
                             "'height': <both.height, 'normal': <both.height")
                : graph_text("'relief': {'type': 'height'}", nodes, "'relief': <both.height");
    }
    texts[std::to_string(levels)] =
        graph_text("'relief': {'type': 'height'}",
                   "'least': {'type': 'height_min', 'in': {'a': <input.relief, 'b': 0.001}}",
                   "'relief': <least.height");
    return texts;
}

Texts random_texts(unsigned seed) {
    std::mt19937 random(seed);
    constexpr int deepest = 3;
    Texts texts;
    for (int level = 0; level <= deepest; ++level)
        texts[level == 0 ? "main" : std::to_string(level)] =
            RandomGraph(random, level, deepest).text();
    return texts;
}

}  // namespace wrinkle::test
