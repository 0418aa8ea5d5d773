// Tests of the attribution of lines and helper functions to nodes.
#include "cost/counted_shader.h"
#include "ir/op.h"

#include <gtest/gtest.h>

namespace wrinkle::test {
namespace {

// Lines, each with its node.
Shader shader_of(std::vector<std::pair<std::string, uint32_t>> lines) {
    Shader shader;
    for (const auto& [text, node] : lines) {
        shader.source += text + "\n";
        shader.reflection.lines.push_back(node);
    }
    OutputInfo& output = shader.reflection.outputs.emplace_back();
    output.output = "not an identifier";
    output.type = Type::vec3_;
    shader.reflection.function = "f";
    shader.reflection.node_paths = {"", "weave", "strap/tilt"};
    return shader;
}

// Source lines without #line directives, with the numbers set by those directives.
struct Numbered {
    std::vector<std::string> lines;
    std::vector<int> numbers;
};
Numbered numbered(const std::string& text) {
    Numbered result;
    int next = 1;
    for (size_t at = 0; at < text.size();) {
        const size_t end = text.find('\n', at);
        const std::string line = text.substr(at, end - at);
        at = end + 1;
        if (line.starts_with("#line ")) {
            next = std::stoi(line.substr(6));
            continue;
        }
        result.lines.push_back(line);
        result.numbers.push_back(next++);
    }
    return result;
}

TEST(CountedShader, CallsTheFunctionOnInterpolants) {
    Shader shader = shader_of({{"struct S {", no_node},
                               {"    vec3 normal;", no_node},
                               {"};", no_node},
                               {"vec3 f(S s) {", no_node},
                               {"    return s.normal;", 2},
                               {"}", no_node}});
    shader.reflection.struct_name = "S";
    shader.reflection.members = {{"normal", Type::vec3_}};
    const Numbered text = numbered(counted_shader(shader));
    const std::vector<std::string> lines = {
        "#version 450",
        "layout(location = 0) in vec3 counted_normal;",
        "layout(location = 0) out vec3 counted_0;",
        "struct S {",
        "    vec3 normal;",
        "};",
        "vec3 f(S s) {",
        "    return s.normal;",
        "}",
        "",
        "void main() { S surface; surface.normal = counted_normal; vec3 result = f(surface); "
        "counted_0 = result; }"};
    EXPECT_EQ(text.lines, lines);
    EXPECT_EQ(std::vector(text.numbers.begin() + 3, text.numbers.end()),
              (std::vector{1, 1, 1, 1, 3, 1, 1, 1}));
}

TEST(CountedShader, AFunctionWithoutArguments) {
    const Shader shader = shader_of({{"float f() {", no_node}, {"    return 1.0;", 1}, {"}", 0}});
    EXPECT_NE(counted_shader(shader).find("vec3 result = f(); counted_0 = result;"),
              std::string::npos);
}

// `inner` is called by `outer`, which is called by two nodes and the surface point.
Shader nested_shader() {
    return shader_of({{"float inner(float a) {", no_node},
                      {"    return a;", no_node},
                      {"}", no_node},
                      {"vec2 outer(float a,", no_node},
                      {"        float b) {", no_node},
                      {"    return vec2(inner(a), inner_x);", no_node},
                      {"}", no_node},
                      {"float f() {", no_node},
                      {"    float x = inner(0.0);", no_node},
                      {"    x += outer(x, x).x;", 1},
                      {"    return x + outer(x, x).y;", 2},
                      {"}", no_node}});
}

TEST(CountedShader, EachNodeHasItsCopyOfAHelper) {
    const Shader shader = nested_shader();
    const Numbered text = numbered(counted_shader(shader));
    std::string made;
    for (size_t i = 2; i + 2 < text.lines.size(); ++i) {
        const bool first = text.lines[i].find("__1") != std::string::npos;
        const bool second = text.lines[i].find("__2") != std::string::npos;
        if (first || second) {
            EXPECT_EQ(text.numbers[i], first ? 2 : 3) << text.lines[i];
        }
        made += text.lines[i] + "\n";
    }
    EXPECT_EQ(made, R"(float inner(float a) {
    return a;
}
float inner__1(float a) {
    return a;
}
float inner__2(float a) {
    return a;
}
vec2 outer(float a,
        float b) {
    return vec2(inner(a), inner_x);
}
vec2 outer__1(float a,
        float b) {
    return vec2(inner__1(a), inner_x);
}
vec2 outer__2(float a,
        float b) {
    return vec2(inner__2(a), inner_x);
}
float f() {
    float x = inner(0.0);
    x += outer__1(x, x).x;
    return x + outer__2(x, x).y;
}
)");
    EXPECT_EQ(text.numbers[2], 1);
    EXPECT_EQ(text.numbers[6], 2) << "the body is the node's too";
}

}  // namespace
}  // namespace wrinkle::test
