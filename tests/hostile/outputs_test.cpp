// Tests of every command with unwritable outputs (a full disk; standard output full, closed or
// without a reader), or killed while it writes. Each output is then complete: unchanged, or as a
// successful run writes it.
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <map>

#include "hostile/support.h"

namespace wrinkle::hostile {
namespace {

using Names = std::vector<std::string>;

// A command and its outputs: files and folders relative to the project's folder.
struct Command {
    Names args;
    std::set<std::string> outputs = {};
};

const std::vector<Command> all_commands = {
    {{"check", "graph.json"}},
    {{"check", "wrong.json", "--diagnostics", "json"}},
    {{"compile", "graph.json"}},
    {{"compile", "graph.json", "--cost"}},
    {{"compile", "graph.json", "-o", "out.glsl", "--reflect", "r.json", "-MD", "-MF", "out.d"},
     {"out.glsl", "r.json", "out.d"}},
    {{"compile", "graph.json", "-o", "out", "--form", "shader"}, {"out.vert", "out.frag"}},
    {{"compile", "graph.json", "other.json", "-o", "out", "--reflect", "out"}, {"out"}},
    {{"compile", "graph.json", "-o", "out.glsl", "--cache", "kept"}, {"out.glsl", "kept"}},
    {{"eval", "graph.json", "--mesh", "plane", "--uv", "0.5,0.5"}},
    {{"render", "graph.json", "-o", "out.png", "--size", "8x8"}, {"out.png"}},
    {{"render", "graph.json", "-o", "-", "--size", "8x8"}},
    {{"bake", "graph.json", "--mesh", "plane", "--size", "8", "-o", "out.png"}, {"out.png"}},
    {{"bake", "graph.json", "--mesh", "plane", "--size", "8", "-o", "out", "--map",
      "normal,derivative"},
     {"out"}},
    {{"bake", "graph.json", "--mesh", "plane", "--size", "8", "-o", "part", "--shard", "1/2"},
     {"part"}},
    {{"convert", "height.png", "-o", "out.exr", "--to", "slopes", "--mips"}, {"out.exr"}},
    {{"convert", "height.png", "-o", "out.png", "--to", "normal"}, {"out.png"}},
    {{"lint", "height.png", "--json"}},
    {{"compare", "height.png", "height.png", "-o", "out.png"}, {"out.png"}},
    {{"import", "height.png", "-o", "out.json"}, {"out.json"}},
    {{"export", "graph.json", "--to", "gltf", "--size", "8", "-o", "out"}, {"out"}},
    {{"diff", "graph.json", "other.json", "--exit-zero"}},
    {{"diff", "graph.json", "other.json", "--exit-zero", "--report", "out"}, {"out"}},
    {{"merge", "graph.json", "graph.json", "other.json", "-o", "out.json"}, {"out.json"}},
    {{"textconv", "graph.json"}},
    {{"test", ".", "--report", "out"}, {"out"}},
    {{"test", ".", "--update"}, {"golden", "graph.test.json", ".wrinkle"}},
    {{"format", "ugly.json"}, {"ugly.json"}},
    {{"inputs", "graph.json", "--json"}},
    {{"nodes", "--json"}},
    {{"nodes", "--schema"}},
    {{"plugins"}},
    {{"plugins", "--manifest", "nodes.so"}, {"nodes.so.json"}},
    {{"new-plugin", "my_node"}, {"my_node"}},
    {{"explain-log", "graph.json", "driver.log"}},
    {{"completion", "bash"}},
    {{"man", "compile"}},
};

// Returns true for temporary files, and for rows that bake.json does not count yet.
bool may_be_unfinished(const std::string& name) {
    return name.find(".wrinkle-tmp-") != name.npos || name.find(".tmp") != name.npos ||
           name.ends_with(".rows");
}

class HostileOutputs : public HostileTest {
protected:
    void SetUp() override {
        HostileTest::SetUp();
        put("graph.json", test::tilt_graph());
        put("other.json", test::tilt_graph("0.5"));
        put("ugly.json", R"({"nodes": {}, "wrinkle":1})");
        put("wrong.json", R"({"wrinkle": 1, "nodes": {"x": {"type": "none"}}})");
        put("graph.test.json", R"({"points": [{"normal": [0, 0, 1]}],
 "expect": [{"normal": [0, 0, 1]}], "glsl": true, "render": {"size": "8x8"}})");
        put("driver.log", "0:3(1): error: bad\n");
        fs::copy_file(WRINKLE_SOURCE_DIR "/graphs/textures/bricks_height.png",
                      folder / "height.png");
        fs::copy_file(WRINKLE_RIPPLES, folder / "nodes.so");
        run({"test", "."});  // fills the caches
        baseline();
        for (const std::string& name : files())
            if (fs::is_regular_file(folder / name)) originals_[name] = get(name);
    }

    static constexpr bool runs_all = WRINKLE_PAYLOAD_STRIDE == 1;
    // True for two of three cases, others with each command, unless all tests run.
    bool is_left_out() { return !runs_all && turn_++ % 3 != 0; }

    void restore() {
        clean();
        for (const auto& [name, bytes] : originals_)
            if (!exists(name) || get(name) != bytes) put(name, bytes);
    }

    std::map<std::string, std::string> outputs_of(const Command& command) const {
        std::map<std::string, std::string> found;
        for (const std::string& name : files())
            for (const std::string& output : command.outputs)
                if ((name == output || name.starts_with(output + "/")) &&
                    fs::is_regular_file(folder / name))
                    found[name] = get(name);
        return found;
    }

