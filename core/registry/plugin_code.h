// The code of a plugin that is known by its listing. It runs in processes of its own alone
// (registry/probe.h): build() of a node once for each set of options, whatever graphs use it.
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
    // `tried`: a probe has loaded this very file. Otherwise one does before its code is used.
    PluginCode(PluginFile file, const PluginListing& listing, bool tried,
               std::chrono::milliseconds limit);

    // The calls of build() of the node of this number in the listing, with these options by port.
    // Null, with the reason, when the code did not come to the end of build(), or when the file was
    // changed since it was listed, is refused, or has other nodes than its listing says. Safe to
    // call from several threads.
    std::shared_ptr<const std::string> calls(size_t node, std::span<const int32_t> options,
                                             Unbuilt& reason);
    // Whether the file has the nodes of its listing; false with the reason in `why`.
    bool try_out(std::string& why);
    // The next calls() runs build() again: where it ran once in its process it runs twice, and the
    // calls are those of the second time. So they differ when build() keeps state.
    void build_again();

private:
    using Key = std::pair<size_t, std::vector<int32_t>>;

    bool check(std::string& why);
    std::string check_nodes();  // why not, or ""

    PluginFile file_;
    std::string listing_;  // as JSON, to compare
    std::string sha256_;
    std::chrono::milliseconds limit_;
    std::mutex mutex_;
    bool checked_;
    std::string why_;  // of the check
    std::map<Key, BuildRun> runs_;
    size_t kept_ = 0;  // bytes in runs_
    bool twice_ = false;
};

}  // namespace wrinkle
