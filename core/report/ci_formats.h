// Results of `wrinkle test` in the formats that CI systems read.
//
// Each writer escapes for its format: the texts of a graph's author, of drivers and of file systems
// may hold any bytes.
#pragma once

#include <filesystem>
#include <string>

#include "report/results.h"

namespace wrinkle::report {

struct CiOptions {
    std::filesystem::path root;  // the repository's: files are named relative to it
    // Put before the paths of images, which are relative to the report: its folder as the CI system
    // names it, "" for none.
    std::string attachments;
    bool added_fails = false;  // a check without a baseline is a failure, else it is skipped
};

// JUnit XML as GitLab, Jenkins, Azure DevOps and GitHub's actions read it: a testsuite for each
// case, a testcase for each check; `classname` is the case, `name` the check. A check that could
// not run, and a problem of the run, is an error, any other that did not pass a failure. The image
// of a check (the joined one, else the actual one) is a line "[[ATTACHMENT|path]]" of its
// system-out. Characters that XML 1.0 does not allow and bytes that are not UTF-8 become U+FFFD;
// ANSI escape sequences are left out.
std::string junit(const Results& results, const CiOptions& options);

// TAP version 14, a test point for each check; details of those that did not pass as YAML.
std::string tap(const Results& results, const CiOptions& options);

// Workflow commands of GitHub (annotations.h) for checks that did not pass; deleted baselines and
// problems of the run among them.
std::string github_annotations(const Results& results, const CiOptions& options);

}  // namespace wrinkle::report
