// Tests that `wrinkle test` does not read or write through links that lead out of its root.
#include <fstream>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

class GoldenLinksTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        put("t/g.json", tilt_graph());
        put("t/g.test.json", R"({"glsl": true})");
        put("outside/g.glsl", "secret");
    }

    void expect_refused(const std::vector<std::string>& more = {}) {
        for (const bool update : {false, true}) {
            std::vector<std::string> words{"test", "t"};
            if (update) words.emplace_back("--update");
            words.insert(words.end(), more.begin(), more.end());
            const Ran ran = run(words);
            EXPECT_EQ(ran.code, 1) << ran.out;
            EXPECT_TRUE(says(ran.err, "leads outside the"));
            EXPECT_EQ(ran.out.find("secret"), ran.out.npos);
            EXPECT_EQ(get("outside/g.glsl"), "secret");
            EXPECT_FALSE(exists("outside/new.glsl"));
        }
    }
};

TEST_F(GoldenLinksTest, AFolderOfGoldenFilesThatLeadsOutIsRefused) {
    fs::create_symlink("../outside", folder / "t/golden");
    expect_refused();
}

TEST_F(GoldenLinksTest, AGoldenFileThatLeadsOutIsRefused) {
    fs::create_directory(folder / "t/golden");
    fs::create_symlink("../../outside/g.glsl", folder / "t/golden/g.glsl");
    expect_refused();
    fs::remove(folder / "t/golden/g.glsl");
    fs::create_symlink("../../outside/new.glsl", folder / "t/golden/g.glsl");  // dangling
    expect_refused();
}

TEST_F(GoldenLinksTest, AGraphThatLeadsOutIsRefused) {
    put("outside/other.json", tilt_graph());
    fs::remove(folder / "t/g.json");
    fs::create_symlink("../outside/other.json", folder / "t/g.json");
    expect_refused();
}

TEST_F(GoldenLinksTest, ATestThatIsFoundAndLeadsOutIsRefused) {
    put("outside/h.test.json", R"({"glsl": true})");
    fs::create_symlink("../outside/h.test.json", folder / "t/h.test.json");
    expect_refused();
}

TEST_F(GoldenLinksTest, AReportDoesNotFollowLinksOutOfTheWorkingFolder) {
    put("t/g.test.json", R"({"glsl": true, "render": {"size": "8x8"}})");
    const fs::path away = folder.parent_path() / "away";
    fs::create_directories(away / "actual");
    std::ofstream(away / "actual/mine.png") << "mine";
    std::ofstream(away / "results.json") << "{}";
    const auto untouched = [&] {
        size_t count = 0;
        for (const auto& entry : fs::recursive_directory_iterator(away))
            count += entry.is_regular_file();
        return count == 2 && bytes_of(away / "actual/mine.png") == "mine" &&
               bytes_of(away / "results.json") == "{}";
    };
    for (const char* link : {".wrinkle", ".wrinkle/test", ".wrinkle/test/actual",
                             ".wrinkle/test/index.html", ".wrinkle/test/results.json"}) {
        fs::remove_all(folder / ".wrinkle");
        fs::create_directories((folder / link).parent_path());
        const std::string leaf = fs::path(link).filename();
        const bool is_file = leaf.find(".json") != leaf.npos || leaf.find(".html") != leaf.npos;
        fs::create_symlink(leaf == "actual" ? away / "actual"
                           : is_file        ? away / leaf
                                            : away,
                           folder / link);
        EXPECT_EQ(run({"test", "t"}, "", {"CI="}).code, 0) << link;
        EXPECT_TRUE(untouched()) << link;
    }
}

TEST_F(GoldenLinksTest, LinksBelowTheRootAreFollowed) {
    fs::create_symlink("../outside", folder / "t/golden");
    EXPECT_EQ(run({"test", "t", "--update", "--root", "."}).code, 0);
    EXPECT_EQ(get("outside/g.glsl"), run({"compile", "t/g.json"}).out);
    EXPECT_EQ(run({"test", "t", "--root", "."}).code, 0);
}

}  // namespace
}  // namespace wrinkle::test
