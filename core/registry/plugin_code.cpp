#include "registry/plugin_code.h"

#include "base/checksum.h"
#include "base/file.h"
#include "registry/library.h"

namespace wrinkle {

constexpr size_t max_cached_bytes = size_t{64} << 20;  // bytes

PluginCode::PluginCode(PluginFile file, const PluginListing& listing, bool tried,
                       std::chrono::milliseconds limit)
    : file_(std::move(file)),
      listing_(to_json(listing)),
      sha256_(listing.sha256),
      limit_(limit),
      checked_(tried) {}

std::shared_ptr<const std::string> PluginCode::calls(size_t node, std::span<const int32_t> options,
                                                     Unbuilt& reason) {
    const std::lock_guard lock(mutex_);
    Key key(node, {options.begin(), options.end()});
    auto found = runs_.find(key);
    if (found == runs_.end()) {
        reason.remedy = "`wrinkle plugins` says more";
        if (!check(reason.why)) return nullptr;
        BuildRun run = probe_build(file_.path, {node, twice_}, options, limit_);
        reason.why = run.why;
        if (!run.started) return nullptr;
        cached_bytes_ += run.calls ? run.calls->size() : 0;
        if (cached_bytes_ > max_cached_bytes) {
            runs_.clear();
            cached_bytes_ = run.calls ? run.calls->size() : 0;
        }
        found = runs_.emplace(std::move(key), std::move(run)).first;
    }
    if (!found->second.calls) {
        reason.why = found->second.why;
        reason.remedy = "report it to the author of the node";
    }
    return found->second.calls;
}

bool PluginCode::try_out(std::string& why) {
    const std::lock_guard lock(mutex_);
    return check(why);
}

void PluginCode::toggle_second_run() {
    const std::lock_guard lock(mutex_);
    twice_ = !twice_;
    runs_.clear();
    cached_bytes_ = 0;
}

bool PluginCode::check(std::string& why) {
    std::string unread;
    const auto bytes = read_file(file_.path, unread);
    if (!bytes) {
        why = "it " + unread;
    } else if (sha256(*bytes) != sha256_) {
        why = "its file was changed since its nodes were listed";
    } else {
        if (!checked_) why_ = check_nodes();
        checked_ = true;
        why = why_;
    }
    return why.empty();
}

std::string PluginCode::check_nodes() {
    Diagnostics problems;
    const auto listing = probe_plugin(file_.path, sha256_, file_.origin, limit_, problems);
    if (!listing) return sentence_of(problems);
    if (to_json(*listing) == listing_) return {};
    return "its nodes are not those that its manifest lists; "
           "`wrinkle plugins --manifest` writes it again";
}

}  // namespace wrinkle
