// The code of a plugin, taken into this process; for core/registry alone.
//
// What can be wrong with it is tried out in a process of its own first (registry/probe.h): loading
// runs code of the plugin, which may do anything.
#pragma once

#include <optional>
#include <string>

#include "registry/listing.h"

namespace wrinkle {

// How far loading has come: "load" the file, "enter" its wrinkle_plugin(), "read" the descriptors.
using OnStage = void (*)(const char* stage);

// The types have build functions, which stay valid until the program ends. Nothing, and the code is
// gone again, when anything is wrong; faults are at `origin`.
std::optional<PluginListing> load_library(const std::string& path, const std::string& origin,
                                          Diagnostics& diagnostics, OnStage on_stage = nullptr);

// How the system's refusal of a file begins.
inline constexpr std::string_view cannot_be_loaded = "it cannot be loaded";

// Of the one that is being handled.
std::string words_of_exception();

// One fault of a plugin.
void add_fault(Diagnostics& diagnostics, const std::string& origin, std::string message,
               std::string expected = {});

}  // namespace wrinkle
