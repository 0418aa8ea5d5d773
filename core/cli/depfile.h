// Make-style dependency files, as compilers write them with -MD -MF -MT.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/cli.h"

namespace wrinkle::cli {

struct Depfile {
    bool wanted = false;
    std::string path;    // "": the output's name with ".d"
    std::string target;  // "": the outputs
};

void declare_depfile(CLI::App& command, Depfile& depfile);

// "a b: c \<newline>  d", names escaped for Make and Ninja.
std::string make_rule(const std::vector<std::string>& made,
                      const std::vector<std::filesystem::path>& from);

}  // namespace wrinkle::cli
