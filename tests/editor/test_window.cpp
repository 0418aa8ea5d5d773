// A real window on a virtual screen. Skipped only where there is no Xvfb.
#include <sys/wait.h>

#include <cstdlib>
#include <set>
#include <string>

#include "headless.h"
#include "image/load.h"
#include "virtual_screen.h"

namespace wrinkle::editor {
namespace {

// Leaks are not looked for here: GLFW unloads the GL driver, and what that leaks has no name left
// to be exempt by. The same frames run without a window in test_ui.cpp, with leaks looked for.
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

TEST(Window, WithoutADisplayItSaysSo) {
    const TemporaryFolder folder;
    const auto graph = folder.write("graph.json", small_graph);
    const auto words = folder.path() / "words.txt";
    EXPECT_EQ(run("DISPLAY=", graph.string() + " 2>" + words.string()), 3);
    EXPECT_EQ(text_of(words).substr(0, 16), "wrinkle-editor: ");
    EXPECT_EQ(run("DISPLAY=", "--no-such-option 2>/dev/null >/dev/null"), 2);
}

}  // namespace
}  // namespace wrinkle::editor
