#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>

#include "base/file.h"
#include "registry/loaded.h"
#include "registry/plugin_code.h"
#include "support/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;
using test::load;
using test::Loaded;
const std::string& folder = test::plugin_folder;

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
    EXPECT_EQ(to_text(loaded.reports), folder + "/good.so\n    good 1.2\n    found: small\n");
}

TEST(PluginLoader, SaysWhyItRefuses) {
    EXPECT_EQ(refusal(folder + "/no_symbol.so"),
              "it is not a plugin of Wrinkle: it does not export wrinkle_plugin (end it with "
              "WRINKLE_PLUGIN(\"id\", \"version\", nodes...), in C with WR_EXPORT const wr_plugin* "
              "wrinkle_plugin(void))");
    EXPECT_EQ(refusal(folder + "/null_result.so"), "its wrinkle_plugin() returned null");
    EXPECT_EQ(refusal(folder + "/wrong_abi.so"),
              "it is made for plugin interface 77 (this program has interface 1)");
    EXPECT_EQ(refusal(folder + "/nowhere.so"), "there is no such plugin or folder");
    const test::TemporaryFolder temporary;
    EXPECT_EQ(refusal(temporary.put("text.so", "no shared object")),
              "it cannot be loaded: it is not a shared object");
}

TEST(PluginLoader, TriesAFolderByNameAndGoesOn) {
    const test::TemporaryFolder temporary;
    const std::string here = temporary.path().string();
    for (const char* name :
         {"duplicate", "good", "no_symbol", "null_result", "second", "wrong_abi"})
        fs::copy_file(folder + "/" + name + ".so", here + "/" + name + ".so");
    const Loaded loaded = load({here});
    std::vector<std::string> names;
    for (const PluginReport& report : loaded.reports)
        names.push_back(fs::path(report.path).stem().string() +
                        (report.state == PluginReport::State::found ? " found" : " refused"));
    EXPECT_EQ(names, (std::vector<std::string>{"duplicate found", "good refused",
                                               "no_symbol refused", "null_result refused",
                                               "second found", "wrong_abi refused"}));
    EXPECT_FALSE(loaded.diagnostics.has_errors()) << "found in a folder: warnings";
    EXPECT_EQ(loaded.diagnostics.list().size(), 4u);
    EXPECT_EQ(loaded.reports[1].why, "node 'small': this id is taken: " + here +
                                         "/duplicate.so has a node of the same id (give one of "
                                         "them another id)");
    EXPECT_EQ(loaded.reports[1].nodes, std::vector<std::string>{"small"});
}

TEST(PluginLoader, OfTwoPluginsOfOneIdTheFirstIsTaken) {
    const std::string first = folder + "/same_id.so", second = folder + "/good.so";
    const Loaded loaded = load({first, second});
    EXPECT_EQ(loaded.registry.ids(), std::vector<std::string>{"other"});
    EXPECT_EQ(to_text(loaded.diagnostics), second + ": error: the plugin id 'good' is taken: " +
                                               first + " has it (remove one of them)\n");
    EXPECT_EQ(load({second, first}).registry.ids(), std::vector<std::string>{"small"});
}

TEST(PluginLoader, ABuiltInNodeKeepsItsId) {
    Loaded loaded;
    NodeType type;
    type.id = "small";
    type.origin = Registry::built_in;
    ASSERT_TRUE(loaded.registry.add({type}, Registry::built_in, loaded.diagnostics));
    const std::vector<std::string> places{folder + "/good.so"};
    load_plugins(loaded.registry, places, loaded.diagnostics);
    EXPECT_EQ(to_text(loaded.diagnostics),
              places[0] +
                  ": error: node 'small': this id is taken: built-in has a node of the "
                  "same id (give one of them another id)\n");
}

TEST(PluginLoader, LoadsAFileOnceAndEarlierPlacesWin) {
    const std::string good = folder + "/good.so", again = folder + "/../plugins/good.so";
    const Loaded loaded = load({good, again, folder + "/duplicate.so"});
    EXPECT_EQ(loaded.registry.find("small")->origin, good);
    EXPECT_EQ(loaded.registry.list().size(), 1u);
    EXPECT_EQ(loaded.reports.size(), 2u);
}

// Two versions of one file, one after the other, as when a plugin is rebuilt.
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

