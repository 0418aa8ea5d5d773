// Diagnostic about a file in general (a mesh, a graph), with the file name as given by the user.
#pragma once

#include <string>

#include "base/diagnostics.h"

namespace wrinkle {

inline Diagnostic file_problem(Severity severity, std::string file, std::string message,
                               std::string expected) {
    Diagnostic problem;
    problem.severity = severity;
    problem.where.file = std::move(file);
    problem.message = std::move(message);
    problem.expected = std::move(expected);
    return problem;
}

}  // namespace wrinkle
