// Tests of wrinkle compile --cache: hits and misses write the same output, and no change of the
// cache folder makes a wrong output.
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>

#include "base/checksum.h"
#include "cli/support.h"

namespace wrinkle::test {
namespace {

using Names = std::vector<std::string>;

class CacheTest : public CliTest {
protected:
    Ran compile(const Names& more, const std::string& graph = "g.json") const {
        Names args{"compile", graph, "-o", "out/g", "--cache", "cache"};
        args.insert(args.end(), more.begin(), more.end());
        fs::create_directories(folder / "out");
        return run(args);
    }

    std::vector<fs::path> entries(const std::string& cache = "cache") const {
        std::vector<fs::path> found;
        if (exists(cache))
            for (const auto& each : fs::recursive_directory_iterator(folder / cache))
                if (each.is_regular_file()) found.push_back(each.path());
        return found;
    }
    fs::path entry_in(const std::string& cache) const { return entries(cache).at(0); }

    // Overwrites one byte of every entry.
    void damage(size_t from_end) const {
        for (const fs::path& path : entries()) {
            std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
            file.seekp(-static_cast<std::streamoff>(from_end), std::ios::end);
            file.put('#');
        }
    }

    // The payload of an entry: the bytes after its first line and its checksum.
    static std::string payload(const fs::path& entry) {
        return bytes_of(entry).substr(head.size() + 65);
    }

    // Writes an entry with a valid checksum, as any process with write access to the folder can.
    static void forge(const fs::path& entry, const std::string& bytes) {
        std::ofstream(entry, std::ios::binary)
            << head << sha256(entry.filename().string() + sha256(bytes)) << '\n'
            << bytes;
    }

    static inline const std::string head = "wrinkle cache 2\n";

