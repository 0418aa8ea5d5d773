#include "base/file_log.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <set>
#include <sstream>
#include <string>

#include "base/file.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

int log_descriptor = -1;  // set before threads start

enum Record : char { input = 'i', output = 'o', replaced = 'r' };

// A record is one write, so those of several threads do not mix.
void log_record(Record kind, const fs::path& file, const Stamp& stamp) {
    if (file.native().find('\0') != std::string::npos) return;
    std::ostringstream text;
    text << char{kind} << ' ' << stamp.there << ' ' << stamp.seconds << ' ' << stamp.nanoseconds
         << ' ' << stamp.size << ' ' << stamp.inode << ' ' << file.native() << '\0';
    const std::string record = text.str();
    while (write(log_descriptor, record.data(), record.size()) < 0 && errno == EINTR) {
    }
}

bool is_temporary(const fs::path& file) {
    return std::ranges::any_of(
        file, [](const fs::path& step) { return Temporary::is_name(step.native()); });
}

}  // namespace

void start_file_log(int descriptor) {
    log_descriptor = descriptor;
}

void log_input(const fs::path& file) {
    if (log_descriptor >= 0) log_record(input, file, stamp_of(file));
}

void log_output(const fs::path& file) {
    if (log_descriptor >= 0) log_record(output, file, {});
}

void log_replaced(const fs::path& file) {
    if (log_descriptor >= 0) log_record(replaced, file, {});
}

std::vector<fs::path> FileLog::distinct_outputs() const {
    std::vector<fs::path> made;
    std::set<fs::path> seen;
    for (const fs::path& file : outputs)
        if (seen.insert(real_path(file)).second) made.push_back(file);
    return made;
}

std::string bytes_of_descriptor(int descriptor) {
    std::string bytes;
    char block[1 << 14];
    ssize_t count = 0;
    while ((count = pread(descriptor, block, sizeof block, static_cast<off_t>(bytes.size()))) > 0)
        bytes.append(block, static_cast<size_t>(count));
    return bytes;
}

FileLog read_file_log(int descriptor) {
    const std::string bytes = bytes_of_descriptor(descriptor);
    FileLog log;
    for (size_t at = 0, end = 0; (end = bytes.find('\0', at)) != std::string::npos; at = end + 1) {
        std::istringstream record(bytes.substr(at, end - at));
        char kind = 0;
        Stamp stamp;
        record >> kind >> stamp.there >> stamp.seconds >> stamp.nanoseconds >> stamp.size >>
            stamp.inode;
        record.ignore(1);
        std::string path;
        std::getline(record, path, '\0');
        if (is_temporary(path)) continue;
        if (kind == input) log.inputs.push_back({path, stamp});
        if (kind == output) log.outputs.emplace_back(path);
        if (kind == replaced) log.replaced.emplace_back(path);
    }
    return log;
}

}  // namespace wrinkle
