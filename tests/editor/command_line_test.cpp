// Tests of the editor's command line; rejected arguments need no screen.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

namespace wrinkle::editor {
namespace {

int exit_code(const std::string& words) {
    const std::string program = "DISPLAY= WAYLAND_DISPLAY= " WRINKLE_EDITOR;
    return WEXITSTATUS(std::system((program + words + " >/dev/null 2>&1").c_str()));
}

// Two graphs are an error, so exit code 2 shows that the second argument after the option is a
// graph.
TEST(CommandLine, PluginPathsTakeOneValueEach) {
    EXPECT_EQ(exit_code(" --plugin-path x.so a.json b.json"), 2);
    EXPECT_EQ(exit_code(" --plugin-path x.so --plugin-path y.so a.json b.json"), 2);
    EXPECT_NE(exit_code(" --plugin-path x.so a.json"), 2);
}

}  // namespace
}  // namespace wrinkle::editor
