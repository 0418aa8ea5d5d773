// Make-style dependency files, as compilers write them with -MD -MF -MT -MP.
#pragma once

#include <string>
#include <vector>

#include "cli/cli.h"

namespace wrinkle::cli {

struct Depfile {
    bool wanted = false;
    bool phony = false;  // inputs are targets of their own, so that one may be removed
    std::string path;    // "": the output's name with ".d"
    std::string target;  // "": the outputs
};

void declare_depfile(CLI::App& command, Depfile& depfile);

// What one graph made, and from what.
struct Rule {
    std::vector<std::string> made, from;
};

// "a b: c \<newline>  d" of each graph, names escaped for Make and Ninja. With a target of the
// user's own it is one rule of all.
std::string make_rules(const std::vector<Rule>& rules, const Depfile& depfile);

}  // namespace wrinkle::cli
