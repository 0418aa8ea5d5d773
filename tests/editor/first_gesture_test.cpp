// Tests of a new user's first gesture: another program drops two images on the window of an editor
// that was started without a file, in any kind of folder and without settings. Skipped only if Xvfb
// is not available.
#include <sys/wait.h>

#include <cstdlib>
#include <thread>

#include "dropping.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

// Script that checks the layered material before it is saved.
const char* const layered = R"(
await nodes 4
finish
assert wire rivets_normal.gradient gradient_add.a
assert wire weave_normal.gradient gradient_add.b
assert wire resolve.normal normal
assert errors 0
assert no-target problem:1
assert picture
await thumbnail rivets_normal
await thumbnail weave_normal
assert dirty
)";

class FirstGesture : public ::testing::Test {
protected:
    FirstGesture() {
        for (const char* name : {"work", "maps", "materials", "home"}) {
            fs::create_directories(folder.path() / name);
            fs::permissions(folder.path() / name, fs::perms::all);
        }
        fs::permissions(folder.path(), fs::perms::all);
    }

    fs::path work() const { return folder.path() / "work"; }
    std::vector<std::string> pictures_in(const char* name) const {
        std::vector<std::string> files;
        for (const char* file : {"rivets_normal.png", "weave_normal.png"}) {
            files.push_back((folder.path() / name / file).string());
            fs::copy_file(fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures" / file, files.back());
        }
        return files;
    }

    // Returns the exit code of an editor that is started in `work` and plays the script; the files
    // are dropped on its canvas meanwhile. Root has no capabilities there, so that the permissions
    // of folders hold for it too; another user might not reach a build below /root.
    int play(const std::string& script, const std::vector<std::string>& files,
             const std::string& graph = {}) {
        const std::string home = folder.path() / "home";
        const char* set = std::getenv("ASAN_OPTIONS");
        const std::string command =
            "cd " + work().string() + " && env -u WAYLAND_DISPLAY -u WRINKLE_PLUGIN_PATH " +
            screen.variable() + " HOME=" + home + " XDG_CONFIG_HOME=" + home +
            "/config XDG_STATE_HOME=" + home + "/state XDG_CACHE_HOME=" + home +
            "/cache ASAN_OPTIONS=" + (set ? set : "") + ":detect_leaks=0 " +
            (getuid() == 0 ? "setpriv --bounding-set=-all --inh-caps=-all " : "") +
            "timeout 120 " WRINKLE_EDITOR " --size 1600 900 --state " + home + "/state --script " +
            folder.write("script.txt", script).string() + " " + graph;
        std::string refused;
        std::thread hand([&] {
            if (!files.empty()) refused = drop_files(screen, 500, 400, files);
        });
        const int status = std::system(command.c_str());
        hand.join();
        EXPECT_EQ(refused, "");
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    // Checks that the program and the editor read a graph saved there without a problem.
    void expect_read(const fs::path& file) {
        EXPECT_EQ(program_output("check " + file.string()), "");
        EXPECT_EQ(play("finish\nassert nodes 4\nassert errors 0\nassert no-target problem:1\n"
                       "assert picture\nawait thumbnail weave_normal\nassert clean\n",
                       {}, file.string()),
                  0);
    }

    const VirtualScreen screen;
    const TemporaryFolder folder;
};

// Script that types a name into the file browser opened by Ctrl+S.
std::string saved_as(const fs::path& file) {
    return "key Ctrl+S\ntype " + file.string() + "\nkey Enter\n";
}

#define NEEDS_A_SCREEN() \
    if (!screen.is_there()) GTEST_SKIP() << "there is no Xvfb here"

TEST_F(FirstGesture, ImagesOfTheWorkingFolderMakeAMaterialBeforeItIsSaved) {
    NEEDS_A_SCREEN();
    const auto files = pictures_in("work");
    ASSERT_EQ(play(layered + ("key Ctrl+S\nclick answer:save\nassert clean\n" +
                              std::string("assert status Saved untitled.json\nassert errors 0\n")),
                   files),
              0);
    expect_read(work() / "untitled.json");
}

TEST_F(FirstGesture, ImagesFromElsewhereAreCopiedIntoAnEmptyWorkingFolder) {
    NEEDS_A_SCREEN();
    const auto files = pictures_in("maps");
    ASSERT_EQ(play("await target copy:yes\nclick copy:yes\n" + std::string(layered), files), 0);
    for (const std::string& file : files)
        EXPECT_EQ(text_of(work() / fs::path(file).filename()), text_of(file));
}

TEST_F(FirstGesture, ImagesFromElsewhereAreReferredToAndTheGraphIsSavedBesideThem) {
    NEEDS_A_SCREEN();
    const auto files = pictures_in("maps");
    ASSERT_EQ(play("await target copy:refer\nclick copy:refer\n" + std::string(layered) +
                       "key Ctrl+S\nclick answer:save\nassert clean\nassert errors 0\n",
                   files),
              0);
    EXPECT_TRUE(fs::is_empty(work()));
    expect_read(folder.path() / "maps" / "untitled.json");
}

TEST_F(FirstGesture, AReadOnlyWorkingFolderTakesImagesOfItsOwnAndRefersToOthers) {
    NEEDS_A_SCREEN();
    const auto own = pictures_in("work"), others = pictures_in("maps");
    constexpr auto may_enter = fs::perms::owner_read | fs::perms::owner_exec |
                               fs::perms::others_read | fs::perms::others_exec;
    fs::permissions(work(), may_enter);
    EXPECT_EQ(play(layered, own), 0);
    EXPECT_EQ(play("await target copy:refer\nassert no-target copy:yes\nclick copy:refer\n" +
                       std::string(layered),
                   others),
              0);
    fs::permissions(work(), fs::perms::all);
}

TEST_F(FirstGesture, AMaterialSavedInAnotherFolderTakesItsImagesAlong) {
    NEEDS_A_SCREEN();
    const auto files = pictures_in("work");
    const fs::path graph = folder.path() / "materials" / "strap.json";
    ASSERT_EQ(play(layered + saved_as(graph) +
                       "await target answer:copy\nclick answer:copy\nassert clean\n"
                       "finish\nassert errors 0\nassert no-target problem:1\nassert picture\n",
                   files),
              0);
    for (const std::string& file : files)
        EXPECT_EQ(text_of(graph.parent_path() / fs::path(file).filename()), text_of(file));
    expect_read(graph);
}

TEST_F(FirstGesture, ImagesChosenByNameMakeTheSameMaterial) {
    NEEDS_A_SCREEN();
    pictures_in("work");
    EXPECT_EQ(play("key I\nclick choice:rivets_normal.png\nkey I\nclick choice:weave_normal.png\n" +
                       std::string(layered),
                   {}),
              0);
}

TEST_F(FirstGesture, ImagesWhoseNamesAreTypedMakeTheSameMaterial) {
    NEEDS_A_SCREEN();
    pictures_in("work");
    EXPECT_EQ(
        play("key I\ntype rivets\nkey Enter\nkey I\ntype weave\nkey Enter\n" + std::string(layered),
             {}),
        0);
}

}  // namespace
}  // namespace wrinkle::editor
