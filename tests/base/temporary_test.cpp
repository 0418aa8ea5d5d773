// Tests of temporary files: those of a killed process are removed, those of a live process are not.
#include "base/temporary.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/file.h"
#include "support/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

class TemporaryFile : public testing::Test {
protected:
    size_t count() const {
        return static_cast<size_t>(std::distance(fs::directory_iterator(folder_.path()), {}));
    }

    test::TemporaryFolder folder_;
    std::error_code error_;
    fs::path target_ = folder_.path() / "out.png";
};

// Starts a process that has created a Temporary and waits.
pid_t process_with_temporary(const fs::path& target) {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
        std::error_code error;
        const auto made = Temporary::beside(target, error);
        if (write(ends[1], "x", 1) == 1) pause();
        _exit(1);
    }
    char ready = 0;
    EXPECT_EQ(read(ends[0], &ready, 1), 1);
    close(ends[0]);
    close(ends[1]);
    return child;
}

TEST_F(TemporaryFile, IsRemovedWhereItWasNotPlaced) {
    {
        const auto made = Temporary::beside(target_, error_);
        ASSERT_TRUE(made) << error_.message();
        EXPECT_EQ(made->path().parent_path(), folder_.path());
        EXPECT_EQ(made->path().extension(), ".png");
        EXPECT_EQ(count(), 1u);
    }
    EXPECT_EQ(count(), 0u);
}

TEST_F(TemporaryFile, TakesThePlaceWithTheOldPermissions) {
    folder_.put("out.png", "old");
    fs::permissions(target_, fs::perms::owner_all);
    auto made = Temporary::beside(target_, error_);
    ASSERT_TRUE(made && !made->write("new") && !made->place(target_));
    EXPECT_EQ(test::bytes_of(target_), "new");
    EXPECT_EQ(fs::status(target_).permissions(), fs::perms::owner_all);
    EXPECT_EQ(count(), 1u);
}

TEST_F(TemporaryFile, OfAKilledProcessIsRemovedByTheNextAndOfALivingOneIsKept) {
    const pid_t living = process_with_temporary(target_);
    const pid_t killed = process_with_temporary(target_);
    kill(killed, SIGKILL);
    waitpid(killed, nullptr, 0);
    folder_.put(".wrinkle-tmp", "another file");
    EXPECT_EQ(count(), 3u);
    {
        const auto made = Temporary::beside(target_, error_);
        EXPECT_EQ(count(), 3u);  // the file of the live process, this one, and the other file
    }
    kill(living, SIGKILL);
    waitpid(living, nullptr, 0);
    EXPECT_EQ(count(), 2u);
}

TEST_F(TemporaryFile, ALinkOfItsNameIsNotFollowed) {
    const fs::path other = folder_.put("other", "kept");
    fs::create_symlink(other, folder_.path() / ".wrinkle-tmp-1-0");
    const auto made = Temporary::beside(target_, error_);
    EXPECT_EQ(test::bytes_of(other), "kept");
}

TEST_F(TemporaryFile, GivesTheSystemsError) {
    EXPECT_FALSE(Temporary::beside(folder_.path() / "missing/x", error_));
    EXPECT_EQ(error_, std::errc::no_such_file_or_directory);
}

}  // namespace
}  // namespace wrinkle
