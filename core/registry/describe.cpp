#include "registry/describe.h"

#include "base/checksum.h"
#include "base/file.h"
#include "registry/library.h"
#include "registry/probe.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

constexpr const char* manifest_remedy = "`wrinkle plugins --manifest` writes it again";

std::optional<PluginListing> from_manifest(const PluginFile& file, const std::string& hash,
                                           Diagnostics& diagnostics) {
    const std::string name = manifest_of(file.origin), path = manifest_of(file.original);
    const auto ignore = [&](const Location& where, const std::string& why) {
        diagnostics.add({.rule = RuleId::plugin,
                         .severity = Severity::warning,
                         .where = where,
                         .message = "the manifest is ignored: " + why,
                         .expected = manifest_remedy});
        return std::nullopt;
    };
    std::error_code error;
    if (!fs::exists(path, error)) return std::nullopt;
    std::string why;
    auto text = read_file(path, why);
    if (!text) return ignore({name}, "it " + why);
    Diagnostics problems;
    auto listing = read_listing(std::move(*text), name, file.origin, problems);
    if (!listing) return ignore(problems.list().front().where, problems.list().front().message);
    if (listing->sha256 != hash) return ignore({name}, "the plugin was built again since");
    return listing;
}

std::optional<PluginListing> from_cache(const fs::path& file, const std::string& origin,
                                        const std::string& hash) {
    std::string why;
    Diagnostics ignored;
    auto text = read_file(file, why);
    if (!text) return std::nullopt;
    auto listing = read_listing(std::move(*text), file.string(), origin, ignored);
    if (!listing || listing->sha256 != hash) return std::nullopt;
    return listing;
}

// Write errors are ignored: the cache is optional.
void keep(const fs::path& file, const PluginListing& listing) {
    std::error_code error;
    std::string why;
    fs::create_directories(file.parent_path(), error);
    if (!error) write_file(file, to_json(listing), why);
}

// Returns the hash of a file that may be loaded; std::nullopt with a fault otherwise.
std::optional<std::string> hash_of(const PluginFile& file, Diagnostics& diagnostics) {
    std::string why;
    const auto bytes = read_file(file.path, why);
    why = bytes ? elf_fault(*bytes) : "it " + why;
    if (why.empty()) return sha256(*bytes);
    add_fault(diagnostics, file.origin, std::string(cannot_be_loaded) + ": " + why);
    return std::nullopt;
}

}  // namespace

std::string manifest_of(const std::string& path) {
    return path + ".json";
}

std::optional<Described> describe_plugin(const PluginFile& file, const DescribeOptions& options,
                                         Diagnostics& diagnostics) {
    const auto hash = hash_of(file, diagnostics);
    if (!hash) return std::nullopt;
    if (auto listing = from_manifest(file, *hash, diagnostics))
        return Described{std::move(*listing), DescribedBy::manifest};
    const fs::path cached = options.cache.empty() ? fs::path() : options.cache / (*hash + ".json");
    if (!cached.empty())
        if (auto listing = from_cache(cached, file.origin, *hash))
            return Described{std::move(*listing), DescribedBy::cache};
    auto listing = probe_plugin(file.path, *hash, file.origin, options.limit, diagnostics);
    if (!listing) return std::nullopt;
    if (!cached.empty()) keep(cached, *listing);
    return Described{std::move(*listing), DescribedBy::probe};
}

std::optional<PluginListing> read_from_code(const std::string& path, Diagnostics& diagnostics) {
    const auto hash = hash_of({path, path, path, {}}, diagnostics);
    if (!hash) return std::nullopt;
    return probe_plugin(path, *hash, path, probe_limit, diagnostics);
}

}  // namespace wrinkle
