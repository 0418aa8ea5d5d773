// Tests of invalid graphs: each error is reported at its location with exit code 1, and no file is
// written.
#include <sys/stat.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

struct BadGraph {
    std::string name;
    std::string text;
    std::vector<std::string> words;  // each must be in the message
};

std::string graph_of(const std::string& nodes, const std::string& output = "x.result") {
    return "{\"wrinkle\": 1,\n \"nodes\": {\n" + nodes +
           "\n},\n\"outputs\": {\"value\": {\"from\": \"" + output + "\"}}}\n";
}

std::string png_header(uint32_t width, uint32_t height) {
    const auto number = [](uint32_t value) {
        std::string bytes;
        for (int shift = 24; shift >= 0; shift -= 8)
            bytes += static_cast<char>(value >> shift);
        return bytes;
    };
    const auto chunk = [&](const std::string& name, const std::string& content) {
        uint32_t crc = 0xFFFFFFFF;
        for (const char c : name + content) {
            crc ^= static_cast<uint8_t>(c);
            for (int bit = 0; bit < 8; ++bit)
                crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320 : 0);
        }
        return number(static_cast<uint32_t>(content.size())) + name + content + number(~crc);
    };
    return "\x89PNG\r\n\x1A\n" +
           chunk("IHDR", number(width) + number(height) + std::string("\x08\0\0\0\0", 5)) +
           chunk("IDAT", "x") + chunk("IEND", "");
}

const std::string image_nodes =
    R"(  "bumps": { "type": "height_map", "in": { "image": "IMAGE" } },
  "end": { "type": "resolve", "in": { "gradient": { "from": "bumps.gradient" } } })";

std::string image_graph(const std::string& file) {
    std::string nodes = image_nodes;
    nodes.replace(nodes.find("IMAGE"), 5, file);
    return graph_of(nodes, "end.normal");
}

// Returns the first line that occurs twice; "" if there is none.
std::string repeated_line(const std::string& text) {
    std::set<std::string> seen;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (!seen.insert(line).second) return line;
    return "";
}

class BadInputTest : public CliTest {
protected:
    void expect_refused(const BadGraph& bad) {
        put("bad.json", bad.text);
        const auto before = files();
        const std::vector<std::vector<std::string>> commands = {
            {"check", "bad.json"},
            {"compile", "bad.json", "-o", "out.glsl", "--reflect", "out.json", "-MD"},
            {"eval", "bad.json", "--mesh", "plane", "--uv", "0.5,0.5"},
            {"render", "bad.json", "-o", "out.png", "--size", "8x8"},
        };
        for (const auto& args : commands) {
            const Ran ran = run(args);
            EXPECT_EQ(ran.code, 1) << args[0] << ": " << bad.name << ran.err;
            EXPECT_EQ(ran.out, "") << args[0] << ": " << bad.name;
            for (const std::string& words : bad.words)
                EXPECT_TRUE(says(ran.err, words)) << args[0] << ": " << bad.name;
            EXPECT_EQ(repeated_line(ran.err), "") << args[0] << ": " << bad.name;
            EXPECT_EQ(files(), before) << args[0] << ": " << bad.name;
        }
    }
};

