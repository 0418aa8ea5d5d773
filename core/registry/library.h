// The code of a plugin, loaded into this process: that of wrinkle-plugin-probe alone, since loading
// runs code of the plugin, which may do anything.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "registry/listing.h"

namespace wrinkle {

// How far loading has come: "load" the file, "enter" its wrinkle_plugin(), "read" the descriptors.
using OnStage = void (*)(const char* stage);

// The types have build functions, which stay valid until the program ends. Nothing when anything is
// wrong; faults are at `origin`.
std::optional<PluginListing> load_library(const std::string& path, const std::string& origin,
                                          Diagnostics& diagnostics, OnStage on_stage = nullptr);

// How the system's refusal of a file begins.
inline constexpr std::string_view cannot_be_loaded = "it cannot be loaded";

// Of the one that is being handled.
std::string words_of_exception();

// What a plugin says, fit for a diagnostic: one line of at most 4096 bytes, with a blank for each
// character that is not printable (base/printable.h).
std::string plugin_text(std::string_view text);

// "it hung ...; it ...": what is wrong, without the path.
std::string sentence_of(const Diagnostics& problems);

// One fault of a plugin.
void add_fault(Diagnostics& diagnostics, const std::string& origin, std::string message,
               std::string expected = {});

}  // namespace wrinkle
