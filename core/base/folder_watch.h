// Reports that files may have changed, by inotify on the folders that lead to them.
//
// Editors replace files by renaming, which a watch of the file itself does not survive. Each folder
// of a path and each folder with a symbolic link of it is watched for the next name, so a
// retargeted link, a replaced folder and a file that does not exist yet are noticed too; of a path
// to a folder, all names in it. Changes through memory maps are not noticed.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace wrinkle {

class FolderWatch {
public:
    // Returns std::nullopt and the reason in `why` if the system has no more inotify instances.
    static std::optional<FolderWatch> make(std::string& why);
    FolderWatch(FolderWatch&& other) noexcept;
    FolderWatch& operator=(FolderWatch&& other) noexcept;
    ~FolderWatch();

    // Replaces the watched files. Returns false and the reason in `why` if a folder of a file
    // cannot be watched, as on network and FUSE file systems. O(files * path length).
    bool watch(const std::set<std::filesystem::path>& files, std::string& why);

    int descriptor() const { return descriptor_; }  // readable if events are pending
    // Takes all pending events; returns true if one concerns a watched name, a watched folder was
    // removed, moved or unmounted, or events were lost.
    bool take_events();

private:
    explicit FolderWatch(int descriptor) : descriptor_(descriptor) {}

    using Names = std::set<std::string, std::less<>>;
    int descriptor_ = -1;
    std::map<int, Names> names_;  // watched names by watch descriptor
};

}  // namespace wrinkle