// If a rebuild is broken, the last good version is retained; a plugin without a good version is
// refused.
TEST(PluginLoader, KeepsTheLastGoodVersionOfABrokenOne) {
    const test::TemporaryFolder temporary;
    const fs::path file = temporary.path() / "mine.so";
    fs::copy_file(folder + "/good.so", file);
    const Loaded before = load({file.string()}, {.copies = true});
    ASSERT_EQ(before.reports[0].state, PluginReport::State::found);
    for (const char* broken : {"no_symbol", "wrong_abi", "missing_symbol"}) {
        fs::copy_file(folder + "/" + broken + ".so", file, fs::copy_options::overwrite_existing);
        PluginOptions options{.copies = true};
        options.former = &before.registry;
        const Loaded after = load({file.string(), folder + "/second.so"}, options);
        EXPECT_EQ(after.registry.ids(), (std::vector<std::string>{"small", "smaller"})) << broken;
        Unbuilt reason;
        const std::vector<int32_t> numbers(2);
        const auto calls = before.registry.find("small")->code->calls(0, numbers, reason);
        EXPECT_NE(calls, nullptr) << reason.why;
        EXPECT_EQ(after.registry.find("small")->code->calls(0, numbers, reason), calls);
        EXPECT_TRUE(after.reports[0].why.ends_with("; its nodes loaded before remain"))
            << after.reports[0].why;
        EXPECT_TRUE(load({file.string()}, {.copies = true}).registry.list().empty());
    }
    fs::remove(file);
    PluginOptions options{.copies = true};
    options.former = &before.registry;
    EXPECT_TRUE(load({temporary.path().string()}, options).registry.list().empty()) << "it is gone";
}

TEST(PluginLoader, PlacesComeFromOptionsThenEnvironment) {
    const std::vector<std::string> options = {"b", "a"};
    EXPECT_EQ(plugin_places(options, "/x::/y"), (std::vector<std::string>{"b", "a", "/x", "/y"}));
    EXPECT_EQ(plugin_places({}, nullptr), std::vector<std::string>{});
}

class DefaultPlaces : public testing::Test {
protected:
    void SetUp() override {
        for (const char* name : names)
            if (const char* value = getenv(name)) former[name] = value;
        for (const char* name : names)
            unsetenv(name);
    }
    void TearDown() override {
        for (const char* name : names)
            former.contains(name) ? setenv(name, former[name].c_str(), 1) : unsetenv(name);
    }

    static constexpr const char* names[] = {"HOME", "XDG_DATA_HOME", "WRINKLE_PLUGIN_PATH",
                                            "WRINKLE_NO_DEFAULT_PLUGINS"};
    std::map<std::string, std::string> former;
    const test::TemporaryFolder temporary;
};

TEST_F(DefaultPlaces, AreTheUsersThenTheSystemsWhereTheyAreThere) {
    const fs::path system = fs::path(WRINKLE_BINARY_DIR) / "lib/wrinkle/plugins";
    std::vector<std::string> of_the_system;
    if (fs::exists(system)) of_the_system.push_back(system.string());
    EXPECT_EQ(default_plugin_folders(), of_the_system);
    setenv("HOME", temporary.path().c_str(), 1);
    EXPECT_EQ(default_plugin_folders(), of_the_system) << "it is not there";
    fs::create_directories(temporary.path() / ".local/share/wrinkle/plugins");
    fs::create_directories(temporary.path() / "data/wrinkle/plugins");
    std::vector<std::string> expected = of_the_system;
    expected.insert(expected.begin(), temporary.path() / ".local/share/wrinkle/plugins");
    EXPECT_EQ(default_plugin_folders(), expected);
    setenv("XDG_DATA_HOME", (temporary.path() / "data").c_str(), 1);
    expected[0] = temporary.path() / "data/wrinkle/plugins";
    EXPECT_EQ(default_plugin_folders(), expected);
    setenv("WRINKLE_PLUGIN_PATH", "/x:/y", 1);
    expected.insert(expected.begin(), {"option", "/x", "/y"});
    EXPECT_EQ(plugin_places(std::vector<std::string>{"option"}), expected);
    setenv("WRINKLE_NO_DEFAULT_PLUGINS", "1", 1);
    EXPECT_EQ(plugin_places({}), (std::vector<std::string>{"/x", "/y"}));
    setenv("WRINKLE_NO_DEFAULT_PLUGINS", "", 1);
    EXPECT_EQ(plugin_places(std::vector<std::string>{"option"}), expected);
}

}  // namespace
}  // namespace wrinkle
