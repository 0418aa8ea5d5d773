// Files that are written under a name of their own and take their place by one rename.
//
// ".wrinkle-tmp-PID-N.EXT" is beside the place, and locked (flock) as long as its writer lives. So
// what a killed program left is known by its name and by being unlocked; the next Temporary in that
// folder removes it. A folder is searched once a process. Names are no longer than 48 bytes.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace wrinkle {

class Temporary {
public:
    // An empty file beside `target`, with its extension; nothing with the system's error.
    static std::optional<Temporary> beside(const std::filesystem::path& target,
                                           std::error_code& error);
    Temporary(Temporary&& other) noexcept;
    Temporary& operator=(Temporary&&) = delete;
    ~Temporary() { remove(); }

    // Whether a file called so is one, of a program that runs or is dead.
    static bool is_name(std::string_view file) { return file.starts_with(prefix); }

    const std::filesystem::path& path() const { return path_; }
    std::error_code write(std::string_view bytes) const;
    std::error_code sync() const;

    // Takes the place of `target` with the permissions of what was there. With an error it is
    // removed.
    std::error_code place(const std::filesystem::path& target);
    void remove();  // nothing after place()

private:
    Temporary(std::filesystem::path path, int handle) : path_(std::move(path)), handle_(handle) {}

    static constexpr std::string_view prefix = ".wrinkle-tmp-";

    std::filesystem::path path_;
    int handle_ = -1;  // -1: it is gone
};

}  // namespace wrinkle
