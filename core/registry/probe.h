// Asks wrinkle-plugin-probe (registry/child.h) what a plugin offers, and what a node's build()
// does: a plugin that crashes, hangs or ends the program does so there.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "registry/listing.h"

namespace wrinkle {

inline constexpr std::chrono::milliseconds probe_limit{5000};

// `sha256` is what the listing says of the file. Nothing when the plugin is refused, with its
// faults at `origin`, each one precise: "it crashed in its wrinkle_plugin(): SIGSEGV
// (Segmentation fault)".
std::optional<PluginListing> probe_plugin(const std::string& path, const std::string& sha256,
                                          const std::string& origin,
                                          std::chrono::milliseconds limit,
                                          Diagnostics& diagnostics);

// What a node's build() did.
struct BuildRun {
    std::shared_ptr<const std::string> calls;  // to be replayed (registry/recording.h); else null,
    std::string why;      // a clause about the plugin: "crashed in build(): SIGSEGV (...)"
    bool started = true;  // false: nothing of the plugin ran, another time it may
};

// A node of the plugin's list; `twice`: build() runs once more, and its second run is recorded.
struct NodeToBuild {
    size_t index = 0;
    bool twice = false;
};

// Runs its build(); `options` by port, 0 where it is none.
BuildRun probe_build(const std::string& path, NodeToBuild node, std::span<const int32_t> options,
                     std::chrono::milliseconds limit);

// Between the two ends. The words are probe_list_word FILE SHA256, or probe_build_word FILE NODE
// TWICE OPTION...; the answer is lines "stage NAME", then one line that is `probe_fine` or
// `probe_refused`, then a listing, recorded calls, or diagnostics as JSON.
inline constexpr std::string_view probe_list_word = "list";
inline constexpr std::string_view probe_build_word = "build";
inline constexpr int probe_output = 3;  // the file descriptor it is written to
inline constexpr std::string_view probe_stage = "stage ";
inline constexpr std::string_view probe_fine = "fine\n";
inline constexpr std::string_view probe_refused = "refused\n";

}  // namespace wrinkle
