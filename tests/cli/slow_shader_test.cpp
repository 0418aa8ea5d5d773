// Tests of a shader that is slow to build: the time is shown on a terminal, and Ctrl-C ends the
// program without a file.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

// A sum of many Worley noises: drivers take seconds to build it.
std::string slow_graph() {
    constexpr int noises = 600;
    std::string nodes, sum = "n0.value";
    for (int i = 0; i < noises; ++i) {
        const std::string n = std::to_string(i);
        nodes += (i > 0 ? ", " : "") + ("\"n" + n) +
                 R"(": {"type": "worley_noise", "in": {"scale": )" + std::to_string(3 + i) + "}}";
        if (i == 0) continue;
        nodes += ", \"s" + n + R"(": {"type": "add", "in": {"a": {"from": ")" + sum +
                 R"("}, "b": {"from": "n)" + n + R"(.value"}}})";
        sum = "s" + n + ".result";
    }
    return R"({"wrinkle": 1, "nodes": {)" + nodes + R"(}, "outputs": {"roughness": {"from": ")" +
           sum + "\"}}}";
}

// A terminal: the end that a program writes to, and the end that the test reads.
struct Terminal {
    int test = posix_openpt(O_RDWR | O_NOCTTY), program = -1;
    Terminal() {
        if (test >= 0 && grantpt(test) == 0 && unlockpt(test) == 0)
            program = open(ptsname(test), O_RDWR | O_NOCTTY);
    }
    ~Terminal() {
        close(test);
        close(program);
    }
};

class SlowShaderTest : public CliTest {
protected:
    // Starts the program and returns its errors up to the first shown time, or to its end.
    std::string errors_until_time(const Terminal& terminal, pid_t child) {
        std::string text;
        int status = 0;
        fcntl(terminal.test, F_SETFL, O_NONBLOCK);
        while (!says_time(text)) {
            char bytes[256];
            const ssize_t count = read(terminal.test, bytes, sizeof bytes);
            if (count > 0) text.append(bytes, static_cast<size_t>(count));
            if (count <= 0 && waitpid(child, &status, WNOHANG) != 0) break;
            if (count <= 0) usleep(10'000);
        }
        return text;
    }
    static bool says_time(const std::string& text) { return text.find(" s (Ctrl-C") != text.npos; }
};

TEST_F(SlowShaderTest, ShowsItsTimeAndEndsByCtrlC) {
    put("g.json", slow_graph());
    const Terminal terminal;
    ASSERT_GE(terminal.program, 0);
    const int null = open("/dev/null", O_RDWR);
    const pid_t child = start({"render", "g.json", "-o", "g.png", "--size", "512x512"}, null, null,
                              terminal.program, {});
    const std::string shown = errors_until_time(terminal, child);
    EXPECT_TRUE(says(shown, "compiling and drawing the shader: 2 s (Ctrl-C stops)")) << shown;
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    close(null);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;  // shells report 130
    EXPECT_EQ(files(), std::vector<std::string>{"g.json"});
}

TEST_F(SlowShaderTest, ShowsNoTimeOfQuickOnesAndInPipes) {
    put("g.json", tilt_graph());
    const Terminal terminal;
    ASSERT_GE(terminal.program, 0);
    const int null = open("/dev/null", O_RDWR);
    const pid_t child = start({"render", "g.json", "-o", "g.png", "--size", "16x16"}, null, null,
                              terminal.program, {});
    const auto start_time = std::chrono::steady_clock::now();
    const std::string shown = errors_until_time(terminal, child);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start_time;
    // A busy machine can be slow with a quick shader too.
    EXPECT_TRUE(shown.empty() || took.count() > 1.5) << shown << took.count();
    if (!shown.empty()) waitpid(child, nullptr, 0);
    close(null);
    EXPECT_EQ(files(), (std::vector<std::string>{"g.json", "g.png"}));
}

}  // namespace
}  // namespace wrinkle::test
