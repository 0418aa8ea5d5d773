// Tests of many graphs in one call with failures: an invalid graph, a full disk, a folder without
// write permission, a sub-graph that disappears, a killed process. The other graphs are compiled,
// the exit code is that of the worst error, and no file is incomplete.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <thread>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

using Names = std::vector<std::string>;

class ManyGraphsTest : public CliTest {
protected:
    static std::string name(int i) { return "g" + std::to_string(i); }
    // Writes the graphs g0.json, g1.json, ...; returns their names.
    Names put_graphs(int count, const std::string& slope_begin = "0.") const {
        Names names;
        for (int i = 0; i < count; ++i) {
            put(name(i) + ".json", tilt_graph(slope_begin + std::to_string(i + 101)));
            names.push_back(name(i) + ".json");
        }
        return names;
    }
    static Names with(Names args, const Names& more) {
        args.insert(args.end(), more.begin(), more.end());
        return args;
    }
    // Returns the files in `made` that differ from those of the same name in `right`, or have none.
    Names strangers(const std::string& made, const std::string& right) const {
        Names found;
        for (const auto& each : fs::directory_iterator(folder / made)) {
            const std::string file = each.path().filename().string();
            const fs::path same = folder / right / file;
            if (!fs::exists(same) || bytes_of(same) != bytes_of(each.path())) found.push_back(file);
        }
        return found;
    }
};

TEST_F(ManyGraphsTest, TheWorstThatHappenedIsTheExitCode) {
    const Names graphs = put_graphs(12);
    put("g4.json", "{\"wrinkle\": 1, \"nodes\": {\"x\": {\"type\": \"nonsense\"}}}");
    put("out/g7.glsl/in_the_way", "");
    for (const char* jobs : {"-j1", "-j4"}) {
        const Ran ran = run(with({"compile", jobs, "-o", "out", "--reflect", "out"}, graphs));
        EXPECT_EQ(ran.code, 3);
        EXPECT_TRUE(says(ran.err, "g4.json:1:"));
        EXPECT_TRUE(says(ran.err, "out/g7.glsl: "));
        for (int i = 0; i < 12; ++i) {
            EXPECT_EQ(fs::is_regular_file(folder / "out" / (name(i) + ".glsl")), i != 4 && i != 7);
            EXPECT_EQ(exists("out/" + name(i) + ".json"), i != 4 && i != 7) << "all or none";
        }
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 2) << ran.err;
    }
}

TEST_F(ManyGraphsTest, AFolderThatIsClosedIsSaidOnce) {
    const Names graphs = put_graphs(3);
    fs::create_directories(folder / "closed");
    fs::permissions(folder / "closed", fs::perms::owner_read | fs::perms::owner_exec);
    fs::permissions(folder, fs::perms::all);
    unprivileged = true;
    if (run({"--version"}).code != 0) GTEST_SKIP() << "capabilities cannot be dropped";
    const Ran one = run({"compile", "g0.json", "-o", "closed/g0.glsl"});
    EXPECT_EQ(one.code, 3);
    EXPECT_TRUE(says(one.err, "closed/g0.glsl: cannot be written: Permission denied"));
    const Ran several = run(with({"compile", "-o", "closed"}, graphs));
    EXPECT_EQ(several.code, 3);
    EXPECT_TRUE(fs::is_empty(folder / "closed"));
    fs::permissions(folder / "closed", fs::perms::owner_all);
}

