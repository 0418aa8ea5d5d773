#include "cli/support.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include "support/privileges.h"

namespace wrinkle::test {
namespace {

int open_file(const fs::path& path) {
    return open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC, 0600);
}

std::vector<char*> pointers(const std::vector<std::string>& strings) {
    std::vector<char*> result;
    for (const std::string& string : strings)
        result.push_back(const_cast<char*>(string.c_str()));
    result.push_back(nullptr);
    return result;
}

}  // namespace

// The child process gets duplicates of the three descriptors.
pid_t CliTest::start(const std::vector<std::string>& args, int in, int out, int err,
                     const std::vector<std::string>& environment) const {
    const fs::path beside = folder.parent_path();
    std::vector<std::string> words{program};
    words.insert(words.end(), args.begin(), args.end());
    const auto argv = pointers(words);
    // Excludes the plugins of the user who runs the tests.
    std::vector<std::string> all{"WRINKLE_NO_DEFAULT_PLUGINS=1",
                                 "XDG_CACHE_HOME=" + (beside / "cache").string()};
    all.insert(all.end(), environment.begin(), environment.end());
    const auto settings = pointers(all);
    const pid_t child = fork();
    if (child != 0) return child;
    const int streams[] = {in, out, err};
    for (int i = 0; i < 3; ++i) {
        if (streams[i] >= 0)
            dup2(streams[i], i);
        else
            close(i);
    }
    unsetenv("WRINKLE_PLUGIN_PATH");
    for (char* entry : settings)
        if (entry) putenv(entry);
    const rlimit limit{memory, memory};
#if defined(__SANITIZE_ADDRESS__)  // ASan reserves more address space than any limit
    (void)limit;
#else
    if (memory != RLIM_INFINITY) setrlimit(RLIMIT_AS, &limit);
#endif
    const rlimit full{file_size, file_size};
    if (file_size != RLIM_INFINITY && setrlimit(RLIMIT_FSIZE, &full) == 0) signal(SIGXFSZ, SIG_IGN);
    signal(SIGINT, SIG_DFL);  // a script's background jobs ignore it, and so would the program
    alarm(seconds);           // survives exec
    const bool changed = !unprivileged || drop_capabilities();
    if (chdir(folder.c_str()) == 0 && changed) execv(program.c_str(), argv.data());
    _exit(127);
}

pid_t CliTest::start(const std::vector<std::string>& args) const {
    const int nothing = open("/dev/null", O_RDWR);
    const pid_t child = start(args, nothing, nothing, nothing, {});
    close(nothing);
    return child;
}

// Standard input is a file that shares its offset with the process, so the bytes read can be
// counted.
Ran CliTest::run(const std::vector<std::string>& args, const std::string& input,
                 const std::vector<std::string>& environment) const {
    const fs::path beside = folder.parent_path();
    const int in = open_file(beside / "in"), out = open_file(beside / "out"),
              err = open_file(beside / "err");
    EXPECT_EQ(write(in, input.data(), input.size()), static_cast<ssize_t>(input.size()));
    lseek(in, 0, SEEK_SET);
    const pid_t child = start(args, in, out, err, environment);
    int status = 0;
    waitpid(child, &status, 0);
    Ran ran;
    ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ran.read = lseek(in, 0, SEEK_CUR);
    for (const int file : {in, out, err})
        close(file);
    ran.out = bytes_of(beside / "out");
    ran.err = bytes_of(beside / "err");
    return ran;
}

Ran CliTest::run_killed_at(const std::string& call, int n, const std::vector<std::string>& args) {
    const std::string wrinkle = std::exchange(program, "/usr/bin/env");
    std::vector<std::string> words = {"strace", "-f", "-qq", "-o", "/dev/null"};
    words.insert(words.end(), {"-e", "trace=" + call, "-e"});
    words.push_back("inject=" + call + ":signal=KILL:when=" + std::to_string(n));
    words.push_back(wrinkle);
    words.insert(words.end(), args.begin(), args.end());
    // LeakSanitizer cannot run in a traced process.
    const Ran ran = run(words, "", {"ASAN_OPTIONS=detect_leaks=0:intercept_tls_get_addr=0"});
    program = wrinkle;
    return ran;
}

fs::path CliTest::put(const std::string& name, std::string_view bytes) const {
    return temporary.put("work" / fs::path(name), bytes);
}

std::string CliTest::get(const std::string& name) const {
    return bytes_of(folder / name);
}

std::vector<std::string> CliTest::files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        names.push_back(entry.path().lexically_relative(folder).string());
    std::sort(names.begin(), names.end());
    return names;
}

const std::vector<std::string>& without_gl() {
    static const std::vector<std::string> environment = {
        "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent/vendor.json",
        "__EGL_VENDOR_LIBRARY_DIRS=/nonexistent"};
    return environment;
}

std::string tilt_graph(const std::string& slope) {
    return R"({
  "wrinkle": 1,
  "nodes": {
    "tilt": { "type": "gradient_from_volume", "in": { "volume": [)" +
           slope + R"(, 0, 0] } },
    "end": { "type": "resolve", "in": { "gradient": { "from": "tilt.gradient" } } }
  },
  "outputs": { "normal": { "from": "end.normal" } }
}
)";
}

std::string ramp_graph(const std::string& amount) {
    return R"({
  "wrinkle": 1,
  "nodes": {
    "split": { "type": "separate_vec2", "in": { "vector": { "from": "surface.uv0" } } },
    "scaled": { "type": "multiply", "in": { "a": { "from": "split.x" }, "b": )" +
           amount + R"( } }
  },
  "outputs": { "value": { "from": "scaled.result" } }
}
)";
}

testing::AssertionResult says(const std::string& text, const std::string& words) {
    if (text.find(words) != text.npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "'" << words << "' is not in: " << text;
}

json::Value parsed(const std::string& text) {
    Diagnostics diagnostics;
    const json::Parsed result = json::parse(text, "output", diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << to_text(diagnostics) << text;
    return result.root;
}

}  // namespace wrinkle::test
