// Output paths of `wrinkle compile`.
#pragma once

#include <string>
#include <vector>

#include "cli/depfile.h"
#include "emit/emit.h"

namespace wrinkle::cli {

inline const std::string vertex_suffix = ".vert", fragment_suffix = ".frag";

struct Outputs {
    std::string output = "-";
    Form form = Form::function;
    std::string suffix;  // file suffix of the target, after that of the stage
    std::string function_suffix = ".glsl";
    std::string stage = "fragment";  // stage that is written to standard output
    std::string reflect;
    Depfile depfile;
    std::vector<std::string> files;  // the graphs
    bool texts = true;               // false if only --cost is given: no generated source
    bool costs = false;              // report written to standard output

    bool several() const { return files.size() > 1; }
    bool is_standard_output() const { return output == "-"; }
    // Output path: "-", or OUT + `suffix`, for one graph; for several OUT/STEM + `suffix`, which is
    // that of functions by default.
    std::string source_path(const std::string& file, const std::string& suffix) const;
    std::string reflection_path(const std::string& file) const;  // "": not requested
    std::string depfile_path() const;
    std::vector<std::string> paths_of(const std::string& file) const;  // may include "-"
    std::vector<std::string> all_paths() const;
    // Returns the reason if two outputs have the same path, or if several would be written to
    // standard output; otherwise "".
    std::string conflict() const;
};

}  // namespace wrinkle::cli
