#include <algorithm>

#include "api/parts.h"

namespace wrinkle::api {
namespace {

Diagnostic diagnostic_of(const Problem& problem) {
    return {RuleId{},
            problem.is_error ? Severity::error : Severity::warning,
            {problem.file, problem.line, problem.column},
            problem.pointer,
            problem.node,
            problem.message,
            problem.expected};
}

// Returns an error without a location.
Problem with_message(std::string message) {
    Problem problem;
    problem.message = std::move(message);
    return problem;
}

}  // namespace

Problem problem_of(const Diagnostic& diagnostic) {
    const Location& where = diagnostic.where;
    return {diagnostic.severity == Severity::error,
            where.file,
            where.line,
            where.column,
            diagnostic.pointer,
            diagnostic.node,
            diagnostic.message,
            diagnostic.expected};
}

Problems problems_of(const Diagnostics& diagnostics) {
    Problems problems;
    for (const Diagnostic& each : diagnostics.list())
        problems.push_back(problem_of(each));
    if (diagnostics.dropped() == 0) return problems;
    problems.push_back(with_message(dropped_text(diagnostics)));
    problems.back().is_error = diagnostics.has_errors();
    return problems;
}

Problems no_graph() {
    return {with_message("there is no graph: none was loaded, or it was moved from")};
}

Problems caught() noexcept {
    try {
        return {with_message(exception_text())};
    } catch (...) {
        return {};
    }
}

bool has_errors(const Problems& problems) noexcept {
    return std::any_of(problems.begin(), problems.end(),
                       [](const Problem& problem) { return problem.is_error; });
}

std::string to_text(const Problem& problem) noexcept {
    try {
        return wrinkle::to_text(diagnostic_of(problem));
    } catch (...) {
        return {};
    }
}

std::string to_text(const Problems& problems) noexcept {
    try {
        std::string text;
        for (const Problem& problem : problems)
            text += to_text(problem) + "\n";
        return text;
    } catch (...) {
        return {};
    }
}

}  // namespace wrinkle::api
