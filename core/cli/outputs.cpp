#include "cli/outputs.h"

#include <algorithm>
#include <filesystem>

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

std::string stem_of(const std::string& file) {
    return file == "-" ? "stdin" : fs::path(file).stem().string();
}

}  // namespace

std::string Outputs::source_path(const std::string& file, const std::string& suffix) const {
    if (!several()) return output + (is_standard_output() ? "" : suffix);
    return (fs::path(output) / stem_of(file)).string() +
           (suffix.empty() ? function_suffix : suffix);
}

std::string Outputs::reflection_path(const std::string& file) const {
    if (!several() || reflect.empty()) return reflect;
    return (fs::path(reflect) / stem_of(file)).string() + ".json";
}

std::string Outputs::depfile_path() const {
    return !depfile.path.empty() ? depfile.path : is_standard_output() ? "-" : output + ".d";
}

std::vector<std::string> Outputs::paths_of(const std::string& file) const {
    const bool pair = form == Form::shader && !is_standard_output();
    std::vector<std::string> paths;
    if (texts) paths.push_back(source_path(file, pair ? vertex_suffix + suffix : ""));
    if (texts && pair) paths.push_back(source_path(file, fragment_suffix + suffix));
    if (!reflect.empty()) paths.push_back(reflection_path(file));
    return paths;
}

std::vector<std::string> Outputs::all_paths() const {
    std::vector<std::string> paths;
    if (costs) paths.emplace_back("-");
    for (const std::string& file : files)
        for (std::string& path : paths_of(file))
            paths.push_back(std::move(path));
    if (depfile.wanted) paths.push_back(depfile_path());
    return paths;
}

std::string Outputs::conflict() const {
    if (!texts && depfile.wanted) return "-MD goes with -o: it says what the output depends on";
    if (several() && ((texts && is_standard_output()) || reflect == "-"))
        return "several graphs need a folder: " +
               std::string(reflect == "-" ? "--reflect FOLDER" : "-o FOLDER");
    std::vector<std::string> paths = all_paths();
    std::vector<std::string> stems;
    for (const std::string& file : files)
        if (texts || !reflect.empty()) stems.push_back(stem_of(file));
    const auto twice = [](std::vector<std::string>& list) {
        std::ranges::sort(list);
        const auto found = std::adjacent_find(list.begin(), list.end());
        return found == list.end() ? std::string() : *found;
    };
    if (const std::string stem = twice(stems); !stem.empty())
        return "two graphs have the stem '" + stem + "', and would be written to one file";
    const std::string path = twice(paths);
    if (path == "-") return "standard output takes one text; name a file for the others";
    return path.empty() ? path : "two texts would be written to " + path;
}

}  // namespace wrinkle::cli
