// Tests of wrinkle compile --target: written files and their names for each target.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

using TargetTest = CliTest;
using Names = std::vector<std::string>;

TEST_F(TargetTest, EveryOneIsListed) {
    const std::string list = run({"compile", "--list-targets"}).out;
    for (const char* name :
         {"glsl330", "glsl450", "essl300", "spirv", "hlsl", "msl", "wgsl", "godot3", "godot4"})
        EXPECT_TRUE(says(list, std::string(name) + "  "));
}

TEST_F(TargetTest, FilesAreCalledAfterStageAndLanguage) {
    put("g.json", tilt_graph());
    for (const auto& [target, end] : {std::pair{"glsl450", ""},
                                      {"essl300", ""},
                                      {"spirv", ".spv"},
                                      {"hlsl", ".hlsl"},
                                      {"msl", ".msl"},
                                      {"wgsl", ".wgsl"}}) {
        const std::string out = std::string("out-") + target + "/g";
        fs::create_directories(folder / fs::path(out).parent_path());
        const Ran ran = run({"compile", "g.json", "--form", "shader", "--target", target, "-o", out,
                             "--reflect", out + ".reflect", "-MD", "-MF", out + ".d"});
        ASSERT_EQ(ran.code, 0) << ran.err;
        for (const char* stage : {".vert", ".frag"}) {
            const std::string file = out + stage + end;
            EXPECT_NE(get(file), "") << file;
            EXPECT_TRUE(says(get(out + ".d"), file)) << get(out + ".d");
            EXPECT_EQ(run({"compile", "g.json", "--form", "shader", "--target", target, "--stage",
                           stage == std::string(".vert") ? "vertex" : "fragment"})
                          .out,
                      get(file));
        }
        const json::Value reflection = parsed(get(out + ".reflect"));
        EXPECT_EQ(reflection.find("target").as_string(), target);
        EXPECT_TRUE(says(get(out + ".d"), "g.json"));
    }
    EXPECT_TRUE(get("out-spirv/g.frag.spv").starts_with("\x03\x02\x23\x07"));
    EXPECT_TRUE(get("out-essl300/g.frag").starts_with("#version 300 es\n"));
    EXPECT_TRUE(get("out-glsl450/g.frag").starts_with("#version 450\n"));
    EXPECT_TRUE(says(get("out-hlsl/g.frag.hlsl"), "SV_Target0"));
    EXPECT_TRUE(says(get("out-msl/g.frag.msl"), "fragment WrinkleTargets_g g_fragment("));
}

TEST_F(TargetTest, SeveralGraphsGoIntoAFolder) {
    put("a.json", tilt_graph("0.5"));
    put("b.json", tilt_graph("0.25"));
    ASSERT_EQ(run({"compile", "a.json", "b.json", "--target", "spirv", "-o", "out"}).code, 0);
    EXPECT_EQ(files(), (Names{"a.json", "b.json", "out", "out/a.frag.spv", "out/a.vert.spv",
                              "out/b.frag.spv", "out/b.vert.spv"}));
}

