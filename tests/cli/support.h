// Fixture of the command-line tests: a temporary folder, and the built program run as a process
// with captured output.
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
// First statement of a test that limits the memory of a process.
#define LIMITED_MEMORY GTEST_SKIP() << "the sanitizer needs all of the address space"
// First statement of a test that takes minutes under sanitizers and that other tests cover too.
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

    // Runs the program in `folder`. `environment` entries are "NAME=value".
    Ran run(const std::vector<std::string>& args, const std::string& input = "",
            const std::vector<std::string>& environment = {}) const;

    // Like run(), but kills the process at entry to the `n`th system call named `call`; with fewer
    // such calls the process runs to its end.
    Ran run_killed_at(const std::string& call, int n, const std::vector<std::string>& args);

    // Starts the program without waiting; discards its output.
    pid_t start(const std::vector<std::string>& args) const;

    // Starts it with these descriptors as stdin, stdout and stderr; a negative one is closed.
    pid_t start(const std::vector<std::string>& args, int in, int out, int err,
                const std::vector<std::string>& environment) const;

    fs::path put(const std::string& name, std::string_view bytes) const;
    std::string get(const std::string& name) const;
    bool exists(const std::string& name) const { return fs::exists(folder / name); }
    // Everything below the folder, sorted; shows whether a command wrote anything.
    std::vector<std::string> files() const;

    TemporaryFolder temporary;
    fs::path folder = temporary.path() / "work";
    std::string program = WRINKLE_BINARY_DIR "/bin/wrinkle";
    rlim_t memory = RLIM_INFINITY;     // limit of the process's address space, in bytes
    rlim_t file_size = RLIM_INFINITY;  // limit of a written file, in bytes; simulates a full disk
    bool unprivileged = false;         // drops root's right to read all files
    unsigned seconds = 0;              // SIGALRM ends the process after this time; 0: no limit
};

// Environment of a process with an EGL without drivers.
const std::vector<std::string>& without_gl();

// A surface tilted by a constant gradient along x: on the plane z = 0 the normal is (-s, 0, 1)
// normalised, for any uv. `slope` is JSON.
std::string tilt_graph(const std::string& slope = "0.75");
// A graph with "value" = uv0.x * amount in a node `scaled`.
std::string ramp_graph(const std::string& amount = "2");

// Succeeds if `text` contains `words`.
testing::AssertionResult says(const std::string& text, const std::string& words);
json::Value parsed(const std::string& text);

}  // namespace wrinkle::test
