// Tests of locating the files named by graphs, with links along the path and at its end.
#include "graph/named_files.h"

#include <gtest/gtest.h>

#include "support/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

class NamedFile : public testing::Test {
protected:
    void SetUp() override {
        temporary.put("outside/picture.png", "far");
        temporary.put("in/pictures/own.png", "near");
        temporary.put("in/top.json", R"({"wrinkle": 1, "nodes": {}})");
        fs::create_symlink(folder / "outside/picture.png", folder / "in/pictures/out.png");
        fs::create_symlink("own.png", folder / "in/pictures/again.png");
        fs::create_symlink(folder / "outside", folder / "in/away");
        fs::create_symlink("pictures", folder / "in/same");
        project = load_project(folder / "in/top.json", {}, diagnostics);
        EXPECT_EQ(to_text(diagnostics), "");
        files.emplace(project);
    }

    // Path relative to the root; "outside" is not below it.
    std::string place(const std::string& name) {
        const NamedFiles::Found& found = files->find(0, name);
        if (!found.path) return "outside";
        return found.path->lexically_relative(project.root).string() +
               (found.type == fs::file_type::regular     ? ""
                : found.type == fs::file_type::directory ? " (folder)"
                                                         : " (none)");
    }

    test::TemporaryFolder temporary;
    const fs::path folder = fs::canonical(temporary.path());
    Diagnostics diagnostics;
    Project project;
    std::optional<NamedFiles> files;
};

TEST_F(NamedFile, IsWhereItReallyIs) {
    EXPECT_EQ(place("pictures/own.png"), "pictures/own.png");
    EXPECT_EQ(place("pictures/../pictures/own.png"), "pictures/own.png");
    EXPECT_EQ(place("same/own.png"), "pictures/own.png");
    EXPECT_EQ(place("pictures/again.png"), "pictures/own.png");
    EXPECT_EQ(place("pictures/none.png"), "pictures/none.png (none)");
    EXPECT_EQ(place("nowhere/own.png"), "nowhere/own.png (none)");
    EXPECT_EQ(place("pictures"), "pictures (folder)");
    EXPECT_EQ(place("pictures/"), "pictures (folder)");
    EXPECT_EQ(place("same/"), "pictures (folder)");
    EXPECT_EQ(place("pictures//own.png"), "pictures/own.png");
    EXPECT_EQ(place("./pictures/./own.png"), "pictures/own.png");
    EXPECT_EQ(place("pictures/own.png/"), "pictures/own.png/ (none)");
    EXPECT_EQ(place("pictures/own.png/own.png"), "pictures/own.png/own.png (none)");
    EXPECT_EQ(place((folder / "in/pictures/own.png").string()), "pictures/own.png");
}

TEST_F(NamedFile, NeverLeavesTheRoot) {
    EXPECT_EQ(place("pictures/out.png"), "outside");
    EXPECT_EQ(place("away/picture.png"), "outside");
    EXPECT_EQ(place("../outside/picture.png"), "outside");
    EXPECT_EQ(place("pictures/../../outside/picture.png"), "outside");
    EXPECT_EQ(place(std::string("pictures/own.png\0", 17)), "outside");
}

// A file must be below the given root; the graph's folder need not be.
TEST_F(NamedFile, IsHeldAgainstTheRootThatWasGiven) {
    const auto found = [&](const fs::path& root) {
        project = load_project(folder / "in/top.json", {.root = root, .limits = {}}, diagnostics);
        files.emplace(project);
        return files->find(0, "pictures/own.png").path;
    };
    EXPECT_EQ(found(folder), folder / "in/pictures/own.png");
    EXPECT_EQ(found("/"), folder / "in/pictures/own.png");
    EXPECT_EQ(found(folder / "in/pictures"), folder / "in/pictures/own.png");
    EXPECT_FALSE(found(folder / "in/pic").has_value());
    EXPECT_FALSE(found(folder / "outside").has_value());
}

}  // namespace
}  // namespace wrinkle
