#include "editor/model/document/folders.h"

#include <cstdlib>

#include "base/folders.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;

Folders user_folders() {
    const fs::path data = user_folder("XDG_DATA_HOME", ".local/share");
    return {user_folder("XDG_CONFIG_HOME", ".config"),
            user_folder("XDG_STATE_HOME", ".local/state"),
            data.empty() ? fs::path() : data / "library"};
}

Folders folders_below(const fs::path& folder) {
    return {folder / "config", folder / "state", folder / "library"};
}

fs::path with_home(const fs::path& typed) {
    const std::string text = typed.string();
    const char* home = std::getenv("HOME");
    if (!home || (text != "~" && !text.starts_with("~/"))) return typed;
    return text.size() < 3 ? fs::path(home) : fs::path(home) / text.substr(2);
}

NewPaths::~NewPaths() {
    std::error_code ignored;
    for (auto path = paths_.rbegin(); path != paths_.rend(); ++path)
        fs::remove(*path, ignored);  // a folder only if it is empty
}

void NewPaths::add_missing(fs::path folder) {
    std::error_code ignored;
    const auto known = static_cast<std::ptrdiff_t>(paths_.size());
    for (; !folder.empty() && !fs::exists(folder, ignored); folder = folder.parent_path())
        paths_.insert(paths_.begin() + known, folder);
}

std::string disk_words(const std::error_code& error) {
    using std::errc;
    if (error == errc::no_space_on_device || error.value() == EDQUOT) return "the disk is full";
    if (error == errc::read_only_file_system) return "the disk can only be read";
    if (error == errc::permission_denied || error == errc::operation_not_permitted)
        return "its folder may not be written to";
    if (error == errc::no_such_file_or_directory || error == errc::not_a_directory)
        return "its folder is no longer there";
    if (error == errc::is_a_directory) return "there is a folder of this name";
    if (error == errc::filename_too_long) return "its name is too long";
    if (error == errc::file_too_large) return "it is larger than a file may be here";
    return "the system says \"" + error.message() + "\"";
}

std::string disk_words(std::string_view why) {
    for (const int code :
         {ENOSPC, EDQUOT, EROFS, EACCES, EPERM, ENOENT, ENOTDIR, EISDIR, ENAMETOOLONG, EFBIG}) {
        const std::error_code error(code, std::generic_category());
        if (why.find(error.message()) != why.npos) return disk_words(error);
    }
    return std::string(why);
}

}  // namespace wrinkle::editor
