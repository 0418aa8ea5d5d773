// Files that appear whole or not at all, and paths that stay inside their root.
#include "base/file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/texture_options.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("wrinkle_files_" + std::to_string(getpid()));
        fs::create_directories(folder_ / "inner");
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_;
    std::string why_;
};

TEST_F(Files, ComeBackByteForByte) {
    const std::string bytes("a\0\r\n\xFF", 5);
    ASSERT_TRUE(write_file(folder_ / "x", bytes, why_)) << why_;
    EXPECT_EQ(read_file(folder_ / "x", why_), bytes);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);  // nothing temporary
}

TEST_F(Files, EqualBytesLeaveAFileAlone) {
    ASSERT_TRUE(write_file(folder_ / "x", "same", why_));
    const auto long_ago = fs::last_write_time(folder_ / "x") - std::chrono::hours(1);
    fs::last_write_time(folder_ / "x", long_ago);
    ASSERT_TRUE(write_file(folder_ / "x", "same", why_));
    EXPECT_EQ(fs::last_write_time(folder_ / "x"), long_ago);
    ASSERT_TRUE(write_file(folder_ / "x", "other", why_));
    EXPECT_NE(fs::last_write_time(folder_ / "x"), long_ago);
}

TEST_F(Files, SayWhyTheyCannotBeRead) {
    EXPECT_FALSE(read_file(folder_ / "missing", why_));
    EXPECT_NE(why_.find("No such file"), why_.npos) << why_;
    EXPECT_FALSE(read_file(folder_, why_));
    EXPECT_NE(why_.find("folder"), why_.npos) << why_;
}

TEST_F(Files, SayWhyTheyCannotBeWritten) {
    EXPECT_FALSE(write_file(folder_ / "missing" / "x", "a", why_));
    EXPECT_NE(why_.find("No such file"), why_.npos) << why_;
    why_.clear();
    EXPECT_FALSE(write_file(folder_ / "inner", "a", why_));
    EXPECT_FALSE(why_.empty());
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(Files, PathsStayInside) {
    EXPECT_TRUE(inside(folder_, folder_ / "inner" / "new.png"));
    EXPECT_TRUE(inside(folder_, folder_ / "inner" / ".." / "new.png"));
    EXPECT_TRUE(inside(folder_, folder_));
    EXPECT_FALSE(inside(folder_, folder_ / ".." / "new.png"));
    EXPECT_FALSE(inside(folder_ / "inner", folder_ / "inner2" / "new.png"));
    fs::create_directory_symlink("/", folder_ / "inner" / "out");
    EXPECT_FALSE(inside(folder_, folder_ / "inner" / "out" / "etc"));
}

TEST(TextureOptions, NamesComeBack) {
    for (const std::string_view name : encoding_names())
        EXPECT_EQ(name_of(encoding_named(name).value()), name);
    for (const std::string_view name : wrap_names())
        EXPECT_EQ(name_of(wrap_named(name).value()), name);
    for (const std::string_view name : filter_names())
        EXPECT_EQ(name_of(filter_named(name).value()), name);
    EXPECT_FALSE(encoding_named("Linear"));
    EXPECT_FALSE(wrap_named(""));
    EXPECT_FALSE(filter_named("cubic"));
}

}  // namespace
}  // namespace wrinkle
