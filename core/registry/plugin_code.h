// The code of a plugin that is known by its listing: loaded when a node of it is first lowered, and
// kept until the program ends.
#pragma once

#include <chrono>
#include <ctime>
#include <mutex>
#include <string>
#include <vector>

#include "registry/listing.h"

namespace wrinkle {

class PluginCode {
public:
    using Build = void (*)(const wr_builder*);

    // `tried`: a probe has loaded this very file. Otherwise one does before this process does.
    PluginCode(std::string path, std::string origin, const PluginListing& listing, bool tried,
               std::chrono::milliseconds limit);

    // Of the node of this number in the listing; null, with the reason in `why`, when the file was
    // changed since it was listed, is refused, or has other nodes than its listing says. Safe to
    // call from several threads.
    Build build_of(size_t node, std::string& why);
    // Loads it now; false with the reason in `why`.
    bool load(std::string& why);

private:
    bool load_once(std::string& why);
    std::string take();  // why not, or ""

    std::string path_, origin_, listing_;  // the listing as JSON, to compare
    std::string sha256_;
    bool tried_;
    std::chrono::milliseconds limit_;
    std::mutex mutex_;
    bool loaded_ = false;
    std::string why_;
    std::vector<Build> builds_;
};

}  // namespace wrinkle
