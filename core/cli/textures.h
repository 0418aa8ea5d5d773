// The images of a module as pixels, for the commands that need them.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "cli/session.h"
#include "image/mips.h"
#include "lower/material.h"

namespace wrinkle::cli {

// Images by their path, read once a process.
class Textures {
public:
    // Reads what the module samples. A problem is reported at the first node that reads the image;
    // a file that failed once is reported once.
    void load(const Compiled& compiled, const Project& project, Diagnostics& diagnostics);

    // Null for one that was not, or could not be, read.
    std::shared_ptr<const MipChain> find(const std::string& file) const;

private:
    std::map<std::string, std::shared_ptr<const MipChain>> chains_;
};

}  // namespace wrinkle::cli
