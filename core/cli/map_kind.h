// Names of map kinds in the options of `convert` and `lint`.
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

// Detects the kind of an image and reports it as a warning. Returns std::nullopt and reports an
// error that suggests --from if the image matches none of them.
std::optional<maps::Source> source_found(const Image& image, const std::string& file,
                                         Diagnostics& diagnostics);

}  // namespace wrinkle::cli
