// wrinkle new-plugin NAME: creates a folder with a template node that builds, runs and has a test.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "base/file.h"
#include "base/folders.h"
#include "base/text.h"
#include "cli/cli.h"
#include "cli/output.h"
#include "cli/texts.h"
#include "nodes/all.h"
#include "registry/port_type.h"
#include "registry/registry.h"

namespace wrinkle::cli {
namespace {

namespace fs = std::filesystem;

// C++ keywords that are valid node names, and target names reserved by CMake.
constexpr std::string_view reserved =
    "all alignas alignof and and_eq asm auto bitand bitor bool break case catch char class clean "
    "co_await co_return co_yield compl concept const const_cast consteval constexpr constinit "
    "continue decltype default delete depend do double dynamic_cast edit_cache else enum explicit "
    "export extern false float for friend goto help if inline install int long mutable namespace "
    "new noexcept not not_eq nullptr operator or or_eq package package_source preinstall private "
    "protected public rebuild_cache register reinterpret_cast requires return short signed sizeof "
    "static static_assert static_cast struct switch template test this thread_local throw true try "
    "typedef typeid typename union unsigned using virtual void volatile wchar_t while xor xor_eq";

// Returns the reason if `name` is not valid for a new node, otherwise "".
std::string why_not(const std::string& name) {
    if (!is_name(name))
        return "is not a name for a node: a letter a-z, then letters, digits and _, at most " +
               std::to_string(max_name);
    const auto words = split(reserved, ' ');
    if (std::ranges::find(words, name) != words.end())
        return "is a word of C++ or CMake; the node needs another name";
    Registry registry;
    Diagnostics ignored;
    registry.add_plugin(built_in_nodes(), Registry::built_in, ignored);
    if (name == reroute_type || registry.find(name))
        return "is a built-in node; a new one needs another name";
    return {};
}

// Returns the parent of the program's folder if it contains the SDK (installation or build folder),
// otherwise "".
std::string sdk_prefix() {
    std::error_code error;
    const fs::path prefix = program_folder().parent_path();
    const bool there = fs::exists(prefix / "lib/cmake/WrinkleSDK/WrinkleSDKConfig.cmake", error);
    return there ? prefix.string() : std::string();
}

// Replaces @NAME@, @TITLE@ and @PREFIX@ in a template.
std::string filled(std::string_view form, std::string_view name, std::string_view prefix) {
    std::string title(name);
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
    std::ranges::replace(title, '_', ' ');
    const std::pair<std::string_view, std::string_view> blanks[] = {
        {"NAME", name}, {"TITLE", title}, {"PREFIX", prefix}};
    std::string text;
    for (bool is_blank = false; const std::string_view part : split(form, '@')) {
        if (!is_blank) text += part;
        for (const auto& [blank, value] : blanks)
            if (is_blank && part == blank) text += value;
        is_blank = !is_blank;
    }
    return text;
}

// Returns the files of a node with its graph, test and build. `prefix` is the install or build
// folder of the SDK, "" if unknown.
std::vector<Result> scaffold(const fs::path& folder, const std::string& name,
                             std::string_view prefix) {
    const std::pair<std::string, std::string_view> forms[] = {
        {name + ".cpp", texts::plugin_cpp_in},
        {"CMakeLists.txt", texts::plugin_cmake_in},
        {name + ".json", texts::plugin_json_in},
        {name + ".test.json", texts::plugin_test_json_in},
        {"README.md", texts::plugin_md_in}};
    std::vector<Result> files;
    for (const auto& [file, form] : forms)
        files.push_back({(folder / file).string(), filled(form, name, prefix)});
    return files;
}

// Returns the topmost missing folder on the way to `path`; empty if `path` exists.
fs::path first_missing(fs::path path) {
    fs::path missing;
    std::error_code error;
    for (; !path.empty() && !fs::exists(path, error); path = path.parent_path())
        missing = path;
    return missing;
}

// Returns true if `folder` holds only files that an interrupted earlier run may have written.
bool is_unfinished(const fs::path& folder, const std::vector<Result>& files) {
    const auto is_left = [&](const fs::path& path) {
        std::string why;
        const auto is_it = [&](const Result& file) {
            return path == file.path && read_file(path, why) == file.text;
        };
        return Temporary::is_name(path.filename().string()) || std::ranges::any_of(files, is_it);
    };
    std::error_code error;
    fs::directory_iterator entries(folder, error);
    return !error && std::all_of(begin(entries), end(entries), is_left);
}

struct NewPluginCommand {
    std::string name, folder;

    int run() const {
        const fs::path target = folder.empty() ? fs::path(name) : fs::path(folder);
        if (const std::string why = write(target); !why.empty()) return fail(exit_environment, why);
        std::printf("%s\n    cmake -B build . && cmake --build build && ctest --test-dir build\n",
                    target.c_str());
        return exit_success;
    }

    // Writes all files or none; returns the reason of a failure, otherwise "".
    std::string write(const fs::path& target) const {
        std::error_code error;
        if (fs::exists(target, error) && !fs::is_directory(target, error))
            return target.string() + ": is not a folder";
        const auto files = scaffold(target, name, sdk_prefix());
        if (!error && fs::exists(target, error) && !is_unfinished(target, files))
            return target.string() + ": the folder is not empty; --folder names another one";
        const fs::path whole = fs::absolute(target, error);
        const fs::path made = first_missing(whole);
        if (!error) fs::create_directories(whole, error);
        std::string why = error ? target.string() + ": " + error.message() : "";
        if (why.empty() && write_results(files, why)) return {};
        if (!made.empty()) fs::remove_all(made, error);
        return why;
    }
};

}  // namespace

void declare_new_plugin(CLI::App& app, Run& run) {
    auto [sub, c] = add_command<NewPluginCommand>(
        app, run, "new-plugin",
        "Writes a folder with a node of your own, ready to build and to test");
    sub.add_option("NAME", c.name, "Type of the node in graphs")
        ->required()
        ->check(CLI::Validator(
            [](const std::string& name) {
                const std::string why = why_not(name);
                return why.empty() ? why : "'" + name + "' " + why;
            },
            ""));
    sub.add_option("--folder", c.folder, "Where to write it, a new or empty folder; default: NAME")
        ->type_name("DIR");
}

}  // namespace wrinkle::cli