TEST_F(TargetTest, AFormThatATargetLacksIsWrongUsage) {
    put("g.json", tilt_graph());
    for (const auto& [target, form, other] :
         {std::tuple("spirv", "function", "shader"), std::tuple("godot3", "shader", "function"),
          std::tuple("godot4", "shader", "function")}) {
        const Ran ran = run({"compile", "g.json", "--target", target, "--form", form});
        EXPECT_EQ(ran.code, 2);
        EXPECT_TRUE(says(ran.err, std::string("--form ") + other)) << ran.err;
        EXPECT_EQ(run({"compile", "g.json", "--target", target}).code, 0);
    }
    const Ran ran = run({"compile", "g.json", "--target", "spirv", "--differentials", "given"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(files(), Names{"g.json"});
}

TEST_F(TargetTest, FunctionsOfSeveralGraphsHaveTheSuffixOfTheLanguage) {
    put("a.json", tilt_graph("0.5"));
    put("b.json", tilt_graph("0.25"));
    for (const auto& [target, end] : {std::pair("essl300", ".glsl"), std::pair("hlsl", ".hlsl"),
                                      std::pair("godot4", ".gdshaderinc")}) {
        const std::string out = std::string("out-") + target;
        ASSERT_EQ(run({"compile", "a.json", "b.json", "--target", target, "-o", out}).code, 0);
        EXPECT_TRUE(says(get(out + "/b" + end), "wrinkle_b(")) << target;
    }
}

TEST_F(TargetTest, BindingsBeginWhereAsked) {
    put("g.json", ramp_graph());
    const Ran ran = run({"compile", "g.json", "--target", "glsl450", "--params", "uniform",
                         "--descriptor-set", "2", "--first-binding", "7"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(says(ran.out, "layout(std140, set = 2, binding = 7) uniform WrinkleParameters_g"));
    EXPECT_EQ(run({"compile", "g.json", "--first-binding", "-1"}).code, 2);
}

// The compiler module is loaded only for the targets that require it.
TEST_F(TargetTest, AMissingModuleIsTheEnvironmentsFault) {
    put("g.json", tilt_graph());
    fs::create_directories(folder / "alone/bin");
    fs::copy(WRINKLE_BINARY_DIR "/bin/wrinkle", folder / "alone/bin/wrinkle");
    const auto alone = [&](const std::string& arguments) {
        const std::string command = "cd '" + folder.string() + "' && env -u WRINKLE_MODULE_PATH " +
                                    "alone/bin/wrinkle compile g.json " + arguments + " 2>err";
        const int status = std::system(command.c_str());
        return WEXITSTATUS(status);
    };
    EXPECT_EQ(alone("-o g.glsl"), 0) << get("err");
    EXPECT_EQ(alone("--target glsl450 --form shader -o g"), 0) << get("err");
    EXPECT_EQ(alone("--target spirv -o x"), 3);
    EXPECT_EQ(alone("--cost"), 3);
    EXPECT_TRUE(says(get("err"), "WRINKLE_MODULE_PATH"));
    EXPECT_FALSE(exists("x.frag.spv"));
}

TEST_F(TargetTest, OutputIsTheSameInEveryLocale) {
    put("g.json", ramp_graph("0.5"));
    for (const char* target : {"spirv", "hlsl", "msl", "wgsl"}) {
        const Names arguments{"compile", "g.json", "--target", target};
        const Ran plain = run(arguments);
        ASSERT_EQ(plain.code, 0) << plain.err;
        EXPECT_EQ(run(arguments, "", {"LC_ALL=de_DE.UTF-8", "LANG=de_DE.UTF-8"}).out, plain.out);
    }
}

std::string png(int bits) {
    const std::string bytes("\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1", 24);
    return bytes + static_cast<char>(bits);
}

// The graph is compiled without reading more than the header of the image.
class SrgbTest : public CliTest {
protected:
    Ran compile(Names more = {}) {
        put("g.json", R"({"wrinkle": 1,
            "nodes": {"paint": {"type": "image", "in": {"image": "paint.png"}}},
            "outputs": {"color": {"from": "paint.color"}}})");
        more.insert(more.begin(), {"compile", "g.json", "--reflect", "r.json"});
        return run(more);
    }
    json::Value upload() { return parsed(get("r.json")).find("samplers").at(0).find("upload"); }
};

TEST_F(SrgbTest, IsDecodedByTheSamplerOrByTheText) {
    put("paint.png", png(8));
    const Ran sampler = compile();
    EXPECT_EQ(sampler.code, 0);
    EXPECT_EQ(sampler.err, "");
    EXPECT_FALSE(says(sampler.out, "pow(")) << sampler.out;
    EXPECT_TRUE(says(sampler.out, "// paint.png (srgb, repeat)")) << sampler.out;
    EXPECT_EQ(upload().find("color_space").as_string(), "srgb");
    EXPECT_EQ(upload().find("u8").as_string(), "srgb8_alpha8");
    EXPECT_EQ(upload().find("u16").as_string(), "rgba16");
    EXPECT_EQ(upload().find("first_row").as_string(), "bottom");

    const Ran shader = compile({"--srgb", "shader"});
    EXPECT_EQ(shader.code, 0);
    EXPECT_TRUE(says(shader.out, "pow(")) << shader.out;
    EXPECT_TRUE(says(shader.out, "// paint.png (srgb as stored, repeat)")) << shader.out;
    EXPECT_EQ(upload().find("color_space").as_string(), "linear");
    EXPECT_EQ(upload().find("u8").as_string(), "rgba8");
}

TEST_F(SrgbTest, IsAHintOfGodotIfTheSamplerDecodes) {
    put("paint.png", png(8));
    for (const auto& [target, hint] :
         {std::pair("godot3", "hint_albedo"), std::pair("godot4", "source_color")}) {
        const std::string declaration = "uniform sampler2D g_paint_image";
        const Ran sampler = compile({"--target", target});
        EXPECT_TRUE(says(sampler.out, declaration + " : " + hint + ";")) << sampler.out;
        const Ran shader = compile({"--target", target, "--srgb", "shader"});
        EXPECT_TRUE(says(shader.out, declaration + ";")) << shader.out;
    }
    EXPECT_TRUE(says(compile().out, "uniform sampler2D g_paint_image;"));
}

TEST_F(SrgbTest, OfSixteenBitsIsAWarningUnlessTheTextDecodes) {
    put("paint.png", png(16));
    const Ran ran = compile();
    EXPECT_EQ(ran.code, 0);
    EXPECT_TRUE(says(ran.err, "g.json:2:")) << ran.err;
    EXPECT_TRUE(says(ran.err, "warning: node 'paint': image 'paint.png' has 16 bits")) << ran.err;
    EXPECT_EQ(compile({"--srgb", "shader"}).err, "");
    const Names cached{"--cache", "cache"};
    EXPECT_EQ(compile(cached).err, ran.err);
    EXPECT_EQ(compile(cached).err, ran.err);
    put("paint.png", png(8));
    EXPECT_EQ(compile(cached).err, "");
}

}  // namespace
}  // namespace wrinkle::test
