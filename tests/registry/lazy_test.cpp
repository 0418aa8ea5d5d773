// Tests that a plugin's nodes and their recordings are available without loading its code into this
// process: from its manifest, from the cache, or from a probe process.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/checksum.h"
#include "base/text.h"
#include "registry/describe.h"
#include "registry/loaded.h"
#include "registry/plugin_code.h"
#include "support/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using test::load;
using test::Loaded;
using test::plugin_folder;

class Lazy : public testing::Test {
protected:
    void SetUp() override { setenv("WRINKLE_TEST_MARK", mark.c_str(), 1); }
    void TearDown() override { unsetenv("WRINKLE_TEST_MARK"); }

    // Counts the loads of the code of marks.so since the last call: by other processes, by this
    // one.
    std::pair<size_t, size_t> runs() const {
        if (!fs::exists(mark)) return {0, 0};
        const std::string text = bytes_of(mark);
        fs::remove(mark);
        std::pair<size_t, size_t> count{0, 0};
        for (const std::string_view line : split(text, '\n'))
            if (!line.empty()) ++(line == std::to_string(getpid()) ? count.second : count.first);
        return count;
    }

    fs::path place(const std::string& from, const std::string& name) const {
        const fs::path file = folder.path() / "plugins" / name;
        fs::create_directories(file.parent_path());
        fs::copy_file(plugin_folder + "/" + from, file, fs::copy_options::overwrite_existing);
        return file;
    }

    fs::path manifest(const fs::path& file) const {
        Diagnostics diagnostics;
        const auto listing = read_from_code(file.string(), diagnostics);
        EXPECT_EQ(to_text(diagnostics), "");
        const fs::path json = manifest_of(file.string());
        std::ofstream(json) << (listing ? to_json(*listing) : "");
        runs();
        return json;
    }

    Loaded list(const fs::path& file) const {
        PluginOptions options;
        options.cache = folder.path() / "cache";
        return load({file.string()}, options);
    }

    static std::string why_not(const Loaded& loaded, const char* node) {
        Unbuilt reason;
        const NodeType* type = loaded.registry.find(node);
        if (!type) return "no such node";
        const std::vector<int32_t> options(type->ports.size());
        const bool built = type->code->calls(type->code_index, options, reason) != nullptr;
        EXPECT_EQ(built, reason.why.empty());
        return reason.why;
    }

    const test::TemporaryFolder folder;
    const fs::path mark = folder.path() / "mark";
};

using Runs = std::pair<size_t, size_t>;

TEST_F(Lazy, AProbeReadsOnceAndANodeIsBuiltOnceByAnother) {
    const fs::path file = place("marks.so", "marks.so");
    const Loaded first = list(file);
    EXPECT_EQ(runs(), Runs(1, 0));
    const Loaded second = list(file);
    EXPECT_EQ(runs(), Runs(0, 0)) << "it is in the cache";
    EXPECT_EQ(to_text(second.reports), to_text(first.reports));
    EXPECT_EQ(second.reports[0].state, PluginReport::State::found);
    EXPECT_EQ(why_not(second, "marked"), "");
    EXPECT_EQ(why_not(second, "marked"), "");
    EXPECT_EQ(runs(), Runs(1, 0));
}

TEST_F(Lazy, AManifestListsWithoutAnyCodeRun) {
    const fs::path file = place("marks.so", "with.so");
    const std::string text = bytes_of(manifest(file));
    EXPECT_NE(text.find("\"sha256\": \"" + sha256(bytes_of(file)) + "\""), text.npos);
    const Loaded loaded = list(file);
    EXPECT_EQ(to_text(loaded.diagnostics), "");
    EXPECT_EQ(to_text(loaded.reports),
              file.string() + "\n    marks 1.2\n    found by its manifest: marked\n");
    EXPECT_EQ(runs(), Runs(0, 0));
    EXPECT_EQ(why_not(loaded, "marked"), "");
    EXPECT_EQ(runs(), Runs(2, 0)) << "no probe had tried it";
}

TEST_F(Lazy, AManifestOfAnotherBuildIsIgnoredWithAWarning) {
    const fs::path file = place("marks.so", "stale.so");
    const fs::path json = manifest(file);
    place("second.so", "stale.so");
    const Loaded loaded = list(file);
    EXPECT_EQ(loaded.registry.ids(), std::vector<std::string>{"smaller"});
    EXPECT_EQ(to_text(loaded.diagnostics),
              json.string() +
                  ": warning: the manifest is ignored: the plugin was built again since "
                  "(`wrinkle plugins --manifest` writes it again)\n");
}

TEST_F(Lazy, ADamagedManifestIsIgnoredWithAWarning) {
    const fs::path file = place("marks.so", "damaged.so");
    const fs::path json = manifest(file);
    const std::string whole = bytes_of(json);
    for (size_t at = 0; at + 3 < whole.size(); at += 3) {
        std::string text = whole;
        text[at] = at % 2 ? '\xFF' : '}';
        if (at % 5 == 0) text.resize(at);
        std::ofstream(json, std::ios::binary) << text;
        const Loaded loaded = list(file);
        EXPECT_EQ(loaded.registry.list().size(), 1u) << text;
        EXPECT_FALSE(loaded.diagnostics.has_errors()) << to_text(loaded.diagnostics);
        EXPECT_TRUE(loaded.reports[0].by_manifest || !loaded.diagnostics.list().empty()) << text;
    }
    std::ofstream(json) << R"({"wrinkle_plugin": 2})";
    EXPECT_EQ(to_text(list(file).diagnostics),
              json.string() +
                  ":1:1: warning: the manifest is ignored: this is not a description of a "
                  "plugin that this program knows (`wrinkle plugins --manifest` writes "
                  "it again)\n");
}

