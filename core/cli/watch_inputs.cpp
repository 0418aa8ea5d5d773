#include "cli/watch_inputs.h"

#include <chrono>

#include "base/temporary.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

// File systems store dates in steps of a few milliseconds, some of two seconds.
bool is_recent(const Stamp& stamp) {
    using namespace std::chrono;
    const nanoseconds written = seconds(stamp.seconds) + nanoseconds(stamp.nanoseconds);
    const nanoseconds step = stamp.nanoseconds == 0 ? nanoseconds(2s) : nanoseconds(20ms);
    return stamp.there && system_clock::now().time_since_epoch() < written + step;
}

std::set<fs::path> outputs_of(const FileLog& log) {
    std::set<fs::path> outputs;
    for (const fs::path& path : log.outputs)
        outputs.insert(fs::absolute(path).lexically_normal());
    return outputs;
}

bool is_of_the_system(const fs::path& file) {
    return file.native().starts_with("/proc/") || file.native().starts_with("/sys/");
}

}  // namespace

void WatchedInputs::set(const FileLog& log, bool succeeded) {
    const std::set<fs::path> outputs = outputs_of(log);
    std::map<fs::path, Known> known;
    for (const FileLog::Input& input : log.inputs) {
        const fs::path file = fs::absolute(input.path);
        if (is_of_the_system(file) || outputs.contains(file.lexically_normal()) ||
            Temporary::is_name(file.filename().native()))
            continue;
        const auto before = known_.find(file);
        if (before != known_.end() && before->second.copy.stamp == input.stamp)
            known.insert(*before);
        else
            known.try_emplace(file, Known{{input.stamp, 0}});
    }
    if (!succeeded) known.merge(known_);
    known_ = std::move(known);
}

WatchedInputs::Known WatchedInputs::read_now(const fs::path& file) {
    const DiskCopy copy = DiskCopy::of(file);
    return {copy, cli::is_recent(copy.stamp), true};
}

bool WatchedInputs::read() {
    bool changed = false;
    for (auto& [file, known] : known_) {
        if (known.is_read) continue;
        const Stamp opened = known.copy.stamp;
        known = read_now(file);
        changed |= known.copy.stamp != opened;
    }
    return changed;
}

bool WatchedInputs::changed() {
    bool changed = false;
    for (auto& [file, known] : known_) {
        DiskCopy copy = known.copy;
        if (known.is_recent) copy.stamp.size = ~copy.stamp.size;  // compares the contents
        if (compare(copy, file) == OnDisk::same) {
            known.copy = copy;
            known.is_recent = known.is_recent && cli::is_recent(copy.stamp);
        } else {
            changed = true;
            known = read_now(file);
        }
    }
    return changed;
}

std::set<fs::path> WatchedInputs::files() const {
    std::set<fs::path> files;
    for (const auto& [file, ignored] : known_)
        files.insert(file);
    return files;
}

}  // namespace wrinkle::cli
