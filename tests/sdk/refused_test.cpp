// Tests of declarations that must not compile, with their error messages.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace wrinkle::testing {
namespace {

std::string output_of(const std::string& command) {
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return "cannot run " + command;
    char part[4096];
    while (const size_t size = fread(part, 1, sizeof part, pipe))
        text.append(part, size);
    const int status = pclose(pipe);
    return (status == 0 ? "compiled\n" : "refused\n") + text;
}

std::string compile(const std::string& declaration) {
    const std::string path = std::string(WRINKLE_BINARY_DIR) + "/refused_declaration.cpp";
    std::ofstream(path) << "#include \"wrinkle/node.h\"\n"
                           "using namespace wrinkle::sdk;\n"
                           "struct Two { Float a, b; };\n"
                           "int outside = 0;\n"
                           "Node n = node(\"n\", \"N\", \"Doc.\")"
                        << declaration << ";\n";
    return output_of(std::string(WRINKLE_CXX_COMPILER) + " -std=c++20 -fsyntax-only -I" +
                     WRINKLE_SOURCE_DIR "/core/sdk " + path + " 2>&1");
}

void expect_refused(const std::string& declaration, const std::string& why) {
    const std::string text = compile(declaration);
    EXPECT_EQ(text.rfind("refused", 0), 0u) << declaration;
    EXPECT_NE(text.find(why), std::string::npos) << text;
}

const std::string in = R"(.in<Float>("a", 0, "In"))";
const std::string out = R"(.out<Float>("out", "Out"))";

TEST(Refused, ButThisOneCompiles) {
    const std::string text = compile(in + out + ".body([](Float a) { return a; })");
    EXPECT_EQ(text, "compiled\n");
}

TEST(Refused, BodyWithOtherParameters) {
    const std::string why = "the body's parameters must match the declared inputs";
    expect_refused(in + out + ".body([](vec3 a) { return a.x(); })", why);
    expect_refused(in + out + ".body([](Float a, Float b) { return a + b; })", why);
    expect_refused(in + out + ".body([](Two in) { return in.a; })", why);  // a struct too large
}

TEST(Refused, BodyWithAnotherResult) {
    const std::string why = "the body must return the declared output";
    expect_refused(in + out + ".body([](Float a) { return vec2(a); })", why);
    expect_refused(in + out + out + ".body([](Float a) { return a; })", why);
    expect_refused(in + out + out + ".body([](Float a) { return std::tuple{a, vec3(a)}; })", why);
}

TEST(Refused, BodyWithState) {
    expect_refused(out + ".body([x = outside]() { return Float(x); })", "a node has no state");
}

TEST(Refused, NodeWithoutOutput) {
    expect_refused(in + ".body([](Float a) { return a; })", "a node needs an output");
}

TEST(Refused, SwizzleBeyondTheVector) {
    expect_refused(out + ".body([]() { return vec2(0, 0).swizzle<\"z\">(); })",
                   "the vector has no such components");
}

}  // namespace
}  // namespace wrinkle::testing
