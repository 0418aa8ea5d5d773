#include "layout/rules.h"

#include <algorithm>
#include <map>
#include <set>

namespace wrinkle::layout {
namespace {

using Names = std::set<std::string, std::less<>>;

// Allowed includes of each folder in addition to the standard library and its own headers. "sdk" is
// the complete plugin author's interface, "contract" only its C header; "library" is the header of
// programs that embed Wrinkle.
const std::map<std::string, Names, std::less<>> allowed = {
    {"core/allocator", {"mimalloc"}},
    {"core/base", {"nettle", "xxhash"}},
    {"core/json", {"base", "nlohmann"}},
    {"core/materialx", {"base", "pugixml"}},
    {"core/sdk", {"sdk"}},
    {"core/ir", {"base", "contract"}},
    {"core/graph", {"base", "json"}},
    {"core/registry", {"base", "json", "contract"}},
    {"core/lower", {"base", "json", "ir", "graph", "registry", "contract"}},
    {"core/emit", {"base", "ir", "contract"}},
    {"core/spirv", {"base", "ir", "emit", "contract", "glslang", "spirv tools"}},
    {"core/cpu", {"base", "ir", "image", "contract"}},
    {"core/image", {"base", "oiio", "openexr", "libdeflate", "png", "tbb", "zlib"}},
    {"core/maps", {"base", "image", "tbb", "kissfft"}},
    {"core/report", {"base", "json", "image", "tbb"}},
    {"core/difference", {"base", "json", "graph"}},
    {"core/import", {"base", "json", "materialx", "graph", "image", "maps"}},
    {"core/export",
     {"ir", "contract", "base", "json", "graph", "registry", "lower", "emit", "compile", "cpu",
      "image", "mesh", "bake", "glm", "materialx"}},
    {"core/mesh", {"base", "glm", "mesh files"}},
    {"core/gpu", {"base", "emit", "ir", "image", "mesh", "contract", "glm", "gl", "tbb"}},
    {"core/bake", {"base", "ir", "cpu", "image", "mesh", "glm", "tbb"}},
    {"core/certify",
     {"base", "ir", "graph", "registry", "lower", "emit", "cpu", "image", "gpu", "contract"}},
    {"core/cost", {"base", "ir", "emit", "spirv"}},
    {"core/compile",
     {"base", "ir", "graph", "registry", "lower", "emit", "spirv", "cpu", "image", "cost"}},
    {"core/api",
     {"base", "graph", "registry", "lower", "emit", "cpu", "compile", "export", "mesh", "library",
      "list of nodes"}},
    {"core/cli",
     {"base",      "json",          "ir",      "graph",  "registry", "lower",      "emit",
      "spirv",     "cpu",           "image",   "mesh",   "maps",     "gpu",        "bake",
      "certify",   "cost",          "compile", "import", "report",   "difference", "export",
      "materialx", "list of nodes", "cli11",   "glm",    "tbb",      "contract"}},
    {"core/serve", {"base", "httplib"}},
    {"nodes", {"sdk", "base"}},
    {"plugins", {"sdk"}},
    {"editor/model", {"base",  "json",   "ir",      "graph", "registry", "lower",        "emit",
                      "spirv", "cpu",    "image",   "mesh",  "maps",     "import",       "bake",
                      "cost",  "export", "compile", "glm",   "contract", "list of nodes"}},
    {"editor/view",
     {"base", "json", "ir", "graph", "registry", "lower", "emit", "cpu", "image", "mesh", "maps",
      "gpu", "export", "bake", "contract", "editor/model", "glm", "gl", "imgui"}},
    {"editor/app",
     {"base", "json", "graph", "registry", "image", "gpu", "editor/model", "editor/view", "gl",
      "imgui", "cli11"}},
};

// Libraries by the spelling of their headers.
const std::map<std::string, std::string, std::less<>> library_of_folder = {
    {"nlohmann", "nlohmann"},
    {"OpenImageIO", "oiio"},
    {"OpenEXR", "openexr"},
    {"Imath", "openexr"},
    {"glm", "glm"},
    {"epoxy", "gl"},
    {"GL", "gl"},
    {"EGL", "gl"},
    {"GLES3", "gl"},
    {"GLFW", "imgui"},
    {"imgui", "imgui"},
    {"backends", "imgui"},
    {"CLI", "cli11"},
    {"tbb", "tbb"},
    {"oneapi", "tbb"},
    {"glslang", "glslang"},
    {"spirv-tools", "spirv tools"},
    {"spirv_cross", "spirv tools"},
    {"sys", ""},
    {"sanitizer", ""},
};
const Names system_headers = {"dlfcn.h",   "elf.h",     "errno.h",  "fcntl.h",     "link.h",
                              "poll.h",    "pthread.h", "sched.h",  "signal.h",    "stdint.h",
                              "stdbool.h", "stddef.h",  "unistd.h", "spawn.h",     "termios.h",
                              "stdio.h",   "stdlib.h",  "string.h", "immintrin.h", "fnmatch.h"};

constexpr std::string_view core_prefix = "core/", editor_prefix = "editor/";

template <class Visit>
void for_each_line(std::string_view text, Visit visit) {
    size_t number = 0;
    while (!text.empty()) {
        const size_t end = std::min(text.find('\n'), text.size());
        visit(++number, text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

std::string at(const Source& source, size_t line, const std::string& message) {
    return source.path + ":" + std::to_string(line) + ": " + message;
}

struct Include {
    bool quoted = false;
    std::string_view path;
};

// Returns an empty path if the line is not an #include.
Include include_of(std::string_view line) {
    const auto skip = [&] {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    };
    skip();
    if (!line.starts_with('#')) return {};
    line.remove_prefix(1);
    skip();
    constexpr std::string_view word = "include";
    if (!line.starts_with(word)) return {};
    line.remove_prefix(word.size());
    skip();
    if (!line.starts_with('"') && !line.starts_with('<')) return {};
    const bool quoted = line[0] == '"';
    const size_t end = line.find(quoted ? '"' : '>', 1);
    return {quoted, line.substr(1, std::min(end, line.size()) - 1)};
}

std::string library_of_file(std::string_view path) {
    if (path.starts_with("imgui")) return "imgui";
    if (path == "kissfft.hh") return "kissfft";
    if (path == "libdeflate.h") return "libdeflate";
    if (path == "png.h") return "png";
    if (path == "zlib.h") return "zlib";
    if (path == "httplib.h") return "httplib";
    if (path == "xxhash.h") return "xxhash";
    if (path == "mimalloc.h") return "mimalloc";
    if (path == "pugixml.hpp") return "pugixml";
    if (path.starts_with("tiny_gltf") || path.starts_with("tiny_obj")) return "mesh files";
    if (path.find('.') == path.npos || system_headers.contains(path)) return {};
    return std::string(path);
}

// Name in the table for an #include; empty if every folder may include it.
std::string wanted_by(const Include& include, std::string_view folder) {
    const size_t slash = include.path.find('/');
    if (slash == include.path.npos)
        return include.quoted ? std::string() : library_of_file(include.path);
    const std::string_view first = include.path.substr(0, slash);
    if (include.path == "wrinkle/plugin.h")
        return allowed.at(std::string(folder)).contains("sdk") ? "sdk" : "contract";
    if (include.path.starts_with("wrinkle/wrinkle.h")) return "library";
    if (first == "wrinkle") return "sdk";
    const std::string named = folder_of(include.path);
    if (named == folder || (folder.starts_with(core_prefix) && first == folder.substr(5)))
        return {};
    if (named.starts_with(editor_prefix)) return named;
    if (first == "nodes") return include.path == "nodes/all.h" ? "list of nodes" : "nodes";
    if (const auto library = library_of_folder.find(first); library != library_of_folder.end())
        return library->second;
    return std::string(first);
}

size_t columns(std::string_view line) {
    return static_cast<size_t>(std::count_if(line.begin(), line.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    }));
}

bool opens_definition(std::string_view line) {
    constexpr std::string_view none = " \t}#/)";
    return !line.empty() && none.find(line[0]) == none.npos && !line.ends_with(':');
}

// The labels of a switch are a table: one row per op or type.
bool is_label(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    const bool label = line.starts_with("case ") || line.starts_with("default:");
    return (label && line.ends_with(':')) || line == "break;";
}

// Detects lines of data, visited in order: lines between `clang-format off` and `on`, and lines in
// raw strings.
class Data {
public:
    bool holds(std::string_view line) {
        if (line.find("clang-format off") != line.npos) table_ = true;
        if (line.find("clang-format on") != line.npos) table_ = false;
        return in_raw_string(line) || table_;
    }

    // Returns true if part of the line is inside a raw string; call exactly once per line.
    bool in_raw_string(std::string_view line) {
        bool raw = !end_.empty();
        for (size_t from = 0; from < line.size();) {
            const std::string wanted = end_.empty() ? "R\"" : end_;
            from = line.find(wanted, from);
            if (from == line.npos) break;
            from += wanted.size();
            raw = true;
            const size_t open = line.find('(', from);
            const bool begins = end_.empty() && open != line.npos;
            end_ = begins ? ")" + std::string(line.substr(from, open - from)) + "\"" : "";
        }
        return raw;
    }

private:
    bool table_ = false;
    std::string end_;  // terminator of the open raw string
};

}  // namespace

std::string folder_of(std::string_view path) {
    const size_t from = path.starts_with(core_prefix)     ? core_prefix.size()
                        : path.starts_with(editor_prefix) ? editor_prefix.size()
                                                          : 0;
    return std::string(path.substr(0, path.find('/', from)));
}

std::vector<std::string> include_violations(const Source& source) {
    const std::string folder = folder_of(source.path);
    if (folder == "tests") return {};
    const auto row = allowed.find(folder);
    if (row == allowed.end()) return {at(source, 1, "the table has no folder '" + folder + "'")};
    std::vector<std::string> found;
    Data data;
    for_each_line(source.text, [&](size_t number, std::string_view line) {
        const Include include = include_of(line);
        if (data.in_raw_string(line) || include.path.empty()) return;
        const std::string wanted = wanted_by(include, folder);
        if (wanted.empty() || row->second.contains(wanted)) return;
        found.push_back(
            at(source, number, folder + " may not include '" + std::string(include.path) + "'"));
    });
    return found;
}

std::vector<std::string> column_violations(const Source& source) {
    std::vector<std::string> found;
    Data data;
    for_each_line(source.text, [&](size_t number, std::string_view line) {
        const size_t start = std::min(line.find_first_not_of(" /"), line.size());
        const bool breakable = line.find(' ', start) != line.npos;
        if (!data.holds(line) && breakable && columns(line) > max_columns)
            found.push_back(at(source, number, std::to_string(columns(line)) + " columns"));
    });
    return found;
}

// A definition begins at the last line that starts in column 1 and ends with a '}' on its own line
// in column 1; classes end with "};" and namespaces with a comment, so only functions match.
std::vector<std::string> length_violations(const Source& source) {
    std::vector<std::string> found;
    size_t lines = 0, begin = 0, counted = 0;
    Data data;
    for_each_line(source.text, [&](size_t number, std::string_view line) {
        const bool is_data = data.holds(line);
        if (!is_data) ++lines;
        if (opens_definition(line)) {
            begin = number;
            counted = 0;
        }
        if (!is_data && !is_label(line)) ++counted;
        if (line == "}" && counted > max_function_lines)
            found.push_back(
                at(source, begin, "a function of " + std::to_string(counted) + " lines"));
    });
    if (lines > max_file_lines)
        found.push_back(at(source, 1, "a file of " + std::to_string(lines) + " lines"));
    return found;
}

std::vector<std::string> word_violations(const Source& source) {
    // Each word is split, so that this file passes its own test.
    const std::string words[] = {std::string("TO") + "DO", std::string("FIX") + "ME"};
    std::vector<std::string> found;
    for_each_line(source.text, [&](size_t number, std::string_view line) {
        for (const std::string& word : words)
            if (line.find(word) != line.npos) found.push_back(at(source, number, word));
    });
    return found;
}

std::vector<std::string> name_violations(const Source& source) {
    if (!source.path.starts_with("tests/")) return {};
    const bool named = source.path.ends_with("_test.cpp");
    bool has_test = false;
    for_each_line(source.text, [&](size_t, std::string_view line) {
        has_test = has_test || line.starts_with("TEST(") || line.starts_with("TEST_");
    });
    if (has_test == named) return {};
    return {at(source, 1, named ? "NAME_test.cpp without a TEST" : "a TEST outside NAME_test.cpp")};
}

std::vector<std::string> all_violations(const Source& source) {
    std::vector<std::string> found = include_violations(source);
    for (const auto check :
         {column_violations, length_violations, word_violations, name_violations})
        for (std::string& violation : check(source))
            found.push_back(std::move(violation));
    return found;
}

}  // namespace wrinkle::layout
