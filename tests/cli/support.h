// What the tests of the program share: a folder of their own to work in, and the built binary run
// as a process with everything it says.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "json/parse.h"
#include "support/files.h"

#if defined(__SANITIZE_ADDRESS__)
// First in a test that limits the memory of a program.
#define LIMITED_MEMORY GTEST_SKIP() << "the sanitizer needs all of the address space"
// First in a test that takes minutes under sanitizers and whose code other tests run too.
#define MANY_PROCESSES GTEST_SKIP() << "processes under a sanitizer are slow to start"
#else
#define LIMITED_MEMORY static_cast<void>(0)
#define MANY_PROCESSES static_cast<void>(0)
#endif

namespace wrinkle::test {

namespace fs = std::filesystem;

struct Ran {
    int code = -1;  // exit code; 128 + the signal of a crash
    std::string out;
    std::string err;
    long read = 0;  // bytes taken from standard input
};

class CliTest : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder); }

    // In `folder`. `environment` entries are "NAME=value".
    Ran run(const std::vector<std::string>& args, const std::string& input = "",
            const std::vector<std::string>& environment = {}) const;

    // The same, killed on its way into the `n`th call of the system that is called so; where there
    // are fewer it comes to its end.
    Ran run_killed_at(const std::string& call, int n, const std::vector<std::string>& args);

    // Without waiting for it; what it says is lost.
    pid_t start(const std::vector<std::string>& args) const;

    // With these descriptors as standard input, output and error; a negative one is closed.
    pid_t start(const std::vector<std::string>& args, int in, int out, int err,
                const std::vector<std::string>& environment) const;

    fs::path put(const std::string& name, std::string_view bytes) const;
    std::string get(const std::string& name) const;
    bool exists(const std::string& name) const { return fs::exists(folder / name); }
    // Everything below the folder, sorted: to see that nothing was written.
    std::vector<std::string> files() const;

    TemporaryFolder temporary;
    fs::path folder = temporary.path() / "work";
    std::string program = WRINKLE_BINARY_DIR "/bin/wrinkle";
    rlim_t memory = RLIM_INFINITY;     // bytes of address space that the process may have
    rlim_t file_size = RLIM_INFINITY;  // bytes of a file that it writes, as if the disk were full
    bool as_nobody = false;            // gives up root's rights to read everything
    unsigned seconds = 0;              // after which SIGALRM ends the process; 0: never
};

// An EGL without drivers.
const std::vector<std::string>& without_gl();

// A surface tilted by a constant gradient along x: on the plane z = 0 the normal is (-s, 0, 1)
// normalised, whatever the uv. `slope` is JSON.
std::string tilt_graph(const std::string& slope = "0.75");
// "value" = uv0.x * amount; a node `scaled`.
std::string ramp_graph(const std::string& amount = "2");

// Whether a text has these words somewhere.
testing::AssertionResult says(const std::string& text, const std::string& words);
json::Value parsed(const std::string& text);

}  // namespace wrinkle::test
