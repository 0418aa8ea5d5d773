// Builder calls of a plugin with a known listing. Its code runs only in separate processes
// (registry/probe.h): build() of a node runs once for each set of options, and its calls are cached
// for all graphs, up to 64 MiB.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "registry/describe.h"
#include "registry/probe.h"

namespace wrinkle {

class PluginCode {
public:
    // `tried`: a probe has already loaded this file. Otherwise one does before the first use.
    PluginCode(PluginFile file, const PluginListing& listing, bool tried,
               std::chrono::milliseconds limit);

    // Returns the calls of build() of the node with this index in the listing, with these options
    // by port. Returns null and sets `reason` if build() did not complete, or if the file changed
    // since it was listed, is refused, or its nodes differ from its listing. Thread-safe.
    std::shared_ptr<const std::string> calls(size_t node, std::span<const int32_t> options,
                                             Unbuilt& reason);
    // Returns true if the file is unchanged and has the nodes of its listing; false with the reason
    // in `why` otherwise.
    bool try_out(std::string& why);
    // Clears the cache and toggles between one and two runs of build() per process. With two, the
    // calls are those of the second run, so the next calls() differ if build() has state. Runs no
    // code itself.
    void toggle_second_run();

private:
    using Key = std::pair<size_t, std::vector<int32_t>>;

    bool check(std::string& why);
    std::string check_nodes();  // reason, or ""

    PluginFile file_;
    std::string listing_;  // as JSON, for comparison
    std::string sha256_;
    std::chrono::milliseconds limit_;
    std::mutex mutex_;
    bool checked_;
    std::string why_;  // result of check_nodes()
    std::map<Key, BuildRun> runs_;
    size_t cached_bytes_ = 0;  // bytes in runs_
    bool twice_ = false;
};

}  // namespace wrinkle
