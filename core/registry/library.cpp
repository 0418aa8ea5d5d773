#include "registry/library.h"

#include <dlfcn.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iterator>

#include "base/text.h"
#include "registry/descriptor.h"

namespace wrinkle {
namespace {

constexpr const char* entry_symbol = "wrinkle_plugin";

// dlerror() begins with the path, which the report names already.
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
                  "it is no plugin of Wrinkle: it does not export wrinkle_plugin",
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

size_t utf8_size(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte < 0x80 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

// One character of well-formed UTF-8.
bool is_unprintable(std::string_view character) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(character[i]); };
    if (character.size() == 1) return byte(0) < 0x20 || byte(0) == 0x7F;
    if (character.size() == 2)  // C1 controls, U+061C
        return (byte(0) == 0xC2 && byte(1) < 0xA0) || character == "\u061C";
    static constexpr std::string_view marks[] = {"\u200E", "\u200F", "\u2028", "\u2029", "\u202A",
                                                 "\u202B", "\u202C", "\u202D", "\u202E", "\u2066",
                                                 "\u2067", "\u2068", "\u2069"};
    return std::find(std::begin(marks), std::end(marks), character) != std::end(marks);
}

}  // namespace

std::string plugin_text(std::string_view text) {
    constexpr size_t longest = 4096;
    if (!is_utf8(text)) return "(a text that is not valid UTF-8)";
    std::string line;
    for (size_t at = 0; at < text.size();) {
        const size_t size = utf8_size(text[at]);
        if (line.size() + size > longest) return line + "...";
        const std::string_view character = text.substr(at, size);
        line += is_unprintable(character) ? " " : character;
        at += size;
    }
    return line;
}

std::string sentence_of(const Diagnostics& problems) {
    std::string text;
    for (const Diagnostic& problem : problems.list())
        text += (text.empty() ? "" : "; ") + problem.message;
    return text;
}

std::string words_of_exception() {
    try {
        std::rethrow_exception(std::current_exception());
    } catch (const std::exception& problem) {
        return problem.what();
    } catch (...) {
        return "something that is no std::exception";
    }
}

void add_fault(Diagnostics& diagnostics, const std::string& origin, std::string message,
               std::string expected) {
    Diagnostic diagnostic;
    diagnostic.where.file = origin;
    diagnostic.message = std::move(message);
    diagnostic.expected = std::move(expected);
    diagnostics.add(std::move(diagnostic));
}

std::optional<PluginListing> load_library(const std::string& path, const std::string& origin,
                                          Diagnostics& diagnostics, OnStage on_stage) {
    if (!on_stage) on_stage = [](const char*) {};
    on_stage("load");
    // A name without a slash would be searched for among the system's libraries.
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