    // Concatenates all files below out/.
    std::string made() const {
        std::string all;
        for (const std::string& name : files())
            if (name.starts_with("out/")) all += name + "\n" + get(name);
        return all;
    }
};

// An entry shows the difference: a hit leaves it unchanged, a miss writes a new one.
TEST_F(CacheTest, AHitWritesWhatAMissWrites) {
    put("g.json", tilt_graph());
    for (const Names& more :
         {Names{}, Names{"--form", "shader"}, Names{"--params", "uniform"},
          Names{"--srgb", "shader"}, Names{"--uv-origin", "top"}, Names{"--normal-space", "view"},
          Names{"--differentials", "given"}, Names{"--name", "other"}, Names{"--no-tangents"},
          Names{"--set", "tilt.volume=[0.5, 0, 0]"}}) {
        Names args = more;
        args.insert(args.end(), {"--reflect", "out/r.json", "-MD"});
        const size_t before = entries().size();
        ASSERT_EQ(compile(args).code, 0);
        const std::string fresh = made();
        EXPECT_EQ(entries().size(), before + 1) << testing::PrintToString(more);
        fs::remove_all(folder / "out");
        ASSERT_EQ(compile(args).code, 0);
        EXPECT_EQ(made(), fresh);
        EXPECT_EQ(entries().size(), before + 1);
        fs::remove_all(folder / "out");
    }
}

TEST_F(CacheTest, AHitTakesTheTextFromTheEntry) {
    put("g.json", tilt_graph());
    put("h.json", tilt_graph("0.25"));
    ASSERT_EQ(compile({"--name", "n"}).code, 0);
    const fs::path entry = entries().at(0);
    ASSERT_EQ(run({"compile", "h.json", "--name", "n", "--cache", "other"}).code, 0);
    forge(entry, payload(entry_in("other")));
    ASSERT_EQ(compile({"--name", "n"}).code, 0);
    EXPECT_EQ(get("out/g"), run({"compile", "h.json", "--name", "n"}).out);
}

TEST_F(CacheTest, AnEntryStoredUnderAnotherKeyIsMadeAgain) {
    put("g.json", tilt_graph());
    put("h.json", tilt_graph("0.25"));
    ASSERT_EQ(compile({"--name", "n"}).code, 0);
    const std::string right = get("out/g");
    const fs::path entry = entries().at(0);
    const std::string stored = bytes_of(entry);
    ASSERT_EQ(run({"compile", "h.json", "--name", "n", "--cache", "other"}).code, 0);
    fs::copy_file(entry_in("other"), entry, fs::copy_options::overwrite_existing);
    const Ran ran = compile({"--name", "n"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(get("out/g"), right);
    EXPECT_EQ(bytes_of(entry), stored);
}

// Serialises the fields of a payload as join_fields() does.
std::string fields(const Names& each) {
    std::string bytes;
    for (const std::string& field : each)
        bytes += std::to_string(field.size()) + "\n" + field;
    return bytes;
}

TEST_F(CacheTest, AForgedEntryWritesNoFileButTheOutputs) {
    put("g.json", tilt_graph());
    for (const bool pair : {false, true}) {
        const Names more = {"--form", pair ? "shader" : "function"};
        fs::remove_all(folder / "cache");
        ASSERT_EQ(compile(more).code, 0);
        const fs::path entry = entries().at(0);
        const Names before = files();
        // Fields in the older layout (counts, stages, suffixes), and many texts.
        for (const Names& forged :
             {Names{"1", "", "", "", "/../../escaped", "evil"},
              Names{"2", "", "", "vertex", ".vert", "a", "fragment", "/../../escaped", "evil"},
              Names{"", "", "evil", "evil", "evil", "/../../escaped", "evil", "", "", "", ""},
              Names{"/../../escaped", "/../../escaped", "/../../escaped"}}) {
            forge(entry, fields(forged));
            EXPECT_EQ(compile(more).code, 0);
            EXPECT_EQ(files(), before) << testing::PrintToString(forged);
            EXPECT_FALSE(fs::exists(folder / "escaped"));
            EXPECT_FALSE(fs::exists(folder.parent_path() / "escaped"));
        }
    }
}

// Reading a pipe or /dev/zero to its end blocks or uses up the memory.
TEST_F(CacheTest, AnEntryThatIsNotARegularFileIsMadeAgain) {
    put("g.json", tilt_graph());
    ASSERT_EQ(compile({}).code, 0);
    const std::string right = get("out/g");
    const fs::path entry = entries().at(0);
    const std::string stored = bytes_of(entry);
    memory = rlim_t{2} << 30;
    const auto is_made_again = [&](const std::string& kind) {
        const Ran ran = compile({});
        EXPECT_EQ(ran.code, 0) << kind << ran.err;
        EXPECT_EQ(ran.err, "") << kind;
        EXPECT_EQ(get("out/g"), right) << kind;
        const bool regular = fs::is_regular_file(fs::symlink_status(entry));
        EXPECT_TRUE(regular) << kind;
        if (regular) {
            EXPECT_EQ(bytes_of(entry), stored) << kind;
        }
        fs::remove(entry);
    };
    fs::remove(entry);
    ASSERT_EQ(mkfifo(entry.c_str(), 0600), 0);
    is_made_again("a pipe");
    fs::create_symlink("/dev/zero", entry);
    is_made_again("a link to a device");
    fs::create_symlink(entry.filename(), entry);
    is_made_again("a link to itself");
    std::ofstream(entry) << "wrinkle cache 2\n";
    fs::resize_file(entry, uint64_t{1} << 40);
    is_made_again("a file of a terabyte");
    fs::create_directories(entry);
    const Ran ran = compile({});
    EXPECT_EQ(ran.code, 0);
    EXPECT_EQ(get("out/g"), right);
    EXPECT_TRUE(says(ran.err, "warning: the cache cannot be written: cache/")) << ran.err;
    EXPECT_TRUE(says(ran.err, entry.filename().string() + ": Is a directory")) << ran.err;
}

TEST_F(CacheTest, FilesThatAreNotEntriesAreLeftAlone) {
    put("g.json", tilt_graph());
    ASSERT_EQ(compile({}).code, 0);
    const fs::path entry = entries().at(0);
    fs::remove(entry);
    const fs::path texts[] = {entry.parent_path() / "thesis.txt",
                              entry.parent_path() / "notes.tmp.txt"};
    for (const fs::path& text : texts) {
        std::ofstream(text) << std::string(4000, 'x');
        fs::last_write_time(text, fs::file_time_type::clock::now() - std::chrono::hours(9));
    }
    ASSERT_EQ(compile({"--cache-size", "0"}).code, 0);
    for (const fs::path& text : texts)
        EXPECT_TRUE(fs::exists(text)) << text;
    EXPECT_FALSE(fs::exists(entry));
}

TEST_F(CacheTest, WarningsComeFromTheEntryToo) {
    put("g.json", R"({"wrinkle": 1, "nodes": {
      "cells": {"type": "worley_noise", "in": {"jitter": 2}}},
      "outputs": {"height": {"from": "cells.height"}}})");
    const Ran miss = compile({});
    const Ran hit = compile({});
    EXPECT_EQ(miss.code, 0);
    EXPECT_TRUE(says(miss.err, "g.json:2:")) << miss.err;
    EXPECT_EQ(hit.err, miss.err);
    fs::create_directories(folder / "moved");
    fs::rename(folder / "g.json", folder / "moved/g.json");
    EXPECT_TRUE(says(compile({}, "moved/g.json").err, "moved/g.json:2:"));
    EXPECT_EQ(entries().size(), 1u);
}

TEST_F(CacheTest, WhatATextDependsOnIsInTheKey) {
    put("inner.json", tilt_graph("0.5"));
    put("g.json", R"({"wrinkle": 1, "nodes": {"sub": {"type": "graph:inner.json"}},
        "outputs": {"normal": {"from": "sub.normal"}}})");
    ASSERT_EQ(compile({}).code, 0);
    const std::string before = get("out/g");
    put("inner.json", tilt_graph("0.25"));
    ASSERT_EQ(compile({}).code, 0);
    EXPECT_NE(get("out/g"), before);
    EXPECT_EQ(entries().size(), 2u);
    put("inner.json", tilt_graph("0.5"));
    ASSERT_EQ(compile({}).code, 0);
    EXPECT_EQ(get("out/g"), before);
    EXPECT_EQ(entries().size(), 2u);
}

TEST_F(CacheTest, ImagesCountByWhetherTheyAreThere) {
    put("a.png", "x");
    put("b.png", "x");
    put("g.json", R"({"wrinkle": 1, "nodes": {
        "one": {"type": "image", "in": {"image": "a.png"}},
        "two": {"type": "image", "in": {"image": "b.png"}},
        "sum": {"type": "vec3_add", "in": {"a": {"from": "one.color"}, "b": {"from": "two.color"}}}},
        "outputs": {"color": {"from": "sum.vector"}}})");
    ASSERT_EQ(compile({}).code, 0) << compile({}).err;
    const std::string two_samplers = get("out/g");
    put("a.png", "other pixels");
    ASSERT_EQ(compile({}).code, 0);
    EXPECT_EQ(entries().size(), 1u);
    fs::remove(folder / "b.png");
    EXPECT_EQ(compile({}).code, 1);
    fs::create_symlink("a.png", folder / "b.png");
    ASSERT_EQ(compile({}).code, 0);
    EXPECT_NE(get("out/g"), two_samplers) << "both names mean one file now";
}