TEST_F(BadInputTest, IsReportedAtItsPlaceAndNothingIsWritten) {
    const std::string deep(100'000, '[');
    const std::vector<BadGraph> cases = {
        {"empty", "", {"bad.json:1:1"}},
        {"no JSON", "hello", {"bad.json:1:1"}},
        {"an array", "[]", {"bad.json:1:1"}},
        {"deep", "{\"wrinkle\": 1, \"nodes\": " + deep, {"bad.json:1:", "deep"}},
        {"NaN", graph_of(R"("x": {"type": "add", "in": {"a": NaN}})"), {"bad.json:3:34"}},
        {"too large a number",
         graph_of(R"("x": {"type": "add", "in": {"a": 1e999}})"),
         {"bad.json:3:34"}},
        {"a node twice",
         graph_of("\"x\": {\"type\": \"add\"},\n\"x\": {\"type\": \"add\"}"),
         {"bad.json:4:1", "\"x\""}},
        {"a port twice",
         graph_of(R"("x": {"type": "add", "in": {"a": 1, "a": 2}})"),
         {"bad.json:3:37", "\"a\""}},
        {"an unknown type",
         graph_of(R"("x": {"type": "ad"})"),
         {"bad.json:3:", "node 'x'", "'ad'", "did you mean 'add'"}},
        {"an unknown port",
         graph_of(R"("x": {"type": "add", "in": {"c": 1}})"),
         {"bad.json:3:", "node 'x'", "'c'"}},
        {"an unknown key",
         graph_of(R"("x": {"type": "add", "color": 3})"),
         {"bad.json:3:", "\"color\""}},
        {"a wrong value",
         graph_of(R"("x": {"type": "add", "in": {"a": "one"}})"),
         {"bad.json:3:34", "node 'x'", "'a'"}},
        {"a wrong wire",
         graph_of("\"x\": {\"type\": \"add\", \"in\": {\"a\": {\"from\": \"surface.uv0\"}}}"),
         {"bad.json:3:", "node 'x'", "vec2"}},
        {"a wire from nowhere",
         graph_of(R"("x": {"type": "add", "in": {"a": {"from": "y.result"}}})"),
         {"bad.json:3:", "node 'x'", "'y'"}},
        {"an output that a node lacks",
         graph_of(R"("x": {"type": "add"}, "z": {"type": "add", "in": {"a": {"from": "x.sum"}}})"),
         {"bad.json:3:", "node 'z'", "'sum'"}},
        {"a cycle",
         graph_of("\"x\": {\"type\": \"add\", \"in\": {\"a\": {\"from\": \"y.result\"}}},\n"
                  "\"y\": {\"type\": \"add\", \"in\": {\"a\": {\"from\": \"x.result\"}}}"),
         {"bad.json:", "cycle"}},
        {"itself as a sub-graph",
         graph_of(R"("x": {"type": "graph:bad.json"})", "x.value"),
         {"bad.json:3:", "node 'x'"}},
        {"a sub-graph outside",
         graph_of(R"("x": {"type": "graph:../../etc/passwd"})", "x.value"),
         {"bad.json:3:", "node 'x'"}},
        {"a missing image", image_graph("none.png"), {"bad.json:3:", "node 'bumps'", "none.png"}},
        {"an image outside",
         image_graph("../../../../../../../etc/passwd"),
         {"bad.json:3:", "node 'bumps'"}},
        {"an absolute image", image_graph("/etc/passwd"), {"bad.json:3:", "node 'bumps'"}},
    };
    for (const BadGraph& bad : cases)
        expect_refused(bad);
}

TEST_F(BadInputTest, PixelsAreReportedByThoseWhoReadThem) {
    put("corrupt.png", "this is no picture");
    put("enormous.png", png_header(2'000'000'000, 2'000'000'000));
    put("truncated.png", png_header(64, 64));
    for (const std::string name : {"corrupt.png", "enormous.png", "truncated.png"}) {
        put("bad.json", image_graph(name));
        const auto before = files();
        EXPECT_EQ(run({"check", "bad.json"}).code, 0);
        EXPECT_EQ(run({"compile", "bad.json"}).code, 0);
        for (const auto& args : std::vector<std::vector<std::string>>{
                 {"eval", "bad.json", "--mesh", "plane", "--uv", "0.5,0.5"},
                 {"render", "bad.json", "-o", "out.png", "--size", "8x8"}}) {
            const Ran ran = run(args);
            EXPECT_EQ(ran.code, 1) << name << ran.err;
            EXPECT_EQ(ran.out, "");
            EXPECT_TRUE(says(ran.err, "bad.json:3:")) << name;
            EXPECT_TRUE(says(ran.err, "node 'bumps'")) << name;
            EXPECT_TRUE(says(ran.err, name));
            EXPECT_EQ(files(), before);
        }
    }
}

TEST_F(BadInputTest, EveryTruncationIsAnError) {
    std::string whole = tilt_graph();
    whole.pop_back();  // the line break at the end of a graph is optional
    for (size_t first = 0; first < whole.size(); first += 100) {
        std::vector<std::string> args{"check"};
        for (size_t i = first; i < std::min(first + 100, whole.size()); ++i) {
            const std::string name = "cut" + std::to_string(i) + ".json";
            put(name, std::string_view(whole).substr(0, i));
            args.push_back(name);
        }
        const Ran ran = run(args);
        EXPECT_EQ(ran.code, 1);
        for (size_t i = 1; i < args.size(); ++i)
            EXPECT_TRUE(says(ran.err, args[i] + ":")) << args[i];
    }
    put("whole.json", whole);
    EXPECT_EQ(run({"check", "whole.json"}).code, 0);
}

TEST_F(BadInputTest, AFileThatIsNoneIsNamed) {
    fs::create_directories(folder / "folder.json");
    for (const std::string name : {"missing.json", "folder.json"}) {
        const Ran ran = run({"check", name});
        EXPECT_EQ(ran.code, 1);
        EXPECT_TRUE(says(ran.err, name));
    }
}

// Opening a pipe blocks until it has a writer.
TEST_F(BadInputTest, APipeIsNoImage) {
    ASSERT_EQ(mkfifo((folder / "pipe.png").c_str(), 0600), 0);
    expect_refused({"a pipe", image_graph("pipe.png"), {"not a regular file"}});
}

TEST_F(BadInputTest, EveryProblemIsReportedAtOnce) {
    put("bad.json", graph_of("\"x\": {\"type\": \"ad\"},\n\"y\": {\"type\": \"add\", \"in\": "
                             "{\"c\": 1}},\n\"z\": {\"type\": \"resolve\", \"wrong\": 1}"));
    const Ran ran = run({"check", "bad.json"});
    EXPECT_TRUE(says(ran.err, "bad.json:3:"));
    EXPECT_TRUE(says(ran.err, "bad.json:4:"));
    EXPECT_TRUE(says(ran.err, "bad.json:5:"));
}

TEST_F(BadInputTest, ManyProblemsAreCounted) {
    std::string nodes;
    for (int i = 0; i < 1500; ++i)
        nodes += (i > 0 ? ",\n" : "") + ("\"n" + std::to_string(i)) + "\": {\"type\": \"nothing\"}";
    put("bad.json", "{\"wrinkle\": 1, \"nodes\": {" + nodes + "}}");
    const Ran ran = run({"check", "bad.json"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1001);
    EXPECT_TRUE(ran.err.ends_with("and 500 more problems\n"));
}

TEST_F(BadInputTest, BadValuesOfSetAreNamed) {
    put("g.json", ramp_graph());
    for (const std::string set : {"nobody.b=1", "scaled.q=1", "scaled.b=\"x\"", "scaled.b", "=",
                                  "scaled.b=[1", "scaled.b=0:1:1", "input.x=1"}) {
        const Ran ran = run({"eval", "g.json", "--at", R"({"uv0": [0, 0]})", "--set", set});
        EXPECT_EQ(ran.code, 1) << set << ran.out;
        EXPECT_EQ(ran.out, "") << set;
        EXPECT_TRUE(says(ran.err, set.substr(0, set.find('=')))) << set;
    }
}

// The message contains a valid command line; running it succeeds.
TEST_F(BadInputTest, ABadVectorOfSetIsShownAsAnArray) {
    put("g.json", R"({"wrinkle": 1, "nodes": {"tile": {"type": "uv_transform"}},
        "outputs": {"x": {"from": "tile.uv"}}})");
    for (const auto& [typed, shown] : {std::pair{"0.5,0.25", "[0.5,0.25]"},
                                       {"(0.5, 0.25)", "[0.5,0.25]"},
                                       {"0.5", "[0.5,0.5]"},
                                       {"[0.5]", "[0.5,0.5]"}}) {
        const Ran ran = run({"compile", "g.json", "--set", std::string("tile.scale=") + typed});
        EXPECT_EQ(ran.code, 1);
        const std::string right = std::string("tile.scale=") + shown;
        EXPECT_TRUE(says(ran.err, "; type " + right + ")")) << typed;
        EXPECT_EQ(run({"compile", "g.json", "--set", right}).code, 0);
    }
    for (const char* typed : {"wide", "1,2,3", "true"}) {
        const Ran ran = run({"compile", "g.json", "--set", std::string("tile.scale=") + typed});
        EXPECT_TRUE(says(ran.err, "expected an array of 2 numbers)")) << typed;
    }
}

}  // namespace
}  // namespace wrinkle::test
