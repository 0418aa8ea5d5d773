// Runs wrinkle-plugin-probe (registry/child.h) to list a plugin's nodes and to record a node's
// build(): a plugin that crashes, hangs or exits does so in that process.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "registry/listing.h"

namespace wrinkle {

inline constexpr std::chrono::milliseconds probe_limit{5000};

// Lists the nodes of the plugin at `path`. `sha256`, the hash of the file, is stored in the result.
// Returns std::nullopt if the plugin is refused, and reports the reason at `origin`: "it crashed in
// its wrinkle_plugin(): SIGSEGV (Segmentation fault)".
std::optional<PluginListing> probe_plugin(const std::string& path, const std::string& sha256,
                                          const std::string& origin,
                                          std::chrono::milliseconds limit,
                                          Diagnostics& diagnostics);

// Result of one run of a node's build().
struct BuildRun {
    std::shared_ptr<const std::string> calls;  // for replay (registry/recording.h); null on failure
    std::string why;      // a clause about the plugin: "crashed in build(): SIGSEGV (...)"
    bool started = true;  // false: no plugin code ran; a retry may succeed
};

// A node of the listing; `twice`: build() runs twice in the process and the second run is recorded.
struct NodeToBuild {
    size_t index = 0;
    bool twice = false;
};

// Runs build() of the node; `options` by port, 0 for ports that are not options.
BuildRun probe_build(const std::string& path, NodeToBuild node, std::span<const int32_t> options,
                     std::chrono::milliseconds limit);

// Protocol. Arguments: probe_list_word FILE SHA256, or probe_build_word FILE NODE TWICE OPTION...
// Output: a line "stage NAME" before each stage, so that a crash is reported with its stage; then
// one line `probe_fine` or `probe_refused`, then a listing, recorded calls, or diagnostics as JSON.
inline constexpr std::string_view probe_list_word = "list";
inline constexpr std::string_view probe_build_word = "build";
inline constexpr int probe_output = 3;  // file descriptor of the output
inline constexpr std::string_view probe_stage = "stage ";
inline constexpr std::string_view probe_fine = "fine\n";
inline constexpr std::string_view probe_refused = "refused\n";

}  // namespace wrinkle
