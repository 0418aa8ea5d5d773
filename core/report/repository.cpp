#include "report/repository.h"

#include <string_view>

#include "base/file.h"

namespace wrinkle::report {
namespace fs = std::filesystem;

fs::path repository_root(const fs::path& folder) {
    std::error_code ignored;
    for (fs::path at = folder;; at = at.parent_path()) {
        if (fs::exists(at / ".git", ignored)) return at;  // a folder, or a file of a work tree
        if (at == at.parent_path()) return folder;
    }
}

std::string path_in_repository(const std::string& file, const fs::path& root) {
    std::error_code ignored;
    return path_from(root, fs::absolute(file, ignored)).generic_string();
}

std::string uri_of(const std::string& path) {
    constexpr std::string_view unreserved =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string uri = path.starts_with('/') ? "file://" : "";
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (unreserved.find(c) != unreserved.npos)
            uri += c;
        else
            uri += {'%', digits[byte >> 4], digits[byte & 15]};
    }
    return uri;
}

}  // namespace wrinkle::report
