// Tests of wrinkle compile: destination of the output, and the behaviour that build systems rely
// on.
#include <chrono>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

using CompileTest = CliTest;
using Names = std::vector<std::string>;

TEST_F(CompileTest, FileAndStandardOutputHoldTheSameText) {
    put("bump.json", tilt_graph());
    const Ran printed = run({"compile", "bump.json"});
    ASSERT_EQ(printed.code, 0) << printed.err;
    EXPECT_TRUE(says(printed.out, "wrinkle_bump("));
    EXPECT_EQ(printed.out.find("#version"), printed.out.npos);
    const Ran filed = run({"compile", "bump.json", "-o", "out.glsl"});
    EXPECT_EQ(filed.code, 0);
    EXPECT_EQ(filed.out + filed.err, "");
    EXPECT_EQ(get("out.glsl"), printed.out);
}

TEST_F(CompileTest, ReadsStandardInputWhenAsked) {
    put("bump.json", tilt_graph());
    const Ran ran = run({"compile", "-", "--name", "bump"}, tilt_graph());
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out, run({"compile", "bump.json"}).out);
}

TEST_F(CompileTest, EqualBytesLeaveTheFileUntouched) {
    put("g.json", tilt_graph("0.5"));
    ASSERT_EQ(run({"compile", "g.json", "-o", "g.glsl"}).code, 0);
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(5);
    fs::last_write_time(folder / "g.glsl", old);
    const auto before = fs::last_write_time(folder / "g.glsl");
    ASSERT_EQ(run({"compile", "g.json", "-o", "g.glsl"}).code, 0);
    EXPECT_EQ(fs::last_write_time(folder / "g.glsl"), before);
    put("g.json", tilt_graph("0.625"));
    ASSERT_EQ(run({"compile", "g.json", "-o", "g.glsl"}).code, 0);
    EXPECT_NE(fs::last_write_time(folder / "g.glsl"), before);
}

TEST_F(CompileTest, ShaderFormIsAPair) {
    put("g.json", tilt_graph());
    ASSERT_EQ(run({"compile", "g.json", "--form", "shader", "-o", "g"}).code, 0);
    EXPECT_EQ(files(), (Names{"g.frag", "g.json", "g.vert"}));
    EXPECT_TRUE(get("g.vert").starts_with("#version 330"));
    EXPECT_EQ(run({"compile", "g.json", "--form", "shader"}).out, get("g.frag"));
    EXPECT_EQ(run({"compile", "g.json", "--form", "shader", "--stage", "vertex"}).out,
              get("g.vert"));
}

constexpr const char* two_outputs = R"({"wrinkle": 1, "nodes": {
    "lumps": {"type": "gradient_noise", "in": {"octaves": 2}},
    "normal": {"type": "resolve", "in": {"gradient": {"from": "lumps.height"}}}},
    "outputs": {"displacement": {"from": "lumps.height"}, "normal": {"from": "normal.normal"}}})";

TEST_F(CompileTest, OneFunctionComputesTheSelectedOutputs) {
    put("g.json", two_outputs);
    const std::string all = run({"compile", "g.json"}).out;
    EXPECT_TRUE(says(all, "WrinkleMaterial_g wrinkle_g(WrinkleSurface_g s) {"));
    EXPECT_EQ(run({"compile", "g.json", "--outputs", "displacement,normal"}).out, all);
    const std::string normal = run({"compile", "g.json", "--outputs", "normal"}).out;
    EXPECT_TRUE(says(normal, "\nvec3 wrinkle_g(WrinkleSurface_g s) {"));
    EXPECT_EQ(normal.find("WrinkleMaterial"), normal.npos);
    const Ran wrong = run({"compile", "g.json", "--outputs", "normal,color", "-o", "g.glsl"});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_TRUE(says(wrong.err, "no output 'color' (it has displacement, normal)"));
    EXPECT_FALSE(exists("g.glsl"));
}

TEST_F(CompileTest, ADisplacementAloneIsForAVertexStage) {
    put("g.json", two_outputs);
    const std::string vertex = run({"compile", "g.json", "--outputs", "displacement"}).out;
    EXPECT_TRUE(says(vertex, "\nfloat wrinkle_g(WrinkleSurface_g s) {"));
    EXPECT_EQ(vertex.find("dFdx"), vertex.npos) << vertex;
    EXPECT_TRUE(says(
        run({"compile", "g.json", "--outputs", "displacement", "--differentials", "screen"}).out,
        "dFdx"));
    const Ran pair = run({"compile", "g.json", "--form", "shader", "--differentials", "none"});
    EXPECT_EQ(pair.code, 2);
    EXPECT_TRUE(says(pair.err, "from the screen"));
}

