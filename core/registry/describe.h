// What a plugin's file offers, found with as little as possible of its code run.
//
// In this order: the manifest beside it, FILE.so.json, when it describes these very bytes; what an
// earlier probe of the same bytes found, from the cache; a probe (registry/probe.h), whose findings
// go to the cache. A manifest of other bytes, or one that cannot be read, is ignored with a
// warning; a damaged entry of the cache without one.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "registry/listing.h"

namespace wrinkle {

enum class DescribedBy : uint8_t { manifest, cache, probe };

struct Described {
    PluginListing listing;
    DescribedBy by = DescribedBy::probe;
};

struct PluginFile {
    std::string path;    // whose bytes are read and loaded
    std::string place;   // where it lies, with its manifest; another than `path` of a copy
    std::string origin;  // what the user calls it
    std::shared_ptr<const void> kept{};  // what `path` needs to be there
};

struct DescribeOptions {
    std::filesystem::path cache;  // a folder; empty: none
    std::chrono::milliseconds limit;
};

// Nothing when the plugin is refused.
std::optional<Described> describe_plugin(const PluginFile& file, const DescribeOptions& options,
                                         Diagnostics& diagnostics);

// From the code, by a probe, whatever manifest or cache say.
std::optional<PluginListing> read_from_code(const std::string& path, Diagnostics& diagnostics);

std::string manifest_of(const std::string& path);  // "mine.so.json" of "mine.so"

}  // namespace wrinkle