// The checksum matches, but the nodes do not.
TEST_F(Lazy, AManifestThatLiesIsFoundOutBeforeItsCodeIsUsed) {
    const fs::path file = place("marks.so", "liar.so");
    const fs::path json = manifest(file);
    std::string text = bytes_of(json);
    text.replace(text.find("Passes a float."), 15, "Breaks a float.");
    std::ofstream(json) << text;
    const Loaded loaded = list(file);
    ASSERT_TRUE(loaded.reports[0].by_manifest);
    EXPECT_EQ(why_not(loaded, "marked"),
              "its nodes are not those that its manifest lists; `wrinkle plugins --manifest` "
              "writes it again");
}

TEST_F(Lazy, CodeThatCrashesBehindAManifestIsNamed) {
    const fs::path good = place("broken.so", "good.so");
    const std::string text = bytes_of(manifest(good));
    const fs::path file = place("broken.so", "segv_while_loading.so");
    std::ofstream(file.string() + ".json") << text;
    const Loaded loaded = list(file);
    ASSERT_TRUE(loaded.reports[0].by_manifest);
    EXPECT_EQ(why_not(loaded, "broken"),
              "it crashed while it was loaded: SIGSEGV (Segmentation fault)");
}

TEST_F(Lazy, AFileThatChangedSinceIsNotLoaded) {
    const fs::path file = place("good.so", "changing.so");
    const Loaded loaded = list(file);
    place("second.so", "changing.so");
    EXPECT_EQ(why_not(loaded, "small"), "its file was changed since its nodes were listed");
    const Loaded gone = list(file);
    fs::remove(file);
    EXPECT_EQ(why_not(gone, "smaller"), "it cannot be read: No such file or directory");
}

TEST_F(Lazy, ADamagedEntryOfTheCacheIsMadeAnew) {
    const fs::path file = place("marks.so", "cached.so");
    list(file);
    const fs::path entry = folder.path() / "cache" / (sha256(bytes_of(file)) + ".json");
    const std::string whole = bytes_of(entry);
    runs();
    std::string other = whole;
    other.replace(other.find("\"sha256\": \"") + 11, 4, "0000");
    for (const std::string& text : {whole.substr(0, whole.size() / 2), std::string(), other}) {
        std::ofstream(entry, std::ios::binary) << text;
        EXPECT_EQ(to_text(list(file).diagnostics), "");
        EXPECT_EQ(runs(), Runs(1, 0));
        EXPECT_EQ(bytes_of(entry), whole);
    }
}

TEST_F(Lazy, WhereNothingCanBeCachedAProbeIsMadeEachTime) {
    const fs::path file = place("marks.so", "uncached.so");
    folder.put("cache", "a file where the folder would be");
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(to_text(list(file).diagnostics), "");
        EXPECT_EQ(runs(), Runs(1, 0));
    }
}

// Two sets of options give two probe processes; only a check for state builds twice in one process.
TEST_F(Lazy, ANodeIsBuiltOnceForEachSetOfOptions) {
    const fs::path file = place("marks.so", "options.so");
    const Loaded loaded = list(file);
    runs();
    PluginCode& code = *loaded.registry.find("marked")->code;
    Unbuilt reason;
    const std::vector<int32_t> one{0, 0}, other{1, 0};
    const auto calls = code.calls(0, one, reason);
    ASSERT_NE(calls, nullptr) << reason.why;
    EXPECT_EQ(code.calls(0, one, reason), calls);
    EXPECT_EQ(runs(), Runs(1, 0));
    EXPECT_NE(code.calls(0, other, reason), calls);
    EXPECT_EQ(runs(), Runs(1, 0));
    code.toggle_second_run();
    const auto again = code.calls(0, one, reason);
    EXPECT_NE(again, calls);
    EXPECT_EQ(*again, *calls);
    EXPECT_EQ(runs(), Runs(1, 0));
}

// As if SIGCHLD is ignored: the system discards the exit status of children.
TEST_F(Lazy, AHostThatIgnoresTheEndsOfItsChildrenHasPluginsAllTheSame) {
    const auto former = signal(SIGCHLD, SIG_IGN);
    const Loaded good = list(place("marks.so", "unwaited.so"));
    EXPECT_EQ(why_not(good, "marked"), "");
    const Loaded bad = list(place("broken.so", "segv_while_loading.so"));
    signal(SIGCHLD, former);
    EXPECT_EQ(to_text(good.diagnostics), "");
    EXPECT_TRUE(bad.registry.list().empty());
    EXPECT_TRUE(bad.diagnostics.has_errors());
}

// The plugin's child process holds the pipe open and never exits.
TEST_F(Lazy, WhatAPluginStartsEndsWithItsProbe) {
    const Loaded loaded = list(place("broken.so", "forks.so"));
    EXPECT_EQ(to_text(loaded.diagnostics), "");
    EXPECT_EQ(loaded.registry.ids(), std::vector<std::string>{"broken"});
}

TEST_F(Lazy, WhatLeavesItsGroupIsNotWaitedFor) {
    const Loaded loaded = list(place("broken.so", "escapes.so"));
    EXPECT_EQ(loaded.registry.ids(), std::vector<std::string>{"broken"});
    std::string number;
    for (int i = 0; i < 1000 && number.empty(); ++i) {
        usleep(10'000);
        if (fs::exists(mark)) number = bytes_of(mark);
    }
    ASSERT_NE(number, "");
    EXPECT_EQ(kill(std::stoi(number), SIGKILL), 0) << "it was waited for";
}

}  // namespace
}  // namespace wrinkle
