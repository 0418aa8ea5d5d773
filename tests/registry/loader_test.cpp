#include <gtest/gtest.h>

#include <filesystem>

#include "base/file.h"
#include "registry/plugin_loader.h"
#include "support/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;
const std::string folder = TEST_PLUGINS;

struct Loaded {
    Registry registry;
    Diagnostics diagnostics;
    std::vector<PluginReport> reports;
};

Loaded load(const std::vector<std::string>& places) {
    Loaded loaded;
    loaded.reports = load_plugins(loaded.registry, places, loaded.diagnostics);
    return loaded;
}

std::string refusal(const std::string& path) {
    const Loaded loaded = load({path});
    EXPECT_TRUE(loaded.registry.list().empty());
    EXPECT_EQ(loaded.reports.size(), 1u);
    EXPECT_EQ(loaded.reports[0].state, PluginReport::State::refused);
    EXPECT_TRUE(loaded.diagnostics.has_errors()) << "the file was named";
    return loaded.reports[0].why;
}

TEST(PluginLoader, LoadsOne) {
    const Loaded loaded = load({folder + "/good.so"});
    EXPECT_EQ(to_text(loaded.diagnostics), "");
    ASSERT_NE(loaded.registry.find("small"), nullptr);
    EXPECT_EQ(loaded.registry.find("small")->origin, folder + "/good.so");
    EXPECT_EQ(to_text(loaded.reports), folder + "/good.so\n    good 1.2\n    loaded: small\n");
}

TEST(PluginLoader, SaysWhyItRefuses) {
    EXPECT_EQ(refusal(folder + "/no_symbol.so"),
              "it is no plugin of Wrinkle: it does not export wrinkle_plugin (declare it extern "
              "\"C\" with WR_EXPORT)");
    EXPECT_EQ(refusal(folder + "/null_result.so"), "its wrinkle_plugin() returned null");
    EXPECT_EQ(refusal(folder + "/wrong_abi.so"),
              "it is made for plugin interface 77 (this program has interface 1)");
    EXPECT_EQ(refusal(folder + "/nowhere.so"), "there is no such plugin or folder");
    const test::TemporaryFolder temporary;
    EXPECT_EQ(refusal(temporary.put("text.so", "no shared object")).substr(0, 25),
              "it cannot be loaded: file");
}

TEST(PluginLoader, TriesAFolderByNameAndGoesOn) {
    const Loaded loaded = load({folder});
    std::vector<std::string> names;
    for (const PluginReport& report : loaded.reports)
        names.push_back(fs::path(report.path).stem().string() +
                        (report.state == PluginReport::State::loaded ? " loaded" : " refused"));
    EXPECT_EQ(names, (std::vector<std::string>{"duplicate loaded", "good refused",
                                               "no_symbol refused", "null_result refused",
                                               "second loaded", "wrong_abi refused"}));
    EXPECT_FALSE(loaded.diagnostics.has_errors()) << "found in a folder: warnings";
    EXPECT_EQ(loaded.diagnostics.list().size(), 4u);
    EXPECT_EQ(loaded.reports[1].why, "node 'small': this id is taken: " + folder +
                                         "/duplicate.so has a node of the same id (give one of "
                                         "them another id)");
    EXPECT_EQ(loaded.reports[1].nodes, std::vector<std::string>{"small"});
}

TEST(PluginLoader, LoadsAFileOnceAndEarlierPlacesWin) {
    const Loaded loaded = load({folder + "/good.so", folder + "/../plugins/good.so", folder});
    EXPECT_EQ(loaded.registry.find("small")->origin, folder + "/good.so");
    EXPECT_EQ(loaded.registry.list().size(), 2u);
    EXPECT_EQ(loaded.reports.size(), 6u);
}

// Two files of one name, one after the other, as when a plugin is built anew.
TEST(PluginLoader, LoadsCopiesThatMayBeReplaced) {
    const test::TemporaryFolder temporary;
    const fs::path file = temporary.path() / "mine.so";
    const auto nodes_of = [&](const std::string& from) {
        fs::copy_file(folder + "/" + from, file, fs::copy_options::overwrite_existing);
        Registry registry;
        Diagnostics diagnostics;
        const std::vector<std::string> places{file.string()};
        load_plugins(registry, places, diagnostics, {.copies = true});
        EXPECT_EQ(to_text(diagnostics), "");
        return registry.ids();
    };
    EXPECT_EQ(nodes_of("good.so"), std::vector<std::string>{"small"});
    EXPECT_EQ(nodes_of("second.so"), std::vector<std::string>{"smaller"});
    EXPECT_EQ(nodes_of("good.so"), std::vector<std::string>{"small"});
}

TEST(PluginLoader, RefusesAFileThatIsCutShort) {
    std::string why;
    const std::string whole = read_file(folder + "/good.so", why).value();
    const test::TemporaryFolder temporary;
    for (size_t size = 0; size < whole.size(); size += whole.size() / 64 + 1)
        EXPECT_EQ(refusal(temporary.put("cut.so", whole.substr(0, size))).substr(0, 19),
                  "it cannot be loaded")
            << size;
}

TEST(PluginLoader, PlacesComeFromOptionsThenEnvironment) {
    const std::vector<std::string> options = {"b", "a"};
    EXPECT_EQ(plugin_places(options, "/x::/y"), (std::vector<std::string>{"b", "a", "/x", "/y"}));
    EXPECT_EQ(plugin_places({}, nullptr), std::vector<std::string>{});
}

}  // namespace
}  // namespace wrinkle
