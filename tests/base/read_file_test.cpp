// Tests of reading files: regular files of limited size; streams only where they are named.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "base/file.h"
#include "support/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

class ReadFile : public testing::Test {
protected:
    void SetUp() override { alarm(60); }  // a blocking read ends the program
    void TearDown() override { alarm(0); }

    // Expects that reading `name` in the folder, or a link to it, fails with this reason.
    void expect_refused(const fs::path& path, const std::string& reason) {
        const fs::path link = folder_.path() / "link";
        fs::remove(link);
        fs::create_symlink(path, link);
        for (const fs::path& name : {path, link}) {
            why_.clear();
            EXPECT_FALSE(read_file(name, why_)) << name;
            EXPECT_EQ(why_, reason) << name;
            EXPECT_FALSE(open_to_read(name, why_)) << name;
        }
    }

    test::TemporaryFolder folder_;
    std::string why_;
};

TEST_F(ReadFile, WhatIsNotARegularFileIsRefusedWithoutWaiting) {
    const fs::path pipe = folder_.path() / "pipe", socket_path = folder_.path() / "socket";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    socket_path.string().copy(address.sun_path, sizeof address.sun_path - 1);
    ASSERT_EQ(bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    expect_refused(pipe, "is a pipe, not a file");
    expect_refused(socket_path, "is a socket, not a file");
    expect_refused("/dev/zero", "is a device, not a file");
    expect_refused(folder_.path(), "is a folder, not a file");
    close(socket);
}

TEST_F(ReadFile, ALargerFileThanTheLimitIsRefused) {
    const fs::path file = folder_.put("x", std::string(200'000, 'x'));
    EXPECT_EQ(read_file(file, 200'000, why_).value_or("").size(), 200'000u);
    EXPECT_FALSE(read_file(file, 199'999, why_));
    EXPECT_EQ(why_, "is larger than 199999 bytes; WRINKLE_FILE_MAX_BYTES sets another limit");
}

TEST_F(ReadFile, TheEnvironmentSetsTheLimitWhereItIsANumber) {
    const fs::path file = folder_.put("x", "12345");
    for (const auto& [text, fits] : {std::pair{"5", true}, {"4", false}, {"4 bytes", true}}) {
        setenv("WRINKLE_FILE_MAX_BYTES", text, 1);
        EXPECT_EQ(read_file(file, why_).has_value(), fits) << text;
    }
    unsetenv("WRINKLE_FILE_MAX_BYTES");
}

TEST_F(ReadFile, AStreamIsReadByItsNumber) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    ASSERT_EQ(write(ends[1], "text", 4), 4);
    close(ends[1]);
    const std::string name = "/dev/fd/" + std::to_string(ends[0]);
    EXPECT_EQ(stream_title(name), "<fd " + std::to_string(ends[0]) + ">");
    EXPECT_EQ(read_stream(name, why_), "text");
    close(ends[0]);
    EXPECT_FALSE(read_stream(name, why_));
    EXPECT_EQ(why_, "cannot be read: Bad file descriptor");
}

TEST_F(ReadFile, StreamsAreKnownByTheirNameAlone) {
    for (const char* name : {"-", "/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"})
        EXPECT_EQ(stream_title(name), "<stdin>") << name;
    for (const char* name : {"", "x", "./-", "/dev/zero", "/dev/fd/", "/dev/fd/x", "/dev/fd/1/x",
                             "/dev/fd/-1", "/dev/fd/99999999999999999999"})
        EXPECT_EQ(stream_title(name), "") << name;
}

}  // namespace
}  // namespace wrinkle
