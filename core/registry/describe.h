// Finds the listing of a plugin file while running as little of its code as possible.
//
// Sources in order: the manifest FILE.so.json in the same folder, if its hash is that of the file;
// the cached result of an earlier probe of the same bytes; a new probe (registry/probe.h), with its
// result written to the cache. A manifest that cannot be read or has another hash is ignored with a
// warning; a damaged cache entry is ignored without a warning.
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
    std::string path;      // file that is read and loaded
    std::string original;  // location, with the manifest; differs from `path` for a copy
    std::string origin;    // name in diagnostics, as given by the user
    std::shared_ptr<const void> owner{};  // owner of the file at `path`
};

struct DescribeOptions {
    std::filesystem::path cache;  // folder of the cache; empty: no cache
    std::chrono::milliseconds limit;
};

// Returns std::nullopt if the plugin is refused.
std::optional<Described> describe_plugin(const PluginFile& file, const DescribeOptions& options,
                                         Diagnostics& diagnostics);

// Reads the listing from the code by a probe; ignores the manifest and the cache.
std::optional<PluginListing> read_from_code(const std::string& path, Diagnostics& diagnostics);

std::string manifest_of(const std::string& path);  // "mine.so.json" of "mine.so"

}  // namespace wrinkle
