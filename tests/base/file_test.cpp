// Tests of atomic writes, and of paths that stay inside their root.
#include "base/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/texture_options.h"
#include "support/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_ / "inner"); }

    test::TemporaryFolder temporary_;
    fs::path folder_ = temporary_.path();
    std::string why_;
};

TEST_F(Files, ComeBackByteForByte) {
    const std::string bytes("a\0\r\n\xFF", 5);
    ASSERT_TRUE(write_file(folder_ / "x", bytes, why_)) << why_;
    EXPECT_EQ(read_file(folder_ / "x", why_), bytes);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);  // no temporary file is left
}

TEST_F(Files, SyncedOnesKeepModeAndLinkAndGiveTheSystemsError) {
    EXPECT_FALSE(write_file_synced(folder_ / "inner" / "x", "old"));
    fs::permissions(folder_ / "inner" / "x", fs::perms::owner_all);
    fs::create_symlink("inner/x", folder_ / "link");
    EXPECT_FALSE(write_file_synced(folder_ / "link", "new"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(read_file(folder_ / "inner" / "x", why_), "new");
    EXPECT_EQ(fs::status(folder_ / "inner" / "x").permissions(), fs::perms::owner_all);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "inner"), {}), 1);
    EXPECT_EQ(write_file_synced(folder_ / "inner", "a"), std::errc::is_a_directory);
    EXPECT_EQ(write_file_synced(folder_ / "missing" / "x", "a"),
              std::errc::no_such_file_or_directory);
    EXPECT_EQ(write_file_synced("/dev/full", "a"), std::errc::no_space_on_device);
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

TEST_F(Files, ALinkStaysAndItsFileIsReplaced) {
    ASSERT_TRUE(write_file(folder_ / "inner" / "x", "old", why_)) << why_;
    fs::create_symlink("inner/x", folder_ / "link");
    ASSERT_TRUE(write_file(folder_ / "link", "new", why_)) << why_;
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(read_file(folder_ / "inner" / "x", why_), "new");
    fs::create_symlink("inner/y", folder_ / "dangling");
    ASSERT_TRUE(write_file(folder_ / "dangling", "there", why_)) << why_;
    EXPECT_EQ(read_file(folder_ / "inner" / "y", why_), "there");
}

TEST_F(Files, PermissionsAreKept) {
    ASSERT_TRUE(write_file(folder_ / "x", "old", why_)) << why_;
    fs::permissions(folder_ / "x", fs::perms::owner_all);
    ASSERT_TRUE(write_file(folder_ / "x", "new", why_)) << why_;
    EXPECT_EQ(fs::status(folder_ / "x").permissions(), fs::perms::owner_all);
}

TEST_F(Files, APipeWithoutAReaderIsAnError) {
    const fs::path pipe = folder_ / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_FALSE(write_file(pipe, "bytes", why_));
    EXPECT_EQ(why_, "cannot be written: it is a pipe that no program reads");
}

// Written in place; the reader exists already, so opening does not block.
TEST_F(Files, APipeIsWrittenTo) {
    const fs::path pipe = folder_ / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_TRUE(write_file(pipe, "through", why_)) << why_;
    EXPECT_TRUE(fs::is_fifo(pipe));
    char bytes[16] = "";
    EXPECT_EQ(read(reader, bytes, sizeof bytes), 7);
    EXPECT_STREQ(bytes, "through");
    std::error_code error;
    auto beside = Temporary::beside(pipe, error);
    ASSERT_TRUE(beside && !beside->write("again"));
    ASSERT_TRUE(replace_file(*beside, pipe, why_)) << why_;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);  // no temporary file is left
    EXPECT_EQ(read(reader, bytes, sizeof bytes), 5);
    close(reader);
}

TEST_F(Files, SeveralAppearTogetherOrNotAtAll) {
    const FileBytes good[] = {{folder_ / "a", "1"}, {folder_ / "b", "2"}};
    ASSERT_TRUE(write_files(good, why_)) << why_;
    const FileBytes bad[] = {{folder_ / "a", "3"}, {folder_ / "missing" / "b", "4"}};
    EXPECT_FALSE(write_files(bad, why_));
    EXPECT_NE(why_.find("missing"), why_.npos) << why_;
    EXPECT_EQ(read_file(folder_ / "a", why_), "1");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 3);  // no temporary file is left
}

TEST_F(Files, PathsStayInside) {
    EXPECT_TRUE(inside(folder_, folder_ / "inner" / "new.png"));
    EXPECT_TRUE(inside(folder_, folder_ / "inner" / ".." / "new.png"));
    EXPECT_TRUE(inside(folder_, folder_));
    EXPECT_FALSE(inside(folder_, folder_ / ".." / "new.png"));
    EXPECT_FALSE(inside(folder_ / "inner", folder_ / "inner2" / "new.png"));
    fs::create_directory_symlink("/", folder_ / "inner" / "out");
    EXPECT_FALSE(inside(folder_, folder_ / "inner" / "out" / "etc"));
    EXPECT_FALSE(inside(folder_, folder_ / "inner" / "out"));
    fs::create_symlink("inner", folder_ / "alias");
    EXPECT_EQ(inside(folder_, folder_ / "alias"), inside(folder_, folder_ / "inner"));
    EXPECT_EQ(real_path(folder_ / "alias" / "new.png"), real_path(folder_ / "inner") / "new.png");
}

// The canonical path of the folder, followed by the rest of the path.
TEST_F(Files, PathsOfWhatIsNotThereAreThoseOfItsFolder) {
    const fs::path inner = fs::canonical(folder_) / "inner";
    fs::create_directories(inner);
    fs::create_directory_symlink(inner, folder_ / "way");
    fs::create_symlink(folder_ / "nowhere", folder_ / "inner" / "dangling");
    EXPECT_EQ(real_path(folder_ / "way" / "new.png"), inner / "new.png");
    EXPECT_EQ(real_path(folder_ / "way" / "a" / "b.png"), inner / "a" / "b.png");
    EXPECT_EQ(real_path(folder_ / "way" / "dangling"), inner / "dangling");
    EXPECT_EQ(real_path(folder_ / "way" / "no" / ".."), inner / "");
    EXPECT_EQ(real_path("new.png"), fs::current_path() / "new.png");
}

TEST(TextureOptions, NamesComeBack) {
    for (const std::string_view name : encoding_names)
        EXPECT_EQ(name_of(encoding_named(name).value()), name);
    for (const std::string_view name : wrap_names)
        EXPECT_EQ(name_of(wrap_named(name).value()), name);
    for (const std::string_view name : filter_names)
        EXPECT_EQ(name_of(filter_named(name).value()), name);
    EXPECT_FALSE(encoding_named("Linear"));
    EXPECT_FALSE(wrap_named(""));
    EXPECT_FALSE(filter_named("cubic"));
}

}  // namespace
}  // namespace wrinkle
