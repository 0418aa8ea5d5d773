#include "base/folder_watch.h"

#include <sys/inotify.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/temporary.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

constexpr uint32_t watched_events = IN_CLOSE_WRITE | IN_MOVED_FROM | IN_MOVED_TO | IN_CREATE |
                                    IN_DELETE | IN_ATTRIB | IN_DELETE_SELF | IN_MOVE_SELF |
                                    IN_ONLYDIR;
constexpr uint32_t lost_events = IN_Q_OVERFLOW | IN_DELETE_SELF | IN_MOVE_SELF | IN_UNMOUNT;

using FolderNames = std::map<fs::path, std::set<std::string, std::less<>>>;

constexpr std::string_view any_name = "";

// Puts the names of a path on a stack, the first on top.
void push_names(const fs::path& path, std::vector<std::string>& names) {
    const size_t before = names.size();
    for (const fs::path& name : path.relative_path())
        if (!name.empty() && name != ".") names.push_back(name.string());
    std::reverse(names.begin() + static_cast<ptrdiff_t>(before), names.end());
}

// Adds each folder that is passed on the way to an absolute path, with the next name in it. A path
// to a folder adds all names in that.
void add_folders(const fs::path& file, FolderNames& folders) {
    constexpr int longest_chain = 40;  // the system follows as many links
    fs::path at = "/";
    std::vector<std::string> rest;
    push_names(file, rest);
    int links = 0;
    std::error_code error;
    while (!rest.empty()) {
        const std::string name = rest.back();
        rest.pop_back();
        folders[at].insert(name);
        const fs::path next = at / name;
        const fs::file_type type = fs::symlink_status(next, error).type();
        if (name == "..") {
            at = at.parent_path();
        } else if (type == fs::file_type::symlink && ++links <= longest_chain) {
            const fs::path target = fs::read_symlink(next, error);
            if (target.is_absolute()) at = "/";
            push_names(target, rest);
        } else if (type == fs::file_type::directory) {
            at = next;
            if (rest.empty()) folders[at].insert(std::string(any_name));
        } else {
            return;
        }
    }
}

// Returns true for file systems on which others' changes cause no events (linux/magic.h).
bool is_silent(const fs::path& folder) {
    constexpr uint32_t nfs = 0x6969, smb = 0x517B, cifs = 0xFF534D42, smb2 = 0xFE534D42,
                       plan9 = 0x01021997, fuse = 0x65735546, ceph = 0x00C36400;
    struct statfs found = {};
    if (statfs(folder.c_str(), &found) != 0) return false;
    const auto type = static_cast<uint32_t>(found.f_type);
    for (const uint32_t each : {nfs, smb, cifs, smb2, plan9, fuse, ceph})
        if (type == each) return true;
    return false;
}

}  // namespace

std::optional<FolderWatch> FolderWatch::make(std::string& why) {
    const int descriptor = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    if (descriptor >= 0) return FolderWatch(descriptor);
    why = last_error().message();
    return {};
}

FolderWatch::FolderWatch(FolderWatch&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), names_(std::move(other.names_)) {}

FolderWatch& FolderWatch::operator=(FolderWatch&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    std::swap(names_, other.names_);
    return *this;
}

FolderWatch::~FolderWatch() {
    if (descriptor_ >= 0) close(descriptor_);
}

bool FolderWatch::watch(const std::set<fs::path>& files, std::string& why) {
    FolderNames folders;
    std::set<fs::path> last;  // folders that may not fail
    for (const fs::path& file : files) {
        const fs::path absolute = fs::absolute(file);
        add_folders(absolute, folders);
        last.insert(absolute.parent_path());
    }
    for (const fs::path& folder : last)
        if (is_silent(folder)) {
            why = folder.string() + " is on a file system that reports no changes";
            return false;
        }
    std::map<int, Names> names;
    for (auto& [folder, inside] : folders) {
        const int number = inotify_add_watch(descriptor_, folder.c_str(), watched_events);
        if (number >= 0) {
            names[number].merge(inside);
        } else if (errno != ENOENT && errno != ENOTDIR &&
                   (errno == ENOSPC || last.contains(folder))) {
            why = folder.string() + ": " + last_error().message();
            return false;
        }
    }
    for (const auto& [number, ignored] : names_)
        if (!names.contains(number)) inotify_rm_watch(descriptor_, number);
    names_ = std::move(names);
    return true;
}

bool FolderWatch::take_events() {
    bool relevant = false;
    alignas(inotify_event) char buffer[1 << 14];
    ssize_t size = 0;
    while ((size = read(descriptor_, buffer, sizeof buffer)) > 0) {
        for (ssize_t at = 0; at < size;) {
            inotify_event event;
            std::memcpy(&event, buffer + at, sizeof event);
            const char* name = buffer + at + sizeof event;
            at += static_cast<ssize_t>(sizeof event + event.len);
            const auto watched = names_.find(event.wd);
            if (event.mask & IN_Q_OVERFLOW) relevant = true;
            if (watched == names_.end()) continue;
            relevant |= (event.mask & lost_events) != 0;
            if (event.len > 0)
                relevant |= watched->second.contains(std::string_view(name)) ||
                            watched->second.contains(any_name);
        }
    }
    return relevant;
}

}  // namespace wrinkle
