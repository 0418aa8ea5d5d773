// Tests of bakes in parts: shards, resumed bakes, merged parts; the result is always bit-identical.
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <chrono>
#include <thread>

#include "base/checksum.h"
#include "cli/bake_support.h"

namespace wrinkle::test {
namespace {

// Returns the text of a bake.json with its checksum corrected.
std::string sealed(std::string header) {
    header.erase(header.rfind(",\n  \"sum\""));
    return header + ",\n  \"sum\": \"" + sha256(header) + "\"\n}\n";
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    const size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return at == text.npos ? text : text.replace(at, from.size(), to);
}

std::string flipped(std::string bytes, size_t at) {
    bytes.at(at) = static_cast<char>(bytes[at] ^ 1);
    return bytes;
}

class BakePartsTest : public BakeTest {
protected:
    const Names maps = {"--map", "normal,height", "--type", "float", "--size", "200x300", "--udim"};

    Names with(const Names& more) const {
        Names all = maps;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    void shard(const std::string& part, const std::string& folder) const {
        const Ran ran = bake("teapot", folder, with({"--shard", part}));
        EXPECT_EQ(ran.code, 0) << ran.err;
    }
    Ran merge(Names folders) const {
        folders.insert(folders.begin(), {"bake", "--merge"});
        folders.insert(folders.end(), {"-o", "joined"});
        return run(folders);
    }
    std::string refused(const Names& folders) const {
        const Ran ran = merge(folders);
        EXPECT_EQ(ran.code, 1);
        EXPECT_FALSE(exists("joined"));
        return ran.err;
    }
};

TEST_F(BakePartsTest, AnyThreadsShardsAndInstructionsGiveTheSameBytes) {
    ASSERT_EQ(bake("teapot", "whole", with({"-j", "1"})).code, 0);
    const auto same = [&](const std::string& other) {
        for (const char* name : {"/normal.1001.exr", "/height.1001.exr"})
            EXPECT_TRUE(same_files("whole" + std::string(name), other + name));
    };
    for (const char* threads : {"2", "7"}) {
        ASSERT_EQ(bake("teapot", "threads", with({"-j", threads})).code, 0);
        same("threads");
    }
    Names base = with({});
    base.insert(base.begin(), {"bake", graph, "--mesh", "teapot", "-o", "base"});
    ASSERT_EQ(run(base, "", {"WRINKLE_ISA=baseline"}).code, 0);
    same("base");
    for (const int count : {2, 4, 9}) {  // the bake has five rows of tiles
        Names folders;
        for (int i = count; i >= 1; --i) {
            folders.push_back("part" + std::to_string(count) + "." + std::to_string(i));
            shard(std::to_string(i) + "/" + std::to_string(count), folders.back());
        }
        const Ran ran = merge(folders);
        ASSERT_EQ(ran.code, 0) << ran.err;
        same("joined");
        fs::remove_all(folder / "joined");
    }
}

TEST_F(BakePartsTest, AMergeWantsEveryShardOnce) {
    for (const char* part : {"1", "2", "3"})
        shard(std::string(part) + "/3", std::string("p") + part);
    EXPECT_TRUE(says(refused({"p1", "p2"}), "shard 3 of 3 is missing"));
    EXPECT_TRUE(says(refused({"p3", "p1"}), "shard 2 of 3 is missing"));
    EXPECT_TRUE(says(refused({"p3", "p1", "p2", "p1"}), "shard 1 of 3 is there twice"));
    EXPECT_TRUE(says(refused({"p1", "p2", "nowhere"}), "nowhere/bake.json: error: cannot be read"));
    const std::string header = get("p2/bake.json");
    put("p2/bake.json", header.substr(0, 60));
    EXPECT_TRUE(says(refused({"p1", "p2", "p3"}), "p2/bake.json: error: is damaged, or does not"));
    put("p2/bake.json", sealed(test::with(header, "\"normal\"", "\"/tmp/../x\"")));
    EXPECT_TRUE(says(refused({"p1", "p2", "p3"}), "p2/bake.json: error: is damaged, or does not"));
    put("p2/bake.json", sealed(test::with(header, "\"done\": 3,", "\"done\": 2,")));
    EXPECT_TRUE(says(refused({"p1", "p2", "p3"}), "p2: error: shard 2 of 3 is not finished"));
    put("p2/bake.json", header);
    const std::string rows = get("p2/0-1.rows");
    put("p2/0-1.rows", rows.substr(0, rows.size() - 1));
    EXPECT_TRUE(says(refused({"p1", "p2", "p3"}), "p2/0-1.rows: error: ends early"));
    put("p2/0-1.rows", rows);
    EXPECT_EQ(merge({"p1", "p2", "p3"}).code, 0);
}

TEST_F(BakePartsTest, AMergeRefusesPartsOfAnotherBake) {
    shard("1/2", "p1");
    const Ran ran = bake("teapot", "p2", with({"--shard", "2/2", "--dilate", "3"}));
    EXPECT_EQ(ran.code, 0);
    EXPECT_TRUE(says(refused({"p1", "p2"}), "p2: error: is a part of another bake than p1"));
    EXPECT_EQ(bake("sphere", "p2", with({"--shard", "2/2"})).code, 0);
    EXPECT_TRUE(says(refused({"p1", "p2"}), "another bake"));
}

TEST_F(BakePartsTest, AMergeRefusesRowsThatWereDamaged) {
    for (const char* part : {"1", "2", "3"})
        shard(std::string(part) + "/3", std::string("p") + part);
    const Names all = {"p1", "p2", "p3"};
    const std::string rows = get("p2/0-1.rows");
    ASSERT_GT(rows.size(), 100U);
    const auto check = [&](const std::string& bytes, const std::string& why) {
        put("p2/0-1.rows", bytes);
        EXPECT_TRUE(says(refused(all), "p2/0-1.rows: error: " + why));
    };
    const std::string damaged = "does not hold the rows that were baked";
    check("", "ends early");
    check(rows.substr(0, rows.size() - 1), "ends early");
    for (const size_t at : {size_t{0}, rows.size() / 2, rows.size() - 1})
        check(flipped(rows, at), damaged);
    check(std::string(rows.size(), '\0'), damaged);
    check(get("p2/0-0.rows").substr(0, rows.size()), damaged);
    fs::remove(folder / "p2/0-1.rows");
    EXPECT_TRUE(says(refused(all), "p2/0-1.rows: error: cannot be read"));
    EXPECT_TRUE(says(refused(all), "bake shard 2 of 3 again"));
    ASSERT_EQ(mkfifo((folder / "p2/0-1.rows").c_str(), 0600), 0);
    EXPECT_TRUE(says(refused(all), "p2/0-1.rows: error: is a pipe, not a file"));
    fs::remove(folder / "p2/0-1.rows");
    put("p2/0-1.rows", rows);
    const std::string first = get("p1/0-1.rows");
    put("p1/0-1.rows", rows);
    EXPECT_TRUE(says(refused(all), "p1/0-1.rows: error: " + damaged));
    put("p1/0-1.rows", first);
    EXPECT_EQ(merge(all).code, 0);
}

TEST_F(BakePartsTest, AMergeRefusesAHeaderWithOneByteFlipped) {
    shard("1/2", "p1");
    shard("2/2", "p2");
    const std::string header = get("p2/bake.json");
    for (size_t at = 0; at < header.size(); at += 41) {
        put("p2/bake.json", flipped(header, at));
        EXPECT_TRUE(says(refused({"p1", "p2"}), "p2/bake.json: error: ")) << at;
    }
    put("p2/bake.json", header);
    EXPECT_EQ(merge({"p1", "p2"}).code, 0);
}

TEST_F(BakePartsTest, AHeaderHasTheSumsOfTheRowsOnDisk) {
    shard("1/2", "p1");
    const json::Value sums = parsed(get("p1/bake.json")).find("sums");
    ASSERT_EQ(sums.size(), 2U);
    for (size_t map = 0; map < 2; ++map) {
        Xxh64 sum;
        const std::string rows = get("p1/0-" + std::to_string(map) + ".rows");
        sum.add(std::as_bytes(std::span(rows)));
        EXPECT_EQ(sums.at(map).as_string(), sum.digest());
    }
}

// Reading a pipe or /dev/zero to its end blocks or uses up the memory.
TEST_F(BakePartsTest, AHeaderThatIsNotARegularFileIsRefused) {
    shard("1/2", "p1");
    shard("2/2", "p2");
    memory = rlim_t{4} << 30;
    const fs::path header = folder / "p2/bake.json";
    const auto check = [&](const std::string& why) {
        EXPECT_TRUE(says(refused({"p1", "p2"}), "p2/bake.json: error: " + why));
    };
    const auto check_bake = [&](const Names& more) {
        Names all = maps;
        all.insert(all.end(), {"--shard", "2/2"});
        all.insert(all.end(), more.begin(), more.end());
        const Ran ran = bake("teapot", "p2", all);
        EXPECT_EQ(ran.code, 3);
        EXPECT_TRUE(says(ran.err, "p2/bake.json: error: is not a regular file"));
    };
    fs::remove(header);
    ASSERT_EQ(mkfifo(header.c_str(), 0600), 0);
    check("is a pipe, not a file");
    check_bake({"--resume"});
    check_bake({});
    fs::remove(header);
    fs::create_symlink("/dev/zero", header);
    check("is a device, not a file");
    check_bake({"--resume"});
    fs::remove(header);
    put("p2/bake.json", "{");
    fs::resize_file(header, uint64_t{1} << 40);
    check("is larger than 1073741824 bytes");
    EXPECT_EQ(bake("teapot", "p2", with({"--shard", "2/2", "--resume"})).code, 0);
    EXPECT_EQ(merge({"p1", "p2"}).code, 0);
}

// A bake slow enough to be killed: every texel in one thread.
class BakeStoppedTest : public BakeTest {
protected:
    const Names slow = {"--size", "512x4096", "-j", "1", "--map", "normal,roughness,height"};

