// Tests of a real window on a virtual screen. Skipped only if Xvfb is not available.
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include "headless.h"
#include "image/load.h"
#include "running_editor.h"
#include "virtual_screen.h"

namespace wrinkle::editor {
namespace {

// Leak detection is off: GLFW unloads the GL driver, so its leaks have no symbol names left to
// suppress them by. ui_test.cpp runs the same frames without a window, with leak detection.
int run(const std::string& environment, const std::string& arguments) {
    const char* set = std::getenv("ASAN_OPTIONS");
    const std::string sanitizer =
        " ASAN_OPTIONS=" + std::string(set ? set : "") + ":detect_leaks=0 ";
    const std::string command = "env -u WAYLAND_DISPLAY " + environment + sanitizer +
                                "timeout 120 " + WRINKLE_EDITOR + " " + arguments;
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

size_t colors_of(const Image& image, uint32_t x0, uint32_t x1, uint32_t y0, uint32_t y1) {
    std::set<std::array<float, 3>> colors;
    for (uint32_t y = y0; y < y1; ++y)
        for (uint32_t x = x0; x < x1; ++x) {
            const float* texel = image.texel(x, y);
            colors.insert({texel[0], texel[1], texel[2]});
        }
    return colors.size();
}

TEST(Window, EditsAndSavesAGraphOnAVirtualScreen) {
    const VirtualScreen screen;
    if (!screen.is_there()) GTEST_SKIP() << "there is no Xvfb here";
    const TemporaryFolder folder;
    const auto graph = folder.write("graph.json", small_graph);
    const auto picture = folder.path() / "window.png";
    const auto script = folder.write("script.txt", R"(
assert nodes 4
assert errors 0
assert picture
drag out:noise.value pin:number.a
assert wire noise.value number.a
drag field:softer.amount field:softer.amount+20,0
double field:noise.scale
type 5.5
key Enter
assert value noise.scale 5.5
drag preview preview+60,30
assert picture
key Ctrl+S
assert clean
)");
    ASSERT_EQ(run(screen.variable(), graph.string() + " --size 1280 720 --script " +
                                         script.string() + " --shot " + picture.string()),
              0);
    const std::string saved = text_of(graph);
    EXPECT_NE(saved.find("\"scale\": 5.5"), std::string::npos) << saved;
    EXPECT_NE(saved.find("\"from\": \"noise.value\""), std::string::npos) << saved;
    EXPECT_EQ(saved.find("\"amount\": 0.6 "), std::string::npos) << saved;
    Diagnostics problems;
    const auto image = load_image(picture, problems);
    ASSERT_TRUE(image) << to_text(problems);
    EXPECT_EQ(image->width, 1280U);
    EXPECT_EQ(image->height, 720U);
    EXPECT_GT(colors_of(*image, 0, 800, 100, 650), 50U) << "the canvas is blank";
    EXPECT_GT(colors_of(*image, 1000, 1200, 400, 550), 50U) << "the preview is blank";
}

// A height computed by a chain of `count` nodes, laid out in rows of ten, and its normal.
std::string chain(int count) {
    std::string nodes =
        R"("uv": { "type": "separate_vec2", "in": { "vector": { "from": "surface.uv0" } } })";
    std::string last = "uv.x",
                places = R"("depth": [0, -400], "normal": [400, -400], "uv": [0, -200])";
    const char* const starts[] = {R"("multiply", "in": { "b": 3.1, "a")",
                                  R"("sine", "in": { "angle")", R"("add", "in": { "b": 0.2, "a")"};
    for (int i = 0; i < count - 3; ++i) {
        const std::string id = "n" + std::to_string(i);
        nodes += ",\n\"" + id + "\": { \"type\": " + starts[i % 3] + ": { \"from\": \"" + last +
                 "\" } } }";
        places += ", \"" + id + "\": [" + std::to_string(i % 10 * 240) + ", " +
                  std::to_string(i / 10 * 160) + "]";
        last = id + ".result";
    }
    nodes += R"(,
"depth": { "type": "multiply", "in": { "b": 0.05, "a": { "from": ")" +
             last + R"(" } } },
"normal": { "type": "resolve", "in": { "gradient": { "from": "depth.result" } } })";
    return "{ \"wrinkle\": 1, \"nodes\": {\n" + nodes +
           "\n}, \"outputs\": { \"normal\": { \"from\": \"normal.normal\" } }, \"layout\": { " +
           places + " } }\n";
}

// Cuts the end of the chain and undoes the cut, drags a number, previews a node, then the outputs.
const char* const measured_script = R"(
click node:depth
key F
section cut
drag pin:depth.a canvas+0,320
section undo
key Escape
key Ctrl+Z
section drag
drag field:depth.b field:depth.b+40,0
section node
click node:depth
key P
section outputs
key P
section rest
assert picture
)";

TEST(Window, ADragOfAValueBuildsNoTextAndNoProgram) {
    const VirtualScreen screen;
    if (!screen.is_there()) GTEST_SKIP() << "there is no Xvfb here";
    const TemporaryFolder folder;
    const auto graph = folder.write("graph.json", chain(20));
    const auto script = folder.write("script.txt", measured_script);
    const auto figures = folder.path() / "figures.json";
    ASSERT_EQ(run(screen.variable(), graph.string() + " --size 1280 720 --script " +
                                         script.string() + " --timings " + figures.string()),
              0);
    const std::string text = text_of(figures);
    const auto part = [&](const char* from, const char* to) {
        return text.substr(text.find(from), text.find(to) - text.find(from));
    };
    const std::string drag = part("\"drag\"", "\"node\""), cut = part("\"cut\"", "\"undo\"");
    EXPECT_NE(drag.find("\"programs\": 0"), std::string::npos) << drag;
    EXPECT_NE(cut.find("\"programs\": 1"), std::string::npos) << cut;
}

// Returns the texels of the preview above the line with its duration.
std::vector<float> preview_of(const Image& image) {
    std::vector<float> values;
    for (uint32_t y = 130; y < 300; ++y)
        for (uint32_t x = 900; x < image.width; ++x)
            values.insert(values.end(), image.texel(x, y), image.texel(x, y) + 3);
    return values;
}

TEST(Window, ALostDriverIsStartedAgainAndTheWorkIsThere) {
    const VirtualScreen screen;
    if (!screen.is_there()) GTEST_SKIP() << "there is no Xvfb here";
    const TemporaryFolder folder;
    const auto graph = folder.write("graph.json", small_graph);
    const auto before = folder.path() / "before.png", after = folder.path() / "after.png";
    const auto script = folder.write("script.txt", R"(
drag field:softer.amount field:softer.amount+20,0
assert dirty
shot )" + before.string() + R"(
lose driver
assert status was reset
assert picture
assert dirty
shot )" + after.string() + R"(
key Ctrl+Z
assert clean
)");
    ASSERT_EQ(
        run(screen.variable(), graph.string() + " --size 1280 720 --script " + script.string()), 0);
    Diagnostics problems;
    const auto first = load_image(before, problems), second = load_image(after, problems);
    ASSERT_TRUE(first && second) << to_text(problems);
    EXPECT_GT(colors_of(*second, 1000, 1200, 400, 550), 50U) << "the preview is blank";
    EXPECT_TRUE(preview_of(*first) == preview_of(*second));
}

TEST(Window, AScriptThatIsNotSoFailsAndSavesNothing) {
    const VirtualScreen screen;
    if (!screen.is_there()) GTEST_SKIP() << "there is no Xvfb here";
    const TemporaryFolder folder;
    const auto graph = folder.write("graph.json", small_graph);
    const auto script =
        folder.write("script.txt", "click node:noise\nkey Delete\nassert nodes 4\n");
    EXPECT_EQ(run(screen.variable(),
                  graph.string() + " --size 800 500 --script " + script.string() + " 2>/dev/null"),
              1);
    EXPECT_EQ(text_of(graph), small_graph);
}

TEST(Window, IsNeverTooSmallToWorkIn) {
    const VirtualScreen screen;
    if (!screen.is_there()) GTEST_SKIP() << "there is no Xvfb here";
    const TemporaryFolder folder;
    const auto graph = folder.write("graph.json", small_graph);
    const auto picture = folder.path() / "window.png";
    ASSERT_EQ(run(screen.variable(), graph.string() + " --size 300 200 --shot " + picture.string()),
              0);
    Diagnostics problems;
    const auto image = load_image(picture, problems);
    ASSERT_TRUE(image) << to_text(problems);
    EXPECT_EQ(image->width, 800U);
    EXPECT_EQ(image->height, 500U);
}

TEST(Window, TheEyedropperReadsThePixelUnderThePointer) {
    const VirtualScreen screen;
    if (!screen.is_there()) GTEST_SKIP() << "there is no Xvfb here";
    const TemporaryFolder folder;
    const auto graph = folder.write("graph.json", R"({"wrinkle": 1, "nodes": {
        "m": {"type": "material"}}, "outputs": {"material": {"from": "m.material"}}})");
    const auto script = folder.write("script.txt", R"(
click field:m.color.0
key I
click canvas+-400,150
key I
key Escape
key Enter
key Ctrl+S
)");
    ASSERT_EQ(run(screen.variable(), graph.string() + " --script " + script.string()), 0);
    const Document saved = parsed(text_of(graph));
    const json::Value& color = saved.find("m")->find("color")->value;
    const double ground[] = {0.0074990, 0.0085681, 0.0109601};  // 0x15171B in linear values
    for (size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(color.at(i).as_number(), ground[i], 1e-6) << i;
}