TEST_F(CacheTest, PluginsCountByTheirBytes) {
    fs::copy_file(WRINKLE_RIPPLES, folder / "p.so");
    put("g.json", R"({"wrinkle": 1, "nodes": {"r": {"type": "ripples"}},
        "outputs": {"height": {"from": "r.height"}}})");
    ASSERT_EQ(compile({"--plugin-path", "p.so"}).code, 0);
    ASSERT_EQ(compile({"--plugin-path", "p.so"}).code, 0);
    EXPECT_EQ(entries().size(), 1u);
    std::ofstream(folder / "p.so", std::ios::app | std::ios::binary) << "another build";
    ASSERT_EQ(compile({"--plugin-path", "p.so"}).code, 0);
    EXPECT_EQ(entries().size(), 2u);
}

TEST_F(CacheTest, ADamagedEntryIsMadeAnew) {
    put("g.json", tilt_graph());
    ASSERT_EQ(compile({}).code, 0);
    const std::string right = get("out/g"), entry = bytes_of(entries().at(0));
    const auto put_right = [&](const std::string& what) {
        const Ran ran = compile({});
        EXPECT_EQ(ran.code, 0) << what;
        EXPECT_EQ(ran.err, "") << what;
        EXPECT_EQ(get("out/g"), right) << what;
        EXPECT_EQ(bytes_of(entries().at(0)), entry) << what;
    };
    for (const size_t from_end : {size_t{1}, size_t{40}, entry.size() - 20, entry.size()}) {
        damage(from_end);
        put_right("damaged " + std::to_string(from_end) + " before its end");
    }
    for (const size_t left : {size_t{0}, size_t{7}, size_t{81}, entry.size() - 1}) {
        fs::resize_file(entries().at(0), left);
        put_right("cut to " + std::to_string(left));
    }
}

