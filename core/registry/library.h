// Loads the code of a plugin into this process. Only wrinkle-plugin-probe may do so, since loading
// runs arbitrary plugin code.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "registry/listing.h"

namespace wrinkle {

// Callback for loading stages: "load" the file, "enter" its wrinkle_plugin(), "read" the
// descriptors.
using OnStage = void (*)(const char* stage);

// The types have build functions, which stay valid until the program ends. Returns std::nullopt on
// any fault; faults are reported at `origin`.
std::optional<PluginListing> load_library(const std::string& path, const std::string& origin,
                                          Diagnostics& diagnostics, OnStage on_stage = nullptr);

// Checks the bytes of a shared object before it is loaded: the dynamic loader may crash on a
// truncated file, and reports one for another machine as "not found". Returns "" if the file may be
// loaded, else the reason: "the file is cut short".
std::string elf_fault(std::string_view bytes);

// First words of a message that the system refused to load a file.
inline constexpr std::string_view cannot_be_loaded = "it cannot be loaded";

// Returns the message of the current exception. Precondition: called in a catch block.
std::string words_of_exception();

// Makes a plugin's text fit for a diagnostic: one line, truncated with "..." after 4096 bytes,
// with a blank for each character that is not printable (base/printable.h).
std::string plugin_text(std::string_view text);

// Joins the messages with "; ", without the path.
std::string sentence_of(const Diagnostics& problems);

// Adds one fault of a plugin.
void add_fault(Diagnostics& diagnostics, const std::string& origin, std::string message,
               std::string expected = {});

}  // namespace wrinkle
