#include "registry/plugin_code.h"

#include "base/file.h"
#include "base/sha256.h"
#include "registry/library.h"
#include "registry/probe.h"

namespace wrinkle {
namespace {

// "it hung ...; it ...": what is wrong, without the path.
std::string sentence(const Diagnostics& problems) {
    std::string text;
    for (const Diagnostic& problem : problems.list())
        text += (text.empty() ? "" : "; ") + problem.message;
    return text;
}

}  // namespace

PluginCode::PluginCode(std::string path, std::string origin, const PluginListing& listing,
                       bool tried, std::chrono::milliseconds limit)
    : path_(std::move(path)),
      origin_(std::move(origin)),
      listing_(to_json(listing)),
      sha256_(listing.sha256),
      tried_(tried),
      limit_(limit) {}

PluginCode::Build PluginCode::build_of(size_t node, std::string& why) {
    const std::lock_guard lock(mutex_);
    if (load_once(why)) return builds_.at(node);
    why = "the plugin " + origin_ + " cannot be used: " + why;
    return nullptr;
}

bool PluginCode::load(std::string& why) {
    const std::lock_guard lock(mutex_);
    return load_once(why);
}

bool PluginCode::load_once(std::string& why) {
    if (!loaded_) why_ = take();
    loaded_ = true;
    why = why_;
    return why_.empty();
}

std::string PluginCode::take() {
    std::string why;
    const auto bytes = read_file(path_, why);
    if (!bytes) return "it " + why;
    if (sha256(*bytes) != sha256_) return "its file was changed since its nodes were listed";
    Diagnostics problems;
    if (!tried_ && !probe_plugin(path_, sha256_, origin_, limit_, problems))
        return sentence(problems);
    auto loaded = load_library(path_, origin_, problems);
    if (!loaded) return sentence(problems);
    loaded->sha256 = sha256_;
    if (to_json(*loaded) != listing_)
        return "its nodes are not those that its manifest lists; "
               "`wrinkle plugins --manifest` writes it anew";
    for (const NodeType& type : loaded->types)
        builds_.push_back(type.build);
    return {};
}

}  // namespace wrinkle
