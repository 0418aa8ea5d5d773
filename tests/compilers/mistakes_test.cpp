// Tests of error messages for mistakes in node declarations, with both compilers: the first line
// with an error names the correction, or the fault in the body.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace wrinkle {
namespace {

struct Mistake {
    const char* name;
    const char* declaration;  // follows node(...)
    const char* wanted;       // text in the first line with an error; "" if it compiles
    int max_errors = 1;       // 2 if another error reports the first one as part of the body
};
void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}

constexpr const char* choose = "write select(condition, a, b) in place of if and ?:";
constexpr const char* parameters = "the body's parameters must match the declared inputs";

const Mistake mistakes[] = {
    {"IfOnACondition", R"(.in<Float>("a", 0, "A").out<Float>("o", "O")
        .body([](Float a) -> Float { if (a > 0) return a; return 0; }))",
     choose},
    {"IfOnANumber", R"(.in<Float>("a", 0, "A").out<Float>("o", "O")
        .body([](Float a) -> Float { if (a) return a; return 0; }))",
     choose},
    {"ConditionalOperator", R"(.in<Float>("a", 0, "A").out<Float>("o", "O")
        .body([](Float a) { return a > 0 ? a : -a; }))",
     choose},
    {"IfInAGenericBody", R"(.in<Float>("a", 0, "A").out<Float>("o", "O")
        .body([](auto a) { if (a > 0) return a; return -a; }))",
     choose},
    {"WhileOnACondition", R"(.in<Float>("a", 0, "A").out<Float>("o", "O")
        .body([](Float a) { while (a < 1) a = a + 1; return a; }))",
     "loop() in place of while"},
    {"ErrorInABody", R"(.in<Float>("a", 0, "A").out<Float>("o", "O")
        .body([](Float a) { return a.nope(); }))",
     "nope"},
    {"ErrorInABodyWithoutParameters", R"(.out<Float>("o", "O")
        .body([] { return Float(1).nope(); }))",
     "nope", 2},
    {"ErrorInABodyThatTakesAStruct", R"(.in<Float>("a", 0, "A").in<Float>("b", 0, "B")
        .out<Float>("o", "O").body([](Two in) { return in.nope; }))",
     "nope"},
    {"ErrorInAGenericBody", R"(.in<Float>("a", 0, "A").in<Float>("b", 0, "B")
        .out<Float>("o", "O").body([](auto a, auto b) { return a.nope() + b; }))",
     "nope", 2},
    {"OtherParameters", R"(.in<Float>("a", 0, "A").out<Float>("o", "O")
        .body([](vec2 a) { return a.x(); }))",
     parameters},
    {"TooManyParameters", R"(.out<Float>("o", "O").body([](Float a) { return a; }))", parameters},
    {"TooFewParametersOfAGenericBody", R"(.in<Float>("a", 0, "A").in<Float>("b", 0, "B")
        .out<Float>("o", "O").body([](auto a) { return a + 2; }))",
     "it must have as many parameters as there are inputs"},
    {"InputOfTypeFloat", R"(.in<float>("a", 0, "A").out<Float>("o", "O")
        .body([](Float a) { return a; }))",
     "write .in<Float>"},
    {"OutputOfTypeDouble", R"(.in<Float>("a", 0, "A").out<double>("o", "O")
        .body([](Float a) { return a; }))",
     ".out<Float>"},
    {"InputOfTypeInt", R"(.in<int>("a", 0, "A").out<Float>("o", "O")
        .body([](Float a) { return a; }))",
     "write .count("},
    {"InputOfTypeBool", R"(.in<bool>("a", 0, "A").out<Float>("o", "O")
        .body([](Float a) { return a; }))",
     "write .flag("},
    {"InputOfAnotherType", R"(.in<Two>("a", "A").out<Float>("o", "O")
        .body([](Float a) { return a; }))",
     "the type of a port is Float, vec2"},
    {"FunctionOfAProperty", R"(.out<vec3>("o", "O").body([] {
            return normalize(surface::normal) * dot(surface::view, surface::normal) +
                   mix(surface::position, surface::view, 0.5) * length(surface::uv0);
        }))",
     ""},
    {"ConditionWithABool", R"(.in<Float>("a", 0, "A").flag("f", true, "F").out<Float>("o", "O")
        .body([](Float a, bool f) { return select((a > 0 && f) || (f && !(a > 1)), a, 2.0); }))",
     ""},
};

class Mistakes : public testing::TestWithParam<Mistake> {
protected:
    // Returns the lines with errors.
    static std::vector<std::string> errors(const std::string& compiler, const Mistake& mistake) {
        const auto file = std::filesystem::temp_directory_path() /
                          ("wrinkle_mistake_" + std::to_string(getpid()) + ".cpp");
        std::ofstream(file) << "#include <wrinkle/node.h>\nusing namespace wrinkle::sdk;\n"
                               "struct Two { Float a, b; };\n"
                               "static Node n = node(\"n\", \"N\", \"Doc.\")"
                            << mistake.declaration << ";\nWRINKLE_PLUGIN(\"n\", \"1\", n)\n";
        FILE* pipe =
            popen((compiler + " -std=c++20 -fsyntax-only -I" WRINKLE_SOURCE_DIR "/core/sdk " +
                   file.string() + " 2>&1")
                      .c_str(),
                  "r");
        std::vector<std::string> lines;
        char line[4096];
        while (pipe && fgets(line, sizeof line, pipe))
            if (std::string(line).find("error:") != std::string::npos) lines.emplace_back(line);
        EXPECT_EQ(pipe && pclose(pipe) == 0, lines.empty()) << compiler;
        std::filesystem::remove(file);
        return lines;
    }
};

TEST_P(Mistakes, FirstErrorSaysWhatToWrite) {
    const Mistake& mistake = GetParam();
    for (const std::string compiler : {OWN_COMPILER, OTHER_COMPILER}) {
        if (compiler.ends_with("NOTFOUND")) continue;
        const auto lines = errors(compiler, mistake);
        if (!*mistake.wanted) {
            EXPECT_TRUE(lines.empty()) << compiler << "\n" << lines[0];
            continue;
        }
        ASSERT_FALSE(lines.empty()) << compiler;
        EXPECT_NE(lines[0].find(mistake.wanted), std::string::npos) << compiler << "\n" << lines[0];
        EXPECT_LE(lines.size(), size_t(mistake.max_errors)) << compiler << "\n" << lines.back();
    }
}

INSTANTIATE_TEST_SUITE_P(Node, Mistakes, testing::ValuesIn(mistakes),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace wrinkle
