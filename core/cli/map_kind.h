// The words of `convert` and `lint` for what a map is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "maps/map.h"

namespace wrinkle::cli {

std::vector<std::string> kind_names();  // derivative, normal, slopes, moments, height
maps::Kind kind_named(const std::string& name);

std::vector<std::string> source_names();  // normal_gl, normal_dx, derivative, height
maps::Source source_named(const std::string& name);

// What a picture looks like, said in a warning; nothing, with an error that asks for --from, where
// it looks like none of them.
std::optional<maps::Source> source_found(const Image& image, const std::string& file,
                                         Diagnostics& diagnostics);

}  // namespace wrinkle::cli