TEST(Window, WithoutADisplayItSaysSo) {
    const TemporaryFolder folder;
    const auto graph = folder.write("graph.json", small_graph);
    const auto words = folder.path() / "words.txt";
    EXPECT_EQ(run("DISPLAY=", graph.string() + " 2>" + words.string()), 3);
    EXPECT_EQ(text_of(words).substr(0, 16), "wrinkle-editor: ");
    EXPECT_EQ(run("DISPLAY=", "--no-such-option 2>/dev/null >/dev/null"), 2);
}

TEST(Window, NodesAreCopiedFromOneProcessToAnother) {
    const VirtualScreen screen;
    if (!screen.is_there()) GTEST_SKIP() << "there is no Xvfb here";
    const TemporaryFolder folder;
    const auto graph = folder.write("graph.json", small_graph);
    // The copies end with their process, which therefore waits until it is killed.
    const auto copy = folder.write("copy.txt", R"(
key Ctrl+A
key Ctrl+C
assert status Copied 4 nodes
say copied
await nodes 0
)");
    const auto paste = folder.write("paste.txt", R"(
key Ctrl+V
assert nodes 4
assert wire noise.height softer.gradient
assert wire softer.gradient normal.gradient
assert no-wire normal.normal normal
)");
    RunningEditor copier(screen, {graph.string(), "--script", copy.string()});
    copier.listen(RunningEditor::Clock::now() + std::chrono::seconds(100), "copied");
    EXPECT_EQ(run(screen.variable(),
                  (folder.path() / "new.json").string() + " --script " + paste.string()),
              0);
    EXPECT_NE(copier.kill().find("copied"), std::string::npos);
}

}  // namespace
}  // namespace wrinkle::editor
