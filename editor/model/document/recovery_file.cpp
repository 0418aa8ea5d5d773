#include "editor/model/document/recovery_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <thread>

#include "base/file.h"
#include "base/text.h"
#include "editor/model/document/watch.h"
#include "graph/write.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

constexpr const char* unfinished = ".new";  // suffix of the temporary file

std::error_code write_all(int handle, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(handle, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return last_error();
        bytes.remove_prefix(static_cast<size_t>(written));
    }
    return {};
}

std::string hex(uint64_t number) {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(number));
    return digits;
}

fs::path new_file_in(const fs::path& folder) {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const auto stamp = std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
    return folder / (std::to_string(getpid()) + "-" + std::to_string(stamp) + ".journal");
}

// Returns true if a running program holds the lock, which the system releases when the program
// exits, or if it replaced the file just now.
bool is_in_use(const fs::path& file) {
    const int handle = open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (handle < 0) return true;
    const bool locked = flock(handle, LOCK_EX | LOCK_NB) != 0;
    struct stat opened = {}, current = {};
    const bool replaced = fstat(handle, &opened) != 0 || stat(file.c_str(), &current) != 0 ||
                          opened.st_ino != current.st_ino;
    close(handle);
    return locked || replaced;
}

bool is_saved(const Recoverable& found) {
    std::string why;
    if (found.graph.empty()) return false;
    const auto bytes = read_file(found.graph, why);
    return bytes && *bytes == found.text;
}

}  // namespace

std::error_code RecoveryFile::replace(const std::string& contents) {
    const std::string temporary = file_.string() + unfinished;
    const int handle = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (handle < 0) return last_error();
    std::error_code error =
        flock(handle, LOCK_EX | LOCK_NB) == 0 ? write_all(handle, contents) : last_error();
    if (!error) fs::rename(temporary, file_, error);
    if (error) {
        unlink(temporary.c_str());
        ::close(handle);
        return error;
    }
    if (handle_ >= 0) ::close(handle_);
    handle_ = handle;
    return {};
}

std::error_code RecoveryFile::write(const fs::path& state_folder, const fs::path& graph,
                                    const std::string& refused, const Document& document) {
    std::error_code error;
    if (handle_ < 0) {
        const fs::path folder = state_folder / "journal";
        fs::create_directories(folder, error);
        if (error) return error;
        file_ = new_file_in(folder);
    }
    const std::string path = graph.empty() ? "" : fs::absolute(graph, error).string();
    const std::string rest =
        std::to_string(edits_ + 1) + '\0' + path + '\0' + refused + '\0' + write_document(document);
    error = replace(hex(checksum(rest)) + "\n" + rest);
    if (!error) ++edits_;
    return error;
}

void RecoveryFile::swap(RecoveryFile& other) noexcept {
    std::swap(handle_, other.handle_);
    file_.swap(other.file_);
    std::swap(edits_, other.edits_);
    std::swap(synced_, other.synced_);
    syncing_.swap(other.syncing_);
}

void RecoveryFile::sync() {
    if (handle_ < 0 || synced_ == edits_ || syncing_->exchange(true)) return;
    synced_ = edits_;
    std::thread([handle = dup(handle_), busy = syncing_] {
        fdatasync(handle);
        ::close(handle);
        *busy = false;
    }).detach();
}

void RecoveryFile::remove() {
    if (handle_ >= 0) unlink(file_.c_str());
    close();
}

void RecoveryFile::close() {
    if (handle_ >= 0) ::close(handle_);
    handle_ = -1;
    edits_ = synced_ = 0;
}

std::optional<Recoverable> read_recovery_file(const fs::path& file) {
    std::string why;
    const auto bytes = read_file(file, why);
    const size_t line = bytes ? bytes->find('\n') : std::string::npos;
    if (line == std::string::npos) return std::nullopt;
    const std::string_view rest = std::string_view(*bytes).substr(line + 1);
    if (bytes->substr(0, line) != hex(checksum(rest))) return std::nullopt;
    const auto parts = split(rest, '\0');
    if (parts.size() < 4) return std::nullopt;
    Recoverable found;
    found.file = file;
    found.edits = std::strtoull(parts[0].data(), nullptr, 10);
    const fs::path path(parts[1]);
    (path.has_filename() ? found.graph : found.folder) = path;
    found.refused = parts[2];
    found.text = rest.substr(static_cast<size_t>(parts[3].data() - rest.data()));
    found.when = stamp_of(file).seconds;
    return found;
}

std::vector<Recoverable> list_recoverable(const fs::path& state_folder) {
    std::vector<Recoverable> all;
    std::error_code error, ignored;
    for (fs::directory_iterator at(state_folder / "journal", error), end; !error && at != end;
         at.increment(error)) {
        const fs::path& file = at->path();
        const bool stray =
            file.extension() == unfinished;  // left by a program killed while it wrote
        if ((!stray && file.extension() != ".journal") || is_in_use(file)) continue;
        auto found = stray ? std::nullopt : read_recovery_file(file);
        if (stray || (found && is_saved(*found)))
            fs::remove(file, ignored);
        else if (found)
            all.push_back(std::move(*found));
    }
    std::ranges::sort(all, std::greater(), &Recoverable::when);
    return all;
}

}  // namespace wrinkle::editor
