// Which file each text of a compilation goes to.
#pragma once

#include <string>
#include <vector>

#include "cli/depfile.h"
#include "glsl/emit.h"

namespace wrinkle::cli {

inline const std::string vertex_suffix = ".vert", fragment_suffix = ".frag";

struct Outputs {
    std::string output = "-";
    Form form = Form::function;
    std::string suffix;              // of the target's files, behind the stage's
    std::string stage = "fragment";  // that goes to standard output
    std::string reflect;
    Depfile depfile;
    std::vector<std::string> files;  // the graphs
    bool texts = true;               // they are written; --cost alone writes none
    bool costs = false;              // to standard output

    bool several() const { return files.size() > 1; }
    bool is_standard_output() const { return output == "-"; }
    // Of one graph OUT, of several OUT/STEM.glsl; with the text's suffix.
    std::string place(const std::string& file, const std::string& suffix) const;
    std::string reflection_place(const std::string& file) const;  // "": none is wanted
    std::string depfile_place() const;
    std::vector<std::string> places_of(const std::string& file) const;  // "-" among them
    std::vector<std::string> all_places() const;
    // Why two texts would come to one place, or several to standard output; "" when all is well.
    std::string conflict() const;
};

}  // namespace wrinkle::cli
