// Reads what a plugin offers in a process of its own, wrinkle-plugin-probe: a plugin that crashes,
// hangs or ends the program while it is loaded does so there.
//
// The process is ended with all that it started when it takes longer than the limit. Its standard
// input and outputs are /dev/null.
#pragma once

#include <chrono>
#include <optional>
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

// What the probe says, for its two ends: lines "stage NAME", then one line that is `probe_fine` or
// `probe_refused`, then a listing or diagnostics as JSON.
inline constexpr int probe_output = 3;  // the file descriptor it is written to
inline constexpr std::string_view probe_stage = "stage ";
inline constexpr std::string_view probe_fine = "fine\n";
inline constexpr std::string_view probe_refused = "refused\n";

}  // namespace wrinkle
