// Files of tests: a temporary folder, and files read as bytes.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace wrinkle::test {

// Returns "" and adds a test failure if the file cannot be read.
inline std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path << " cannot be read";
    return {std::istreambuf_iterator<char>(file), {}};
}

// A temporary folder, with a path free of links; removed with its contents by the destructor.
class TemporaryFolder {
public:
    TemporaryFolder() : path_(fresh()) { std::filesystem::create_directories(path_); }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    // Writes a file and creates its parent folders; returns its complete path.
    std::filesystem::path put(const std::filesystem::path& name, std::string_view bytes) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream out(file, std::ios::binary);
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        EXPECT_TRUE(out.flush()) << file << " cannot be written";
        return file;
    }

private:
    static std::filesystem::path fresh() {
        static int count = 0;
        const auto all = std::filesystem::canonical(std::filesystem::temp_directory_path());
        return all / ("wrinkle_test_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    }

    std::filesystem::path path_;
};

}  // namespace wrinkle::test