// Uses a small file system; skipped without the right to mount one.
TEST_F(ManyGraphsTest, AFullDiskHoldsWholeFilesOnly) {
    const Names graphs = put_graphs(24);
    ASSERT_EQ(run(with({"compile", "-o", "right"}, graphs)).code, 0);
    std::string all;
    for (const std::string& graph : graphs)
        all += " " + graph;
    const auto small_disk = [&](const std::string& commands) {
        put("do.sh", "set -e\ncd '" + folder.string() +
                         "'\nmount -t tmpfs -o size=40k none disk\n" + "set +e\n" + commands +
                         "\nls -A disk > list\ncp -r disk/. made\n");
        fs::create_directories(folder / "disk");
        fs::remove_all(folder / "made");
        fs::create_directories(folder / "made");
        const std::string call = "unshare -rm bash '" + (folder / "do.sh").string() + "'";
        return std::system((call + " > /dev/null 2>&1").c_str());
    };
    if (small_disk("true") != 0) GTEST_SKIP() << "no file system may be mounted here";
    for (const std::string jobs : {"1", "4"}) {
        ASSERT_EQ(small_disk("'" + program + "' compile -j" + jobs + " -o disk" + all +
                             " 2> err\necho $? > code"),
                  0);
        EXPECT_EQ(get("code"), "3\n");
        EXPECT_TRUE(says(get("err"), "No space left on device"));
        EXPECT_EQ(strangers("made", "right"), Names{}) << get("list");
        EXPECT_FALSE(fs::is_empty(folder / "made")) << "what fits is there";
    }
    // A full cache is only a warning.
    ASSERT_EQ(small_disk("head -c 100k /dev/zero > disk/full\n'" + program +
                         "' compile --cache disk/cache -o texts" + all +
                         " 2> err\necho $? > code\nrm -r disk/*"),
              0);
    EXPECT_EQ(get("code"), "0\n");
    EXPECT_TRUE(says(get("err"), "warning: the cache cannot be written"));
    EXPECT_EQ(strangers("texts", "right"), Names{});
}

TEST_F(ManyGraphsTest, AKilledCompilerLeavesWholeFiles) {
    const Names graphs = put_graphs(16);
    ASSERT_EQ(run(with({"compile", "--form", "shader", "-o", "old"}, graphs)).code, 0);
    put_graphs(16, "0.5");
    ASSERT_EQ(run(with({"compile", "--form", "shader", "-o", "new"}, graphs)).code, 0);
    fs::copy(folder / "old", folder / "out");
    size_t unfinished = 0;
    for (int i = 0; i < 30; ++i) {
        put_graphs(16, i % 2 ? "0." : "0.5");
        const pid_t child =
            start(with({"compile", "-j4", "--form", "shader", "-o", "out"}, graphs));
        usleep(static_cast<useconds_t>(700 * i));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        size_t old_texts = 0;
        for (const auto& each : fs::directory_iterator(folder / "old")) {
            const std::string file = each.path().filename().string();
            const std::string text = get("out/" + file);
            EXPECT_TRUE(text == get("old/" + file) || text == get("new/" + file)) << file;
            old_texts += text == get("old/" + file);
        }
        unfinished += old_texts != 0 && old_texts != 32;
    }
    ASSERT_EQ(run(with({"compile", "--form", "shader", "-o", "out"}, graphs)).code, 0);
    RecordProperty("killed_in_the_middle", static_cast<int>(unfinished));
}

// The sub-graph is removed and restored while it is read: an error that names it, or the complete
// output.
TEST_F(ManyGraphsTest, ASubgraphThatComesAndGoesIsThereOrMissing) {
    put("sub.json", tilt_graph());
    Names graphs;
    for (int i = 0; i < 8; ++i) {
        put(name(i) + ".json", R"({"wrinkle": 1, "nodes": {"s": {"type": "graph:sub.json"}},
            "outputs": {"normal": {"from": "s.normal"}}})");
        graphs.push_back(name(i) + ".json");
    }
    ASSERT_EQ(run(with({"compile", "-o", "right"}, graphs)).code, 0);
    std::atomic<bool> stop = false;
    std::thread mover([&] {
        while (!stop) {
            std::error_code ignored;
            fs::rename(folder / "sub.json", folder / "away.json", ignored);
            usleep(300);
            fs::rename(folder / "away.json", folder / "sub.json", ignored);
            usleep(300);
        }
    });
    size_t built = 0, missed = 0;
    for (int i = 0; i < 40 && (built == 0 || missed == 0 || i < 10); ++i) {
        fs::remove_all(folder / "out");
        fs::create_directories(folder / "out");
        const Ran ran = run(with({"compile", "-j2", "-o", "out", "--cache", "cache"}, graphs));
        const auto made = static_cast<size_t>(
            std::distance(fs::directory_iterator(folder / "out"), fs::directory_iterator()));
        EXPECT_EQ(ran.code, made == 8 ? 0 : 1) << ran.err;
        if (made < 8) {
            EXPECT_TRUE(says(ran.err, "sub.json"));
        }
        EXPECT_EQ(strangers("out", "right"), Names{});
        built += made;
        missed += 8 - made;
    }
    stop = true;
    mover.join();
    EXPECT_GT(built, 0u);
    EXPECT_GT(missed, 0u);
}

}  // namespace
}  // namespace wrinkle::test