TEST_F(CacheTest, AFolderThatCannotBeWrittenIsAWarning) {
    put("g.json", tilt_graph());
    put("cache", "a file");
    const Ran ran = compile({});
    EXPECT_EQ(ran.code, 0);
    EXPECT_TRUE(says(ran.err, "warning: the cache cannot be written: cache/"));
    EXPECT_TRUE(exists("out/g"));
}

TEST_F(CacheTest, WhatWasNotUsedForLongGoesFirst) {
    put("g.json", tilt_graph());
    ASSERT_EQ(compile({}).code, 0);
    const fs::path entry = entries().at(0);
    const auto now = fs::file_time_type::clock::now();
    const fs::path old = entry.parent_path() / std::string(64, 'd'),
                   used = entry.parent_path() / std::string(64, 'e'),
                   killed = entry.parent_path() / ".wrinkle-tmp-1-0",
                   at_work = entry.parent_path() / ".wrinkle-tmp-1-1";
    for (const fs::path& path : {old, used}) {
        std::ofstream(path) << std::string(4000, 'x');
        fs::last_write_time(path, now - std::chrono::hours(path == old ? 3 : 2));
    }
    std::ofstream(killed) << "killed";
    std::ofstream(at_work) << "at work";
    const int lock = open(at_work.c_str(), O_RDONLY);  // as its writer holds it
    ASSERT_EQ(flock(lock, LOCK_EX), 0);
    fs::remove(entry);
    ASSERT_EQ(compile({"--cache-size", std::to_string(16 * 7000)}).code, 0);
    close(lock);
    EXPECT_EQ(entries().size(), 3u);
    EXPECT_TRUE(fs::exists(at_work));
    EXPECT_FALSE(fs::exists(killed));
    EXPECT_FALSE(fs::exists(old));
    EXPECT_TRUE(fs::exists(used));
    EXPECT_TRUE(fs::exists(entry));
}

// Eight processes at a time write the same entries; half of them are killed meanwhile.
TEST_F(CacheTest, ParallelAndKilledWritersLeaveOnlyWholeEntries) {
    Names args{"compile", "--cache", "cache", "-j2", "-o"};
    for (int i = 0; i < 12; ++i)
        args.push_back(
            put("g" + std::to_string(i) + ".json", tilt_graph("0." + std::to_string(i + 1)))
                .string());
    Names plain = args;
    plain.erase(plain.begin() + 1, plain.begin() + 3);
    plain.insert(plain.begin() + 3, "plain");
    ASSERT_EQ(run(plain).code, 0);
    for (int round = 0; round < 6; ++round) {
        std::vector<pid_t> children;
        for (int i = 0; i < 8; ++i) {
            Names call = args;
            call.insert(call.begin() + 5, (folder / ("o" + std::to_string(i))).string());
            children.push_back(start(call));
        }
        usleep(static_cast<useconds_t>(1000 * (3 + 3 * round)));
        for (size_t i = 0; i < children.size(); i += 2)
            kill(children[i], SIGKILL);
        for (const pid_t child : children)
            waitpid(child, nullptr, 0);
        for (const auto& each : fs::recursive_directory_iterator(folder)) {
            const std::string file = each.path().filename().string();
            // A killed process leaves a hidden temporary file, which the next process removes.
            if (!file.starts_with('g') || !file.ends_with(".glsl")) continue;
            EXPECT_EQ(bytes_of(each.path()), get("plain/" + file));
        }
    }
    args.insert(args.begin() + 5, "last");
    ASSERT_EQ(run(args).code, 0);
    for (int i = 0; i < 12; ++i) {
        const std::string name = "/g" + std::to_string(i) + ".glsl";
        EXPECT_EQ(get("last" + name), get("plain" + name));
    }
}

}  // namespace
}  // namespace wrinkle::test
