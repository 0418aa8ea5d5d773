// Likely causes of failures: files and types of nodes that failed cases have in common and passed
// cases lack.
//
// Source: Abreu, Zoeteweij and van Gemund 2007, "On the Accuracy of Spectrum-based Fault
// Localization" (Ochiai's coefficient).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace wrinkle::report {

// A case, and the files and types of nodes in it: "file textures/weave.png", "node resolve".
struct CaseUses {
    bool failed = false;
    std::vector<std::string> uses;
};

struct Suspect {
    std::string name;
    size_t failed = 0, passed = 0;  // cases that use it
    double score = 0;               // failed / sqrt(all failed * (failed + passed)): 0 to 1
};

// Returns the three with the highest scores, those below `least` and those of a single failed case
// left out; empty if fewer than two cases failed, or if no case passed.
std::vector<Suspect> suspects(const std::vector<CaseUses>& cases, double least = 0.5);

// "node resolve: in 7 of 8 failed and 2 of 105 passed cases".
std::vector<std::string> likely_causes(const std::vector<CaseUses>& cases);

}  // namespace wrinkle::report
