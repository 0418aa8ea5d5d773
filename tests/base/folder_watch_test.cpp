// Tests of the watch of folders, the log of files and the comparison of contents.
#include "base/folder_watch.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "base/file.h"
#include "base/file_log.h"
#include "support/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

class FolderWatchTest : public testing::Test {
protected:
    void SetUp() override {
        std::string why;
        watch_ = FolderWatch::make(why);
        ASSERT_TRUE(watch_) << why;
    }
    void watch(const std::string& name) {
        std::string why;
        ASSERT_TRUE(watch_->watch({folder / name}, why)) << why;
        watch_->take_events();
    }
    bool noticed() { return watch_->take_events(); }

    test::TemporaryFolder temporary;
    fs::path folder = temporary.path();
    std::optional<FolderWatch> watch_;
    std::error_code ignored_;
};

TEST_F(FolderWatchTest, NoticesOneNameOnly) {
    temporary.put("a", "1");
    watch("a");
    EXPECT_FALSE(noticed());
    temporary.put("b", "1");
    EXPECT_FALSE(noticed());
    temporary.put("a", "2");
    EXPECT_TRUE(noticed());
    EXPECT_FALSE(noticed());
    fs::rename(folder / "b", folder / "a");
    EXPECT_TRUE(noticed());
    fs::remove(folder / "a");
    EXPECT_TRUE(noticed());
}

TEST_F(FolderWatchTest, NoticesFoldersAndLinksOnTheWay) {
    temporary.put("real/x/a", "1");
    fs::create_directory_symlink("real/../real/x", folder / "link");
    watch("link/a");
    temporary.put("real/x/a", "2");
    EXPECT_TRUE(noticed());
    fs::rename(folder / "real/x", folder / "real/y");
    EXPECT_TRUE(noticed());
    watch("link/a");
    temporary.put("real/y/a", "3");
    EXPECT_FALSE(noticed());
    fs::remove(folder / "link");
    fs::create_directory_symlink("real/y", folder / "link");
    EXPECT_TRUE(noticed());
    watch("link/a");
    temporary.put("real/y/a", "4");
    EXPECT_TRUE(noticed());
}

TEST_F(FolderWatchTest, NoticesTheFirstMissingFolder) {
    watch("not/yet/a");
    fs::create_directories(folder / "not/yet");
    EXPECT_TRUE(noticed());
    watch("not/yet/a");
    temporary.put("not/yet/b", "1");
    EXPECT_FALSE(noticed());
    temporary.put("not/yet/a", "1");
    EXPECT_TRUE(noticed());
}

TEST_F(FolderWatchTest, LostEventsAreAChange) {
    temporary.put("a", "1");
    temporary.put("b", "1");
    watch("a");
    for (int i = 0; i < 40'000; ++i) {  // the queue has 16,384 by default; equal neighbours merge
        fs::permissions(folder / (i % 2 ? "b" : "c"), fs::perms::owner_all,
                        fs::perm_options::replace, ignored_);
        fs::rename(folder / (i % 2 ? "c" : "b"), folder / (i % 2 ? "b" : "c"), ignored_);
    }
    EXPECT_TRUE(noticed());
}

// A program that writes a file truncates it first: a reader may see the empty file.
TEST(DiskCopy, AChangeAfterTheReadIsNoticed) {
    const test::TemporaryFolder folder;
    const fs::path file = folder.put("a", "");
    const Stamp stamp = stamp_of(file);
    folder.put("a", "the rest");
    DiskCopy known = DiskCopy::of(stamp, "");
    EXPECT_EQ(compare(known, file), OnDisk::changed);
    known = DiskCopy::of(stamp_of(file), "the rest");
    EXPECT_EQ(compare(known, file), OnDisk::same);
}

TEST(DiskCopy, TellsContentsFromDates) {
    const test::TemporaryFolder folder;
    const fs::path file = folder.put("a", "1");
    DiskCopy known = DiskCopy::of(file);
    EXPECT_EQ(compare(known, file), OnDisk::same);
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1));
    EXPECT_EQ(compare(known, file), OnDisk::same);
    folder.put("a", "2");
    EXPECT_EQ(compare(known, file), OnDisk::changed);
    fs::remove(file);
    EXPECT_EQ(compare(known, file), OnDisk::gone);
    known = DiskCopy::of(file);
    EXPECT_EQ(compare(known, file), OnDisk::same);
    folder.put("a", "");
    EXPECT_EQ(compare(known, file), OnDisk::changed);
    DiskCopy names = DiskCopy::of(folder.path());
    folder.put(".wrinkle-tmp-1-1", "");
    EXPECT_EQ(compare(names, folder.path()), OnDisk::same);
    folder.put("b", "");
    EXPECT_EQ(compare(names, folder.path()), OnDisk::changed);
}

TEST(FileLog, HasInputsInVainAndOutputs) {
    const test::TemporaryFolder folder;
    const fs::path there = folder.put("a b", "1"), missing = folder.path() / "none";
    const fs::path same = folder.put("same", "1"), other = folder.put("other", "1");
    const int log = memfd_create("log", MFD_CLOEXEC);
    start_file_log(log);
    std::string why;
    read_file(there, why);
    read_file(missing, why);
    write_file(same, "1", why);
    write_file(other, "2", why);
    start_file_log(-1);
    read_file(folder.path() / "after", why);
    const FileLog files = read_file_log(log);
    close(log);
    ASSERT_GE(files.inputs.size(), 2u);
    EXPECT_EQ(files.inputs[0].path, there);
    EXPECT_EQ(files.inputs[0].stamp, stamp_of(there));
    EXPECT_EQ(files.inputs[1].path, missing);
    EXPECT_FALSE(files.inputs[1].stamp.there);
    EXPECT_EQ(files.replaced, std::vector<fs::path>{other});
    for (const fs::path& output : {same, other})
        EXPECT_NE(std::ranges::find(files.outputs, output), files.outputs.end());
}

}  // namespace
}  // namespace wrinkle
