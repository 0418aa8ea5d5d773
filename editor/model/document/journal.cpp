#include "editor/model/document/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <thread>

#include "base/file.h"
#include "base/text.h"
#include "editor/model/document/text_delta.h"
#include "editor/model/document/watch.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

std::error_code last_error() {
    return {errno, std::generic_category()};
}

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

struct Record {
    std::string_view kind, payload;
};

uint64_t chained(uint64_t sum, std::string_view payload) {
    return checksum(payload) * 31 + sum;
}

template <class Number>
bool read_number(std::string_view text, Number& number, int base) {
    const auto end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number, base);
    return error == std::errc() && stop == end;
}

// Takes the first record; returns std::nullopt if the rest is truncated or damaged.
std::optional<Record> take_record(std::string_view& bytes, uint64_t& last) {
    const size_t line = bytes.find('\n');
    if (line == bytes.npos || line > 100) return std::nullopt;
    const auto words = split(bytes.substr(0, line), ' ');
    Record record;
    size_t length = 0;
    uint64_t sum = 0;
    if (words.size() != 3 || !read_number(words[1], length, 10) ||
        !read_number(words[2], sum, 16) || length >= bytes.size() - line - 1)
        return std::nullopt;
    record.kind = words[0];
    record.payload = bytes.substr(line + 1, length);
    last = chained(last, record.payload);
    if (last != sum || bytes[line + 1 + length] != '\n') return std::nullopt;
    bytes.remove_prefix(line + length + 2);
    return record;
}

bool read_graph(std::string_view payload, Recoverable& found) {
    const size_t first = payload.find('\0');
    const size_t second = first == payload.npos ? first : payload.find('\0', first + 1);
    if (second == payload.npos) return false;
    const fs::path path(payload.substr(0, first));
    (path.has_filename() ? found.graph : found.folder) = path;
    found.refused = payload.substr(first + 1, second - first - 1);
    found.text = payload.substr(second + 1);
    return true;
}

// Returns true if a running program holds the lock; the system releases it when the program exits.
bool is_in_use(const fs::path& file) {
    const int handle = open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (handle < 0) return true;
    const bool locked = flock(handle, LOCK_EX | LOCK_NB) != 0;
    close(handle);
    return locked;
}

bool is_saved(const Recoverable& found) {
    std::string why;
    if (found.graph.empty()) return false;
    const auto bytes = read_file(found.graph, why);
    return bytes && *bytes == found.text;
}

}  // namespace

std::error_code Journal::create(const fs::path& state_folder) {
    const fs::path folder = state_folder / "journal";
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return error;
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const auto stamp = std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
    file_ = folder / (std::to_string(getpid()) + "-" + std::to_string(stamp) + ".journal");
    handle_ = open(file_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0600);
    if (handle_ < 0) return last_error();
    size_ = 0;
    if (flock(handle_, LOCK_EX | LOCK_NB) == 0) return {};
    error = last_error();
    drop();
    return error;
}

std::error_code Journal::append(std::string_view kind, std::string_view payload) {
    const uint64_t sum = chained(sum_, payload);
    std::string record =
        std::string(kind) + " " + std::to_string(payload.size()) + " " + hex(sum) + "\n";
    record += payload;
    record += '\n';
    const std::error_code error = write_all(handle_, record);
    if (!error) {
        size_ += record.size();
        sum_ = sum;
    } else if (ftruncate(handle_, static_cast<off_t>(size_)) != 0) {
        close();  // a partial record remains at the end
    }
    return error;
}

std::error_code Journal::keep(const fs::path& state_folder, const fs::path& graph,
                              const std::string& refused, const Document& document) {
    std::error_code error;
    JournaledText after;
    if (handle_ < 0) {
        error = create(state_folder);
        if (error) return error;
        std::string text;
        after = JournaledText(document, text);
        std::string payload = graph.empty() ? "" : fs::absolute(graph, error).string();
        payload += '\0' + refused + '\0' + text;
        error = append("graph", payload);
        if (error) drop();
    } else {
        std::string delta;
        after = text_.next(document, delta);
        error = append("edit", delta);
    }
    if (!error) text_ = std::move(after);
    return error;
}

void Journal::swap(Journal& other) noexcept {
    std::swap(handle_, other.handle_);
    file_.swap(other.file_);
    std::swap(text_, other.text_);
    std::swap(sum_, other.sum_);
    std::swap(size_, other.size_);
    std::swap(synced_, other.synced_);
    syncing_.swap(other.syncing_);
}

void Journal::sync() {
    if (handle_ < 0 || synced_ == size_ || syncing_->exchange(true)) return;
    synced_ = size_;
    std::thread([handle = dup(handle_), busy = syncing_] {
        fdatasync(handle);
        ::close(handle);
        *busy = false;
    }).detach();
}

void Journal::drop() {
    if (handle_ >= 0) unlink(file_.c_str());
    close();
}

void Journal::close() {
    if (handle_ >= 0) ::close(handle_);
    handle_ = -1;
    text_ = {};
    sum_ = size_ = synced_ = 0;
}

std::optional<Recoverable> read_journal(const fs::path& file) {
    std::string why;
    const auto bytes = read_file(file, why);
    if (!bytes) return std::nullopt;
    std::string_view rest = *bytes;
    Recoverable found;
    uint64_t sum = 0;
    const auto first = take_record(rest, sum);
    if (!first || first->kind != "graph" || !read_graph(first->payload, found)) return std::nullopt;
    found.journal = file;
    found.edits = 1;
    while (const auto record = take_record(rest, sum)) {
        auto text = apply_text_delta(found.text, record->payload);
        if (record->kind != "edit" || !text) break;
        found.text = std::move(*text);
        ++found.edits;
    }
    found.when = stamp_of(file).seconds;
    return found;
}

std::vector<Recoverable> list_recoverable(const fs::path& state_folder) {
    std::vector<Recoverable> all;
    std::error_code error;
    for (fs::directory_iterator at(state_folder / "journal", error), end; !error && at != end;
         at.increment(error)) {
        if (at->path().extension() != ".journal" || is_in_use(at->path())) continue;
        auto found = read_journal(at->path());
        if (!found) continue;
        std::error_code ignored;
        if (is_saved(*found))
            fs::remove(at->path(), ignored);
        else
            all.push_back(std::move(*found));
    }
    std::sort(all.begin(), all.end(),
              [](const Recoverable& a, const Recoverable& b) { return a.when > b.when; });
    return all;
}

}  // namespace wrinkle::editor
