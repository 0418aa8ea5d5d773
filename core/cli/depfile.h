// Make-style dependency files, as written by compilers with -MD -MF -MT -MP.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace wrinkle::cli {

struct Depfile {
    bool wanted = false;
    bool phony = false;  // adds an empty rule per input, so that one may be removed
    std::string path;    // "": the output path with ".d" appended
    std::string target;  // "": the outputs

    // Returns false if the other options are given without -MD.
    bool is_complete() const { return wanted || (!phony && path.empty() && target.empty()); }
};

void declare_depfile(CLI::App& command, Depfile& depfile);

// Outputs and inputs of one graph.
struct Rule {
    std::vector<std::string> made, from;
};

// Returns one sentence if the rules cannot be written, otherwise "". Only names that Make 4.3 and
// Ninja 1.11 read identically are accepted. Refused are: control characters and "&'*;<=>?^`|, a
// backslash before an escaped character or at the end, a leading ~, a trailing blank or colon, and
// % in the name of a target.
std::string depfile_fault(const std::vector<Rule>& rules, const Depfile& depfile);

// Returns "a b: c \<newline>  d" per graph, with names escaped for Make and Ninja. With a target
// named by the user, all inputs form one rule. Precondition: depfile_fault() returns "".
std::string make_rules(const std::vector<Rule>& rules, const Depfile& depfile);

}  // namespace wrinkle::cli
