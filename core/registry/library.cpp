#include "registry/library.h"

#include <dlfcn.h>

#include <algorithm>
#include <exception>
#include <filesystem>

#include "base/printable.h"
#include "base/text.h"
#include "registry/listing.h"
#include "wrinkle/plugin.h"

namespace wrinkle {
namespace {

constexpr const char* entry_symbol = "wrinkle_plugin";

// dlerror() begins with the path, which the report already names.
std::string last_error(const std::string& path) {
    const char* text = dlerror();
    const std::string reason = text ? text : "unknown reason";
    const std::string prefix = path + ": ";
    return reason.starts_with(prefix) ? reason.substr(prefix.size()) : reason;
}

const wr_plugin* enter(void* library, const std::string& origin, Diagnostics& diagnostics,
                       OnStage on_stage) {
    const auto entry = reinterpret_cast<wr_plugin_entry>(dlsym(library, entry_symbol));
    if (!entry) {
        add_fault(diagnostics, origin,
                  "it is not a plugin of Wrinkle: it does not export wrinkle_plugin",
                  "end it with WRINKLE_PLUGIN(\"id\", \"version\", nodes...), in C with "
                  "WR_EXPORT const wr_plugin* wrinkle_plugin(void)");
        return nullptr;
    }
    on_stage("enter");
    const wr_plugin* plugin = nullptr;
    try {
        plugin = entry();
        if (!plugin) add_fault(diagnostics, origin, "its wrinkle_plugin() returned null");
    } catch (...) {
        add_fault(diagnostics, origin,
                  "its wrinkle_plugin() threw an exception: " + words_of_exception());
    }
    return plugin;
}

}  // namespace

std::string plugin_text(std::string_view text) {
    constexpr size_t longest = 4096;
    std::string line;
    while (!text.empty()) {
        const Character character = first_character(text);
        if (line.size() + character.bytes > longest) return line + "...";
        line += is_printable(character) ? text.substr(0, character.bytes) : " ";
        text.remove_prefix(character.bytes);
    }
    return line;
}

std::string sentence_of(const Diagnostics& problems) {
    return joined(problems.list(), "; ", [](const Diagnostic& each) { return each.message; });
}

std::string words_of_exception() {
    try {
        std::rethrow_exception(std::current_exception());
    } catch (const std::exception& problem) {
        return problem.what();
    } catch (...) {
        return "something other than a std::exception";
    }
}

void add_fault(Diagnostics& diagnostics, const std::string& origin, std::string message,
               std::string expected) {
    diagnostics.add(file_problem(Severity::error, RuleId::plugin, origin, std::move(message),
                                 std::move(expected)));
}

std::optional<PluginListing> load_library(const std::string& path, const std::string& origin,
                                          Diagnostics& diagnostics, OnStage on_stage) {
    if (!on_stage) on_stage = [](const char*) {};
    on_stage("load");
    // dlopen() searches the system's libraries for a name without a slash.
    const std::string file = std::filesystem::absolute(path).string();
    void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) {
        add_fault(diagnostics, origin, std::string(cannot_be_loaded) + ": " + last_error(path));
        return std::nullopt;
    }
    PluginListing listing;
    const wr_plugin* plugin = enter(library, origin, diagnostics, on_stage);
    if (plugin) on_stage("read");
    if (!plugin || !read_descriptors(plugin, origin, listing.types, diagnostics)) {
        dlclose(library);
        return std::nullopt;
    }
    listing.id = plugin->id;
    listing.version = plugin->version;
    return listing;
}

}  // namespace wrinkle
