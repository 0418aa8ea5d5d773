// Capabilities of each writable image format.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "image/writer.h"

namespace wrinkle {

// Lists are words separated by spaces.
struct Writable {
    const char* extensions;
    const char* plugin;  // OpenImageIO's name
    const char* types;
    const char* channels;  // "": any number
    const char* compressions;
    const char* compression;  // the default
    bool tiles;
    bool mips;
    bool numbers;
};

const Writable* format_to_write(const std::filesystem::path& path);  // by the extension; or null

// Returns true if files of this plugin can store ImageNumbers; others need not be opened for one.
bool plugin_keeps_numbers(std::string_view plugin);

struct WriteProblem {
    std::string message;  // "" when there is none
    std::string expected;
};

// Returns the reason why a file of this format cannot be written with the options.
WriteProblem find_write_problem(const Writable* format, const WriterOptions& options);

}  // namespace wrinkle
