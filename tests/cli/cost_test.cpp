// Tests of wrinkle compile --cost: printed tables, written files, and errors if a compiler is
// missing.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

using CostTest = CliTest;
using Names = std::vector<std::string>;

const std::string samples = WRINKLE_SOURCE_DIR "/graphs/";

json::Value cost_in(const Ran& ran, size_t graph = 0) {
    return parsed(ran.out).find("graphs").at(graph).find("cost");
}

double number_of(const json::Value& cost, std::string_view name) {
    return cost.find(name).as_number();
}

// tests/cost/cost_table.py checks the totals: it counts with other programs.
TEST_F(CostTest, SaysWhatEachNodeCosts) {
    const Ran ran = run({"compile", samples + "base_and_detail.json", "--cost"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(says(ran.out, "2 of 16 texture units"));
    EXPECT_EQ(ran.out.find("wrinkle_base_and_detail"), ran.out.npos) << ran.out;
    EXPECT_EQ(files(), Names{});
    for (const char* node : {"normal", "base", "detail", "tile"})
        EXPECT_TRUE(says(ran.out, std::string("  ") + node + "\n"));
    const Ran json = run({"compile", samples + "base_and_detail.json", "--cost", "--json"});
    const json::Value cost = cost_in(json);
    EXPECT_EQ(number_of(cost.find("total"), "texture_reads"), 2);
    EXPECT_EQ(number_of(cost.find("total"), "texture_units"), 2);
    EXPECT_EQ(number_of(cost.find("total"), "divisions"), 0);
    double alu = number_of(cost.find("surface_point"), "alu");
    for (size_t i = 0; i < cost.find("nodes").size(); ++i)
        alu += number_of(cost.find("nodes").at(i), "alu");
    EXPECT_EQ(alu, number_of(cost.find("total"), "alu"));
    EXPECT_EQ(parsed(json.out).find("graphs").at(0).find("file").as_string(),
              samples + "base_and_detail.json");
}

// Two nodes call the noise function; its cost is attributed to the callers, once for each.
TEST_F(CostTest, WhoCallsAFunctionPaysForIt) {
    const json::Value cost =
        cost_in(run({"compile", samples + "noise_rock.json", "--cost", "--json"}));
    const double total = number_of(cost.find("total"), "alu");
    EXPECT_EQ(cost.find("nodes").at(0).find("node").as_string(), "lumps");
    EXPECT_EQ(cost.find("nodes").at(1).find("node").as_string(), "cracks");
    EXPECT_GT(number_of(cost.find("nodes").at(0), "alu"), total * 0.4);
    EXPECT_GT(number_of(cost.find("nodes").at(1), "alu"), total * 0.2);
    EXPECT_LT(number_of(cost.find("surface_point"), "alu"), total * 0.05);
}

TEST_F(CostTest, EveryOctaveCosts) {
    const auto cost_of = [&](const char* octaves, const char* part) {
        put("g.json", std::string(R"({"wrinkle": 1, "nodes": {"n": {"type": "fbm", "in": {)") +
                          R"("octaves": )" + octaves +
                          R"(}}}, "outputs": {"x": {"from": "n.value"}}})");
        return number_of(cost_in(run({"compile", "g.json", "--cost", "--json"})).find(part), "alu");
    };
    EXPECT_GT(cost_of("8", "total"), 1.9 * cost_of("4", "total"));
    EXPECT_EQ(cost_of("8", "loop_bodies_once"), cost_of("4", "loop_bodies_once"));
}

// The read is attributed to the node also if only the conversion to the output uses the texel.
TEST_F(CostTest, AnImageReadIsBookedOnTheNodeThatReads) {
    const std::pair<const char*, const char*> cases[] = {
        {R"("image", "in": {"image": "a.png"})", "alpha"},
        {R"("derivative_map", "in": {"image": "a.png", "scale": "unit"})", "gradient"},
        {R"("height_map", "in": {"image": "a.png", "scale": "unit"})", "gradient"},
        {R"("hex_tile_height_map", "in": {"image": "a.png", "scale": "unit"})", "gradient"},
        {R"("slope_moments_map", "in": {"slopes": "a.png", "moments": "b.png"})", "derivative"}};
    for (const char* name : {"a.png", "b.png"})
        fs::copy_file(samples + "textures/rivets_normal.png", folder / name);
    for (const auto& [node, output] : cases) {
        put("g.json", std::string(R"({"wrinkle": 1, "nodes": {"map": {"type": )") + node +
                          R"(}}, "outputs": {"x": {"from": "map.)" + output + R"("}}})");
        const Ran ran = run({"compile", "g.json", "--cost", "--json"});
        ASSERT_EQ(ran.code, 0) << ran.err;
        const json::Value cost = cost_in(ran);
        for (const char* number : {"texture_reads", "texture_queries"}) {
            EXPECT_EQ(number_of(cost.find("surface_point"), number), 0) << node;
            EXPECT_EQ(number_of(cost.find("nodes").at(0), number),
                      number_of(cost.find("total"), number))
                << node;
        }
    }
}

TEST_F(CostTest, TheTextIsWrittenBesideItWhereAPlaceIsNamed) {
    put("g.json", ramp_graph());
    const Ran costs = run({"compile", "g.json", "--cost"});
    const Ran both = run({"compile", "g.json", "--cost", "-o", "g.glsl", "-MD", "--reflect", "r"});
    EXPECT_EQ(both.code, 0) << both.err;
    EXPECT_EQ(both.out, costs.out);
    EXPECT_EQ(get("g.glsl"), run({"compile", "g.json"}).out);
    EXPECT_EQ(files(), (Names{"g.glsl", "g.glsl.d", "g.json", "r"}));
    const Ran reflected = run({"compile", "g.json", "--cost", "--reflect", "other"});
    EXPECT_EQ(reflected.out, costs.out);
    EXPECT_EQ(get("other"), get("r"));
}

TEST_F(CostTest, OfSeveralGraphsTheGoodOnesAreCounted) {
    put("a.json", ramp_graph());
    put("b.json", "{");
    put("sub/a.json", tilt_graph());
    const Ran ran = run({"compile", "a.json", "b.json", "sub/a.json", "--cost"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(ran.out.starts_with("a.json\n"));
    EXPECT_TRUE(says(ran.out, "\n\nsub/a.json\n"));
    EXPECT_EQ(ran.out.find("b.json"), ran.out.npos);
    EXPECT_TRUE(says(ran.err, "b.json:1:"));
    const Ran json = run({"compile", "a.json", "b.json", "sub/a.json", "--cost", "--json", "-j3"});
    EXPECT_EQ(parsed(json.out).find("graphs").size(), 2u);
    EXPECT_EQ(run({"compile", "b.json", "--cost", "--json"}).out, "");
}

// Only the functions are counted, so all forms have one count; a uniform is not a constant.
TEST_F(CostTest, CountsTheFunctionsOfEveryForm) {
    put("g.json", ramp_graph("1"));
    const std::string baked = run({"compile", "g.json", "--cost"}).out;
    for (const Names& more : {Names{"--form", "shader"}, Names{"--target", "essl300"},
                              Names{"--target", "hlsl"}, Names{"--differentials", "given"}}) {
        Names args{"compile", "g.json", "--cost"};
        args.insert(args.end(), more.begin(), more.end());
        EXPECT_EQ(run(args).out, baked) << more[0] << more[1];
    }
    EXPECT_EQ(
        number_of(cost_in(run({"compile", "g.json", "--cost", "--json"})).find("total"), "alu"), 0);
    EXPECT_EQ(
        number_of(cost_in(run({"compile", "g.json", "--cost", "--json", "--params", "uniform"}))
                      .find("total"),
                  "alu"),
        1);
}

TEST_F(CostTest, ComesFromTheCacheToo) {
    put("g.json", ramp_graph());
    const std::string table = run({"compile", "g.json", "--cost"}).out;
    const std::string json = run({"compile", "g.json", "--cost", "--json"}).out;
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(run({"compile", "g.json", "--cache", "c", "-o", "g.glsl"}).out, "");
        EXPECT_EQ(run({"compile", "g.json", "--cache", "c", "--cost"}).out, table);
        EXPECT_EQ(run({"compile", "g.json", "--cache", "c", "--cost", "--json"}).out, json);
    }
    size_t entries = 0;
    for (const auto& each : fs::recursive_directory_iterator(folder / "c"))
        entries += each.is_regular_file();
    EXPECT_EQ(entries, 3u);
}

TEST_F(CostTest, RefusesWrongUsage) {
    put("g.json", ramp_graph());
    for (const Names& more :
         {Names{"--json"}, Names{"--cost", "-o", "-"}, Names{"--cost", "--reflect", "-"},
          Names{"--cost", "-MD"}, Names{"--cost", "-o", "g.glsl", "-MD", "-MF", "-"}}) {
        Names args{"compile", "g.json"};
        args.insert(args.end(), more.begin(), more.end());
        const Ran ran = run(args);
        EXPECT_EQ(ran.code, 2) << testing::PrintToString(more);
        EXPECT_EQ(ran.out, "");
        EXPECT_EQ(files(), Names{"g.json"});
    }
}

// A graph with `count` outputs of type float.
std::string outputs_graph(int count) {
    std::string outputs;
    for (int i = 0; i < count; ++i)
        outputs += (i ? ", \"" : "\"") + ("o" + std::to_string(i)) + "\": {\"from\": \"split.x\"}";
    return R"({"wrinkle": 1, "nodes": {"split": {"type": "separate_vec2",
        "in": {"vector": {"from": "surface.uv0"}}}}, "outputs": {)" +
           outputs + "}}";
}

TEST_F(CostTest, MoreOutputsThanDrawBuffersAreNamed) {
    put("four.json", outputs_graph(4));
    put("five.json", outputs_graph(5));
    const Names shader{"--target", "essl300", "--form", "shader"};
    const auto compile = [&](const std::string& graph, Names more) {
        more.insert(more.begin(), {"compile", graph, "-o", "out"});
        return run(more);
    };
    const Ran four = compile("four.json", {"--target", "essl300", "--form", "shader", "--strict"});
    EXPECT_EQ(four.code, 0);
    EXPECT_EQ(four.err, "");
    fs::remove(folder / "out.vert");
    fs::remove(folder / "out.frag");
    const Ran strict =
        compile("five.json", {"--target", "essl300", "--form", "shader", "--strict"});
    EXPECT_EQ(strict.code, 1);
    EXPECT_TRUE(says(strict.err,
                     "five.json: error: it has 5 outputs, and a shader of GLSL ES 3.00 "
                     "draws to 4 buffers for certain: o0, o1, o2, o3, o4"));
    EXPECT_FALSE(exists("out.frag"));
    const Ran warned = compile("five.json", shader);
    EXPECT_EQ(warned.code, 0);
    EXPECT_TRUE(says(warned.err, "warning: it has 5 outputs"));
    EXPECT_TRUE(exists("out.frag"));
    EXPECT_EQ(compile("five.json", {"--form", "shader", "--strict"}).err, "") << "OpenGL has 8";
    EXPECT_EQ(compile("five.json", {"--target", "essl300", "--strict"}).err, "")
        << "what functions give is drawn by the caller";
}

// Twenty levels that each use the level below twice: the generated source has one function per
// level, but all calls are inlined before the cost is counted.
TEST_F(CostTest, RefusesMoreCallsThanCanBeInlined) {
    put("l0.json", R"({"wrinkle": 1, "inputs": {"x": {"type": "float"}}, "nodes": {
        "y": {"type": "add", "in": {"a": {"from": "input.x"}, "b": 1}}},
        "outputs": {"y": {"from": "y.result"}}})");
    for (int i = 1; i <= 20; ++i)
        put("l" + std::to_string(i) + ".json",
            R"({"wrinkle": 1, "inputs": {"x": {"type": "float"}}, "nodes": {
            "a": {"type": "graph:l)" +
                std::to_string(i - 1) + R"(.json", "in": {"x": {"from": "input.x"}}},
            "b": {"type": "graph:l)" +
                std::to_string(i - 1) + R"(.json", "in": {"x": {"from": "a.y"}}}},
            "outputs": {"y": {"from": "b.y"}}})");
    EXPECT_EQ(run({"compile", "l20.json", "-o", "out"}).code, 0);
    const Ran ran = run({"compile", "l20.json", "--cost"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(says(ran.err, "--cost would make 2097150 calls of sub-graphs"));
}

}  // namespace
}  // namespace wrinkle::test