TEST_F(CompileTest, TheCacheKnowsTheSelectedOutputs) {
    put("g.json", two_outputs);
    std::string texts[2];
    for (int round = 0; round < 2; ++round)
        for (const char* output : {"normal", "displacement"}) {
            const std::string text =
                run({"compile", "g.json", "--cache", "kept", "--outputs", output}).out;
            std::string& first = texts[output == std::string_view("normal")];
            if (round == 0) first = text;
            EXPECT_EQ(text, first);
        }
    EXPECT_NE(texts[0], texts[1]);
}

TEST_F(CompileTest, SeveralGraphsGoIntoAFolder) {
    put("a.json", tilt_graph("0.5"));
    put("sub/b.json", tilt_graph("0.25"));
    const Ran ran = run({"compile", "a.json", "sub/b.json", "-o", "out"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(says(get("out/a.glsl"), "wrinkle_a("));
    EXPECT_TRUE(says(get("out/b.glsl"), "wrinkle_b("));
}

TEST_F(CompileTest, EqualStemsAreRefused) {
    put("a.json", tilt_graph());
    put("sub/a.json", tilt_graph());
    const Ran ran = run({"compile", "a.json", "sub/a.json", "-o", "out"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_TRUE(says(ran.err, "'a'"));
    EXPECT_FALSE(exists("out"));
}

TEST_F(CompileTest, OneBadGraphOfSeveralKeepsTheOthers) {
    put("a.json", tilt_graph("0.5"));
    put("b.json", "{\"wrinkle\": 1, \"nodes\": 5}");
    put("c.json", tilt_graph("0.25"));
    const Ran ran = run({"compile", "a.json", "b.json", "none.json", "c.json", "-o", "out", "-MD"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "b.json:1:"));
    EXPECT_TRUE(says(ran.err, "none.json"));
    EXPECT_EQ(files(), (Names{"a.json", "b.json", "c.json", "out", "out/a.glsl", "out/c.glsl"}));
}

TEST_F(CompileTest, OneOutputThatCannotBeWrittenKeepsTheOthers) {
    put("a.json", tilt_graph("0.5"));
    put("b.json", tilt_graph("0.25"));
    put("out/a.glsl/in_the_way", "");
    const Ran ran = run({"compile", "a.json", "b.json", "-o", "out", "--diagnostics", "json"});
    EXPECT_EQ(ran.code, 3);
    EXPECT_TRUE(exists("out/b.glsl"));
    const json::Value said = parsed(ran.err).find("diagnostics").at(0);
    EXPECT_TRUE(says(std::string(said.find("message").as_string()), "out/a.glsl"));
}

TEST_F(CompileTest, AnyNumberOfJobsWritesTheSame) {
    Names args{"compile", "-o"};
    for (int i = 0; i < 30; ++i) {
        const std::string name = "g" + std::to_string(i) + ".json";
        put(name, i % 7 == 3 ? "{" : tilt_graph("0." + std::to_string(i + 1)));
        args.push_back(name);
    }
    Ran before;
    for (const std::string jobs : {"1", "2", "7"}) {
        Names call = args;
        call.insert(call.begin() + 2, "out" + jobs);
        call.push_back("-j" + jobs);
        const Ran ran = run(call);
        EXPECT_EQ(ran.code, 1);
        if (jobs != "1") {
            EXPECT_EQ(ran.err, before.err);
        }
        before = ran;
        for (int i = 0; i < 30; ++i) {
            const std::string name = "/g" + std::to_string(i) + ".glsl";
            EXPECT_EQ(exists("out" + jobs + name), i % 7 != 3);
            if (i % 7 != 3) {
                EXPECT_EQ(get("out" + jobs + name), get("out1" + name));
            }
        }
    }
}

TEST_F(CompileTest, ReflectionsOfSeveralGraphsGoIntoAFolder) {
    put("a.json", tilt_graph());
    put("b.json", tilt_graph());
    ASSERT_EQ(run({"compile", "a.json", "b.json", "-o", "out", "--reflect", "out"}).code, 0);
    EXPECT_TRUE(says(get("out/a.json"), "\"wrinkle_a\""));
    EXPECT_TRUE(says(get("out/b.json"), "\"wrinkle_b\""));
}

TEST_F(CompileTest, DepfileNamesWhatTheTextDependsOn) {
    put("inner.json", R"({"wrinkle": 1, "nodes": {
        "m": {"type": "multiply", "in": {"a": 2, "b": 3}}},
        "outputs": {"result": {"from": "m.result"}}})");
    put("my top.json", R"({"wrinkle": 1, "nodes": {"sub": {"type": "graph:inner.json"}},
        "outputs": {"roughness": {"from": "sub.result"}}})");
    const Ran ran =
        run({"compile", "my top.json", "-o", "g.glsl", "-MD", "-MF", "g.d", "-MT", "some target"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const std::string rule = get("g.d");
    EXPECT_TRUE(rule.starts_with("some\\ target:")) << rule;
    EXPECT_TRUE(says(rule, "my\\ top.json"));
    EXPECT_TRUE(says(rule, "inner.json"));
}

TEST_F(CompileTest, DepfileOfSeveralGraphsHasARuleForEach) {
    put("sub/a.json", tilt_graph());
    put("b.json", tilt_graph());
    ASSERT_EQ(run({"compile", "sub/a.json", "b.json", "-o", "out", "-MD", "-MP"}).code, 0);
    EXPECT_EQ(get("out.d"),
              "out/a.glsl: \\\n  sub/a.json\nout/b.glsl: \\\n  b.json\n"
              "\nsub/a.json:\n\nb.json:\n");
    ASSERT_EQ(run({"compile", "sub/a.json", "b.json", "-o", "out", "-MD", "-MT", "all"}).code, 0);
    EXPECT_EQ(get("out.d"), "all: \\\n  sub/a.json \\\n  b.json\n");
}

TEST_F(CompileTest, WordsComeFromAFile) {
    put("my g.json", tilt_graph());
    put("flags", "--name 'the \"name\"'\n -o\tout\\ put.glsl");
    put("all.rsp", "compile\n\"my g.json\" @flags");
    const Ran ran = run({"@all.rsp"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(get("out put.glsl"), run({"compile", "my g.json", "--name", "the \"name\""}).out);
}

TEST_F(CompileTest, RefusesAFileOfWordsThatIsNone) {
    put("open", "compile 'g.json");
    put("itself", "@itself @itself");
    put("one", "@two");
    put("two", "@./one");
    std::string words;
    while (words.size() < 2'000'000)
        words += "word ";
    put("large", words + "@large");
    for (int i = 0; i < 20; ++i)
        put("deep" + std::to_string(i), "@deep" + std::to_string(i + 1));
    put("thousand", [] {
        std::string text;
        for (int i = 0; i < 1001; ++i)
            text += "@empty ";
        return text;
    }());
    put("empty", "");
    put("laughs", "@long @long @long @long @long @long @long @long @long");
    put("long", words);
    memory = rlim_t{2} << 30;
    for (const auto& [word, fault] : {std::pair{"@none", "none: cannot be read"},
                                      {"@open", "open: a quote is not closed"},
                                      {"@itself", "itself: names itself"},
                                      {"@one", "./one: names itself, or a file that names it"},
                                      {"@large", "large: names itself"},
                                      {"@deep0", "deep16: is more than 16 files deep"},
                                      {"@thousand", "empty: is one of more than 1000 files"},
                                      {"@laughs", "long: these words are of more than 16 MB"}}) {
        const Ran ran = run({word});
        EXPECT_EQ(ran.code, 2) << word;
        EXPECT_TRUE(says(ran.err, fault)) << word;
    }
}

TEST_F(CompileTest, SetChangesAValue) {
    put("g.json", tilt_graph("0.5"));
    put("h.json", tilt_graph("0.25"));
    const Ran ran = run({"compile", "g.json", "--name", "x", "--set", "tilt.volume=[0.25, 0, 0]"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out, run({"compile", "h.json", "--name", "x"}).out);
    EXPECT_EQ(get("g.json"), tilt_graph("0.5"));
}

// A graph that adds `count` normal maps of as many images.
std::string layered_graph(int count) {
    std::string nodes, sum = "m0";
    for (int i = 0; i < count; ++i) {
        const std::string n = std::to_string(i);
        nodes += R"("m)" + n + R"(": {"type": "tangent_normal_map", "in": {"image": "i)" + n +
                 R"(.png"}}, )";
        if (i == 0) continue;
        nodes += R"("s)" + n + R"(": {"type": "gradient_add", "in": {"a": {"from": ")" + sum +
                 R"(.gradient"}, "b": {"from": "m)" + n + R"(.gradient"}}}, )";
        sum = "s" + n;
    }
    return R"({"wrinkle": 1, "nodes": {)" + nodes +
           R"("r": {"type": "resolve", "in": {"gradient": {"from": ")" + sum +
           R"(.gradient"}}}}, "outputs": {"normal": {"from": "r.normal"}}})";
}

