// Tests with SIGKILL at every system call that changes the disk: each file is complete, the
// checksums of the reflection show whether all files are of one run, and the next run removes all
// temporary files.
#include "base/checksum.h"
#include "cli/support.h"

namespace wrinkle::test {
namespace {

using Names = std::vector<std::string>;

class KilledTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        MANY_PROCESSES;
    }

    // System calls at which a run is killed; strace counts each call separately.
    Names calls = {"write", "pwrite64", "writev", "pwritev", "rename", "unlink",
                   "flock", "fchmod",   "fsync",  "mkdir",   "openat"};

    std::vector<std::string> contents(const Names& names) const {
        std::vector<std::string> bytes;
        for (const std::string& name : names)
            bytes.push_back(get(name));
        return bytes;
    }

    // `change` modifies the input such that the contents of all `names` change. `judge` checks the
    // result of a killed run: it gets for each name true if the file is new.
    template <typename Change, typename Judge>
    void expect_whole(const Names& words, const Names& names, Change change, Judge judge) {
        ASSERT_EQ(run(words).code, 0);
        const auto old = contents(names);
        change();
        ASSERT_EQ(run(words).code, 0);
        const auto fresh = contents(names);
        const Names all_files = files();
        for (size_t i = 0; i < names.size(); ++i)
            ASSERT_NE(old[i], fresh[i]) << names[i];
        int killed = 0;
        for (const std::string& call : calls)
            for (int n = 1;; ++n) {
                SCOPED_TRACE(call + " " + std::to_string(n));
                for (size_t i = 0; i < names.size(); ++i)
                    put(names[i], old[i]);
                const Ran ran = run_killed_at(call, n, words);
                std::vector<bool> is_new;
                for (size_t i = 0; i < names.size(); ++i) {
                    const std::string bytes = get(names[i]);
                    is_new.push_back(bytes == fresh[i]);
                    ASSERT_TRUE(bytes == old[i] || bytes == fresh[i]) << names[i] << "\n" << bytes;
                }
                judge(is_new);
                if (ran.code == 0) break;
                ASSERT_EQ(ran.code, 128 + SIGKILL) << ran.err;
                ++killed;
                if (files() == all_files && contents(names) == old) continue;  // no change
                ASSERT_EQ(run(words).code, 0);
                ASSERT_EQ(contents(names), fresh);
                ASSERT_EQ(files(), all_files);
            }
        EXPECT_GE(killed, 6);
    }
};

TEST_F(KilledTest, ACompilationLeavesWholeFilesAndItsReflectionSaysWhetherTheyAreOfOneRun) {
    put("g.json", tilt_graph("0.25"));
    fs::create_directory(folder / "out");
    const Names names = {"out/g.vert", "out/g.frag", "out/g.d", "out/g.json"};
    const auto judge = [&](const std::vector<bool>& is_new) {
        const json::Value reflection = parsed(get("out/g.json"));
        const json::Value sums = reflection.find("sha256");
        const bool match = sums.find("vertex").as_string() == sha256(get("out/g.vert")) &&
                           sums.find("fragment").as_string() == sha256(get("out/g.frag"));
        EXPECT_EQ(match, is_new[0] == is_new[3] && is_new[1] == is_new[3]);
        EXPECT_TRUE(!is_new[3] || (is_new[0] && is_new[1] && is_new[2]))
            << "the last is placed first";
    };
    const auto change = [&] {
        put("g.json", R"({"wrinkle": 1, "nodes": {
            "sub": {"type": "graph:inner.json"},
            "map": {"type": "image", "in": {"image": "map.png"}}},
            "outputs": {"normal": {"from": "sub.normal"}, "color": {"from": "map.color"}}})");
        put("inner.json", tilt_graph("0.5"));
        put("map.png", "P6\n2 2\n255\nabcdefghijkl");
    };
    expect_whole({"compile", "g.json", "--form", "shader", "-o", "out/g", "--reflect", "out/g.json",
                  "-MD", "-MF", "out/g.d", "--name", "g"},
                 names, change, judge);
}

TEST_F(KilledTest, ABakeLeavesWholeImages) {
    calls.pop_back();  // "openat" opens 260 libraries; flock follows each created file
    put("g.json", tilt_graph("0.25"));
    put("plane.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    expect_whole(
        {"bake", "g.json", "--mesh", "plane.obj", "--size", "8", "--map", "normal", "-j", "1", "-o",
         "out/n.exr"},
        {"out/n.exr"}, [&] { put("g.json", tilt_graph("0.5")); }, [](const std::vector<bool>&) {});
}

}  // namespace
}  // namespace wrinkle::test
