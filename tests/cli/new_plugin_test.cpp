// Tests of wrinkle new-plugin: written files, and errors that write nothing. The guide's test
// (tests/guide) builds such a folder against an installation and runs its test.
#include <algorithm>
#include <cstdlib>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

using NewPluginTest = CliTest;
using Names = std::vector<std::string>;

TEST_F(NewPluginTest, WritesAFolder) {
    const Ran ran = run({"new-plugin", "round_studs"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(ran.out.starts_with("round_studs\n"));
    EXPECT_EQ(files(), (Names{"round_studs", "round_studs/CMakeLists.txt", "round_studs/README.md",
                              "round_studs/round_studs.cpp", "round_studs/round_studs.json",
                              "round_studs/round_studs.test.json"}));
    const std::string source = get("round_studs/round_studs.cpp");
    EXPECT_TRUE(says(source, "node(\"round_studs\", \"Round studs\""));
    for (const char* file : {"CMakeLists.txt", "README.md", "round_studs.cpp", "round_studs.json"})
        EXPECT_EQ(get("round_studs/" + std::string(file)).find('@'), std::string::npos) << file;
    EXPECT_EQ(run({"format", "--check", "round_studs/round_studs.json"}).code, 0);
}

TEST_F(NewPluginTest, TheFolderMayHaveAnyNameAndBeThereEmpty) {
    fs::create_directories(folder / "empty");
    EXPECT_EQ(run({"new-plugin", "studs", "--folder", "empty"}).code, 0);
    EXPECT_TRUE(exists("empty/studs.cpp"));
    EXPECT_EQ(run({"new-plugin", "studs", "--folder", "deep/in/a folder"}).code, 0);
    EXPECT_TRUE(exists("deep/in/a folder/studs.cpp"));
    EXPECT_FALSE(exists("studs"));
}

TEST_F(NewPluginTest, ANameMustBeFree) {
    const std::vector<std::pair<std::string, std::string>> refused = {
        {"Studs", "'Studs' is not a name for a node: a letter a-z, then letters, digits and _"},
        {"my studs", "is not a name for a node"},
        {"9studs", "is not a name for a node"},
        {"../studs", "is not a name for a node"},
        {"", "is not a name for a node"},
        {std::string(65, 'a'), "at most 64"},
        {"double", "'double' is a word of C++ or CMake"},
        {"test", "'test' is a word of C++ or CMake"},
        {"gradient_noise", "'gradient_noise' is a built-in node"},
        {"reroute", "'reroute' is a built-in node"}};
    for (const auto& [name, why] : refused) {
        const Ran ran = run({"new-plugin", name});
        EXPECT_EQ(ran.code, 2) << name;
        EXPECT_TRUE(says(ran.err, why)) << name;
        EXPECT_EQ(files(), Names{}) << name;
    }
}

TEST_F(NewPluginTest, AnotherFolderIsLeftAsItIs) {
    put("studs/notes.txt", "mine");
    const Ran full = run({"new-plugin", "studs"});
    EXPECT_EQ(full.code, 3);
    EXPECT_TRUE(says(full.err, "studs: the folder is not empty; --folder names another one"));
    const Ran file = run({"new-plugin", "studs", "--folder", "studs/notes.txt"});
    EXPECT_EQ(file.code, 3);
    EXPECT_TRUE(says(file.err, "studs/notes.txt: is not a folder"));
    EXPECT_EQ(files(), (Names{"studs", "studs/notes.txt"}));
    EXPECT_EQ(get("studs/notes.txt"), "mine");
}

TEST_F(NewPluginTest, NothingIsLeftWhenItCannotBeWritten) {
    put("file", "no folder");
    const Ran ran = run({"new-plugin", "studs", "--folder", "file/a/b"});
    EXPECT_EQ(ran.code, 3);
    EXPECT_TRUE(says(ran.err, "file/a/b: Not a directory"));
    EXPECT_EQ(files(), Names{"file"});
}

// The folder can be created, but the paths of its files would be too long.
TEST_F(NewPluginTest, FoldersOnTheWayAreTakenBack) {
    std::string deep = folder.string();
    while (deep.size() < 4088)
        deep += "/" + std::string(std::min<size_t>(200, 4088 - deep.size() - 1), 'd');
    const Ran ran = run({"new-plugin", "studs", "--folder", deep});
    EXPECT_EQ(ran.code, 3);
    EXPECT_TRUE(says(ran.err, "File name too long"));
    EXPECT_EQ(files(), Names{});
}

// Uses the package in the build folder; the guide's test uses an installation.
TEST_F(NewPluginTest, FindsTheSdkBesideTheProgram) {
    ASSERT_EQ(run({"new-plugin", "studs"}).code, 0);
    EXPECT_TRUE(says(get("studs/CMakeLists.txt"), "[==[" WRINKLE_BINARY_DIR "]==]"));
    const std::string work = (folder / "studs").string();
    EXPECT_EQ(std::system(("env -u CMAKE_PREFIX_PATH cmake -G Ninja -S " + work + " -B " + work +
                           "/build > " + work + "/log 2>&1")
                              .c_str()),
              0)
        << get("studs/log");
}

}  // namespace
}  // namespace wrinkle::test