TEST_F(CompileTest, MoreImagesThanTextureUnitsAreNamed) {
    for (int i = 0; i < 17; ++i)
        put("i" + std::to_string(i) + ".png", "");
    put("most.json", layered_graph(16));
    const Ran most = run({"compile", "most.json", "--strict"});
    EXPECT_EQ(most.code, 0) << most.err;
    EXPECT_EQ(most.err, "");
    put("more.json", layered_graph(17));
    const Ran warned = run({"compile", "more.json", "-o", "more.glsl"});
    EXPECT_EQ(warned.code, 0) << warned.err;
    EXPECT_TRUE(exists("more.glsl"));
    EXPECT_TRUE(says(warned.err, "warning: it reads 17 images")) << warned.err;
    for (int i = 0; i < 17; ++i)
        EXPECT_TRUE(says(warned.err, "i" + std::to_string(i) + ".png (m" + std::to_string(i) + ")"))
            << warned.err;
    const Ran refused = run({"compile", "more.json", "-o", "none.glsl", "--strict"});
    EXPECT_EQ(refused.code, 1);
    EXPECT_TRUE(says(refused.err, "error: it reads 17 images")) << refused.err;
    EXPECT_FALSE(exists("none.glsl"));
}

TEST_F(CompileTest, RefusesWrongUsage) {
    put("g.json", tilt_graph());
    const std::vector<Names> cases = {
        {"compile"},
        {"compile", "g.json", "--target", "pascal"},
        {"compile", "g.json", "--form", "poem"},
        {"compile", "g.json", "--form", "shader", "--differentials", "given"},
        {"compile", "g.json", "g.json"},
        {"compile", "g.json", "--set", "tilt.volume=0:1:3", "-o", "g.glsl"},
        {"compile", "g.json", "--nonsense"},
        {"compile", "g.json", "--reflect", "-"},
        {"compile", "g.json", "-MD"},
        {"compile", "g.json", "-o", "g.glsl", "--reflect", "-", "-MD", "-MF", "-"},
        {"compile", "g.json", "-o", "x", "--reflect", "x"},
        {"compile", "g.json", "--form", "shader", "-o", "x", "--reflect", "x.frag"},
        {"compile", "g.json", "-o", "g.glsl", "-MF", "g.d"},
        {"compile", "g.json", "-o", "g.glsl", "-MT", "g"},
        {"compile", "g.json", "-o", "g.glsl", "-MP"},
        {"compile", "g.json", "h.json"},
        {"compile", "g.json", "h.json", "-o", "out", "--reflect", "-"},
        {"compile", "g.json", "-j", "0"},
        {"compile", "g.json", "--cache-size", "much"},
    };
    for (const auto& args : cases) {
        const Ran ran = run(args, "x");
        EXPECT_EQ(ran.code, 2) << testing::PrintToString(args) << ran.err;
        EXPECT_EQ(ran.out, "");
        EXPECT_NE(ran.err, "");
        EXPECT_EQ(ran.read, 0);
        EXPECT_EQ(files(), Names{"g.json"});
    }
}

TEST_F(CompileTest, AllFilesAreWrittenOrNone) {
    put("g.json", tilt_graph());
    for (const Names& more : {Names{"--reflect", "none/g.json"}, Names{"-MD", "-MF", "none/g.d"},
                              Names{"--form", "shader", "--reflect", "none/g.json"}}) {
        Names args{"compile", "g.json", "-o", "g.glsl"};
        args.insert(args.end(), more.begin(), more.end());
        const Ran ran = run(args);
        EXPECT_EQ(ran.code, 3);
        EXPECT_TRUE(says(ran.err, "none/g."));
        EXPECT_EQ(files(), Names{"g.json"});
    }
}

TEST_F(CompileTest, SaysThatAnOutputCannotBeWritten) {
    put("g.json", tilt_graph());
    const Ran ran = run({"compile", "g.json", "-o", "g.json/out.glsl"});
    EXPECT_EQ(ran.code, 3);
    EXPECT_TRUE(says(ran.err, "g.json/out.glsl"));
    EXPECT_EQ(files(), Names{"g.json"});
}

}  // namespace
}  // namespace wrinkle::test