    // Checks after a failed run: every file is unchanged or as a successful run writes it.
    void expect_whole(const Command& command, const std::map<std::string, std::string>& good,
                      const std::string& label, bool was_killed = false) {
        for (const auto& [name, bytes] : outputs_of(command)) {
            if (was_killed && may_be_unfinished(name)) continue;
            const auto old = originals_.find(name);
            const auto meant = good.find(name);
            const bool whole = (old != originals_.end() && old->second == bytes) ||
                               (meant != good.end() && meant->second == bytes);
            EXPECT_TRUE(whole) << label << ": '" << name << "' is cut or strange, " << bytes.size()
                               << " bytes";
        }
    }

    // Returns the outputs of a run of the command without failures.
    std::map<std::string, std::string> good_outputs(const Command& command) {
        restore();
        run(command.args);
        auto found = outputs_of(command);
        restore();
        return found;
    }

    // Runs the program with these descriptors as its standard streams.
    int run_with(const Names& args, int in, int out, int err) {
        const pid_t child = start(args, in, out, err, {});
        int status = 0;
        waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

private:
    std::map<std::string, std::string> originals_;
    size_t turn_ = 0;
};

std::string words_of(const Names& args) {
    std::string words;
    for (const std::string& arg : args)
        words += " " + arg;
    return words;
}

bool is_cached(const std::pair<const std::string, std::string>& file) {
    return file.first.starts_with("kept/");
}

TEST_F(HostileOutputs, OnAFullDiskAreWhole) {
    for (const Command& command : all_commands) {
        const auto good = good_outputs(command);
        for (const rlim_t size : {rlim_t{1}, rlim_t{100}, rlim_t{1000}, rlim_t{5000}}) {
            if (is_left_out()) continue;
            const std::string label =
                words_of(command.args) + " with files of " + std::to_string(size) + " bytes";
            // Messages go to a pipe, because the size of files is limited.
            int pipes[2] = {};
            ASSERT_EQ(pipe(pipes), 0);
            file_size = size;
            const int nothing = open("/dev/null", O_RDWR);
            const int code = run_with(command.args, nothing, nothing, pipes[1]);
            file_size = RLIM_INFINITY;
            close(nothing);
            close(pipes[1]);
            close(pipes[0]);
            EXPECT_GE(code, 0) << label;
            EXPECT_LE(code, 3) << label;
            auto made = outputs_of(command);
            if (code == 0) {
                // A cache that cannot be written is a warning; the other outputs are unaffected.
                std::erase_if(made, is_cached);
                auto wanted = good;
                std::erase_if(wanted, is_cached);
                EXPECT_EQ(made, wanted) << label;
            }
            expect_whole(command, good, label);
            restore();
        }
    }
}

// The command is killed with SIGKILL at each system call that changes the disk. All files are then
// complete, and running the command again succeeds.
TEST_F(HostileOutputs, KilledAtEachChangeOfTheDiskAreWholeAndRunAgain) {
    MANY_PROCESSES;
    const Names calls = {"write",  "pwrite64", "writev", "pwritev", "rename",
                         "unlink", "flock",    "fchmod", "fsync",   "mkdir"};
    for (const Command& command : all_commands) {
        if (command.outputs.empty()) continue;
        const auto good = good_outputs(command);
        for (const std::string& call : calls) {
            if (is_left_out()) continue;
            for (int n = 1;; n += runs_all ? 1 : 7) {
                const std::string label =
                    words_of(command.args) + " killed at " + call + " " + std::to_string(n);
                const Ran ran = run_killed_at(call, n, command.args);
                ++cases;
                expect_whole(command, good, label, true);
                if (ran.code != 128 + SIGKILL) break;
                run(command.args);
                auto made = outputs_of(command);
                std::erase_if(made, is_cached);
                auto wanted = good;
                std::erase_if(wanted, is_cached);
                EXPECT_EQ(made, wanted) << label << ", and again";
                restore();
            }
        }
        restore();
    }
}

TEST_F(HostileOutputs, WithoutAUsableStandardOutputEndByTheContract) {
    const int nothing = open("/dev/null", O_RDWR), full = open("/dev/full", O_RDWR);
    for (const Command& command : all_commands) {
        const auto good = good_outputs(command);
        const bool prints = !run(command.args).out.empty();
        restore();
        int broken[2] = {};
        ASSERT_EQ(pipe(broken), 0);
        close(broken[0]);
        const std::vector<std::tuple<std::string, int, int, int>> ways = {
            {"full output", nothing, full, nothing},
            {"closed output", nothing, -1, nothing},
            {"closed error", nothing, nothing, -1},
            {"full error", nothing, nothing, full},
            {"closed input", -1, nothing, nothing},
            {"all closed", -1, -1, -1},
            {"unread output", nothing, broken[1], nothing},
            {"unread error", nothing, nothing, broken[1]},
        };
        for (const auto& [way, in, out, err] : ways) {
            if (is_left_out()) continue;
            const std::string label = words_of(command.args) + " with " + way;
            int code = run_with(command.args, in, out, err);
            // SIGPIPE ends the program, as usual for a filter without a reader.
            if (way.starts_with("unread") && code == 128 + SIGPIPE) code = 0;
            EXPECT_GE(code, 0) << label;
            EXPECT_LE(code, 3) << label;
            if (prints && (way == "full output" || way == "closed output")) {
                EXPECT_EQ(code, 3) << label;
            }
            expect_whole(command, good, label);
            restore();
        }
        close(broken[1]);
    }
    close(nothing);
    close(full);
}

}  // namespace
}  // namespace wrinkle::hostile