    pid_t begin(const std::string& out, const Names& more) const {
        Names all = {"bake", graph, "--mesh", "plane", "-o", out};
        all.insert(all.end(), slow.begin(), slow.end());
        all.insert(all.end(), more.begin(), more.end());
        return start(all);
    }
    // Waits until the first work is done. Returns false if the process ended before.
    bool under_way(pid_t child, const fs::path& sign) const {
        int status = 0;
        while (waitpid(child, &status, WNOHANG) == 0) {
            if (is_under_way(sign)) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    }
    static int end(pid_t child, int signal) {
        kill(child, signal);
        int status = 0;
        waitpid(child, &status, 0);
        return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    }

private:
    bool is_under_way(const fs::path& sign) const {
        std::error_code error;
        if (fs::exists(folder / sign / "bake.json", error)) {
            const std::string text = get((sign / "bake.json").string());
            return !says(text, "\"done\": 0") && says(text, "\"done\"");
        }
        return sign.empty() && !files().empty() && files().size() >= 2;
    }
};

TEST_F(BakeStoppedTest, CtrlCLeavesNothing) {
    const pid_t child = begin("out", {});
    ASSERT_TRUE(under_way(child, ""));
    EXPECT_EQ(end(child, SIGINT), SIGINT);
    EXPECT_EQ(files(), Names{"out"});
}

TEST_F(BakeStoppedTest, WhatWasKilledGoesOn) {
    MANY_PROCESSES;
    for (const int signal : {SIGKILL, SIGINT}) {
        const pid_t child = begin("out", {"--resume"});
        ASSERT_TRUE(under_way(child, "out.part"));
        ASSERT_EQ(end(child, signal), signal);
        EXPECT_FALSE(exists("out"));
        ASSERT_TRUE(exists("out.part/bake.json"));
    }
    const double before = parsed(get("out.part/bake.json")).find("done").as_number();
    Names all = slow;
    all.insert(all.end(), {"--resume", "--json"});
    const Ran ran = bake("plane", "out", all);
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_FALSE(exists("out.part"));
    // The first progress line already counts the texels of the killed run: they are not baked
    // again.
    const double first = parsed(ran.out.substr(0, ran.out.find('\n'))).find("done").as_number();
    EXPECT_GE(before, 1);
    EXPECT_GE(first, (before + 1) * 64 * 512);
    const Ran whole = bake("plane", "whole", slow);
    ASSERT_EQ(whole.code, 0) << whole.err;
    // The messages about the maps cover all rows.
    EXPECT_TRUE(says(whole.err, "the map 'height' holds "));
    EXPECT_EQ(ran.err, whole.err);
    EXPECT_TRUE(same_files("out/normal.png", "whole/normal.png"));
    EXPECT_TRUE(same_files("out/roughness.png", "whole/roughness.png"));
}

// A bake is killed after some rows and its files are damaged: the rows are baked again.
TEST_F(BakeStoppedTest, DamagedRowsAreBakedAgainAndSaidSo) {
    MANY_PROCESSES;
    ASSERT_EQ(bake("plane", "whole", slow).code, 0);
    Names all = slow;
    all.emplace_back("--resume");
    const auto resumed = [&](const std::string& file, auto damage, const std::string& why) {
        const pid_t child = begin("out", {"--resume"});
        ASSERT_TRUE(under_way(child, "out.part"));
        ASSERT_EQ(end(child, SIGKILL), SIGKILL);
        put("out.part/" + file, damage(get("out.part/" + file)));
        const Ran ran = bake("plane", "out", all);
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_TRUE(says(ran.err, "out.part/" + file + ": warning: " + why)) << ran.err;
        EXPECT_TRUE(says(ran.err, "all rows are baked again"));
        for (const char* name : {"/normal.png", "/roughness.png", "/height.png"})
            EXPECT_TRUE(same_files("out" + std::string(name), "whole" + std::string(name))) << file;
        fs::remove_all(folder / "out");
    };
    const auto empty = [](const std::string&) { return std::string(); };
    const auto flip = [](const std::string& bytes) { return flipped(bytes, 1000); };
    const auto flip_done = [](const std::string& text) {
        return test::with(text, "\"done\": ", "\"done\": 1");
    };
    resumed("0-1.rows", empty, "ends early");
    resumed("0-2.rows", flip, "does not hold the rows that were baked");
    resumed("bake.json", flip_done, "is damaged");
}

TEST_F(BakeStoppedTest, AnotherBakeBeginsAnew) {
    const pid_t child = begin("out", {"--resume"});
    ASSERT_TRUE(under_way(child, "out.part"));
    end(child, SIGKILL);
    Names other = {"--size", "64", "--map", "normal,roughness"};
    ASSERT_EQ(bake("cube", "whole", other).code, 0);
    other.emplace_back("--resume");
    ASSERT_EQ(bake("cube", "out", other).code, 0);
    EXPECT_TRUE(same_files("out/normal.png", "whole/normal.png"));
}

TEST_F(BakePartsTest, APipeInPlaceOfRowsIsReplaced) {
    fs::create_directories(folder / "p1");
    ASSERT_EQ(mkfifo((folder / "p1/0-1.rows").c_str(), 0600), 0);
    put("aside", "another file");
    fs::create_symlink("../aside", folder / "p1/0-0.rows");
    shard("1/2", "p1");
    shard("2/2", "p2");
    EXPECT_EQ(get("aside"), "another file");
    EXPECT_EQ(merge({"p1", "p2"}).code, 0);
}

TEST_F(BakePartsTest, RowsThatCannotBeWrittenAreOfAMap) {
    fs::create_directories(folder / "p" / "0-1.rows");
    const Ran ran = bake("teapot", "p", with({"--shard", "1/2"}));
    EXPECT_EQ(ran.code, 3);
    EXPECT_TRUE(says(ran.err, "p/0-1.rows: error: rows of the map 'height' cannot be written: "));
}

TEST_F(BakeTest, DependenciesHaveTheFilesBesideAMesh) {
    const std::array<float, 15> numbers = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 1, 1, 1, 0};
    put("parts/m.bin", std::string(reinterpret_cast<const char*>(numbers.data()), sizeof numbers));
    put("m.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "scene": 0,
        "nodes": [{"mesh": 0}], "buffers": [{"uri": "parts/m.bin", "byteLength": 60}],
        "bufferViews": [{"buffer": 0, "byteLength": 36},
            {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
        "images": [{"uri": "never_read.png"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}}]}]})");
    put("g.json", ramp_graph());
    graph = "g.json";
    const Ran ran = bake("m.gltf", "v.png", {"--map", "value", "--size", "8", "-MD"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(get("v.png.d"), "v.png: \\\n  g.json \\\n  m.gltf \\\n  ./parts/m.bin\n");
}

TEST_F(BakeTest, DependenciesAreWhatWasRead) {
    put("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n");
    put("inner.json", ramp_graph());
    put("g.json", R"({"wrinkle": 1, "nodes": {"sub": {"type": "graph:inner.json"}},
        "outputs": {"value": {"from": "sub.value"}}})");
    graph = "g.json";
    const Names more = {"--map", "value", "--size", "8", "-MD"};
    ASSERT_EQ(bake("m.obj", "v.png", more).code, 0);
    EXPECT_EQ(get("v.png.d"), "v.png: \\\n  g.json \\\n  inner.json \\\n  m.obj\n");
    Names part = more;
    part.insert(part.end(), {"-MF", "d", "--shard", "1/2"});
    ASSERT_EQ(bake("m.obj", "p", part).code, 0);
    EXPECT_TRUE(get("d").starts_with("p/bake.json: "));
}

TEST_F(BakeTest, ProgressIsALineOfJsonEach) {
    const Ran ran = bake("plane", "out/n.png", {"--size", "256", "--json", "--dilate", "0"});
    ASSERT_EQ(ran.code, 0);
    EXPECT_EQ(ran.err, "");
    size_t lines = 0;
    double done = 0;
    std::string rest = ran.out;
    for (; !says(rest.substr(0, 9), "\"files\""); ++lines) {
        const json::Value line = parsed(rest.substr(0, rest.find('\n')));
        EXPECT_GT(line.find("done").as_number(), done);
        done = line.find("done").as_number();
        EXPECT_EQ(line.find("total").as_number(), 256 * 256);
        EXPECT_GT(line.find("per_second").as_number(), 0);
        EXPECT_GE(line.find("seconds_left").as_number(), 0);
        rest = rest.substr(rest.find('\n') + 1);
    }
    EXPECT_EQ(lines, 4U);
    EXPECT_EQ(done, 256 * 256);
    EXPECT_EQ(parsed(rest).find("files").at(0).as_string(), "out/n.png");
}

}  // namespace
}  // namespace wrinkle::test
