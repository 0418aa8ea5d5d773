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

std::string Outputs::place(const std::string& file, const std::string& suffix) const {
    if (!several()) return output + (is_standard_output() ? "" : suffix);
    return (fs::path(output) / stem_of(file)).string() + (suffix.empty() ? ".glsl" : suffix);
}

std::string Outputs::reflection_place(const std::string& file) const {
    if (!several() || reflect.empty()) return reflect;
    return (fs::path(reflect) / stem_of(file)).string() + ".json";
}

std::string Outputs::depfile_place() const {
    return !depfile.path.empty() ? depfile.path : is_standard_output() ? "-" : output + ".d";
}

std::vector<std::string> Outputs::places_of(const std::string& file) const {
    const bool pair = form == Form::shader && !is_standard_output();
    std::vector<std::string> places;
    if (texts) places.push_back(place(file, pair ? vertex_suffix + suffix : ""));
    if (texts && pair) places.push_back(place(file, fragment_suffix + suffix));
    if (!reflect.empty()) places.push_back(reflection_place(file));
    return places;
}

std::vector<std::string> Outputs::all_places() const {
    std::vector<std::string> places;
    if (costs) places.emplace_back("-");
    for (const std::string& file : files)
        for (std::string& place : places_of(file))
            places.push_back(std::move(place));
    if (depfile.wanted) places.push_back(depfile_place());
    return places;
}

std::string Outputs::conflict() const {
    if (!texts && depfile.wanted) return "-MD goes with -o: it says what the output depends on";
    if (several() && ((texts && is_standard_output()) || reflect == "-"))
        return "several graphs need a folder: " +
               std::string(reflect == "-" ? "--reflect FOLDER" : "-o FOLDER");
    std::vector<std::string> places = all_places();
    std::vector<std::string> stems;
    for (const std::string& file : files)
        if (texts || !reflect.empty()) stems.push_back(stem_of(file));
    const auto twice = [](std::vector<std::string>& list) {
        std::sort(list.begin(), list.end());
        const auto found = std::adjacent_find(list.begin(), list.end());
        return found == list.end() ? std::string() : *found;
    };
    if (const std::string stem = twice(stems); !stem.empty())
        return "two graphs have the stem '" + stem + "', and would be written to one file";
    const std::string place = twice(places);
    if (place == "-") return "standard output takes one text; name a file for the others";
    return place.empty() ? place : "two texts would be written to " + place;
}

}  // namespace wrinkle::cli
