// Diagnostics: errors and warnings about user input, each with a location and a hint.
//
// A Diagnostic has a rule (base/rules.h) and names the object at fault: file, line and column of
// the JSON token, JSON pointer and node, with the problem found and the expected form. A
// Diagnostics list collects all problems of a run; functions that can fail take one, append to it,
// and return an empty or poison result. It stores the first `limit` entries and counts the rest.
// Bugs of Wrinkle itself are asserts, never diagnostics.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/rules.h"

namespace wrinkle {

enum class Severity : uint8_t { error, warning };

// Location in a text file; line and column count from 1, 0 means the file in general.
struct Location {
    std::string file;
    uint32_t line = 0;
    uint32_t column = 0;
};

struct Diagnostic {
    RuleId rule;  // without a default: chosen wherever a diagnostic is made
    Severity severity = Severity::error;
    Location where{};
    std::string pointer{};   // JSON pointer of the token, "" for the document
    std::string node{};      // node id; in a sub-graph "outer/inner"; "" when no node is at fault
    std::string message{};   // one sentence: the problem
    std::string expected{};  // hint: the valid form or the nearest name; may be empty
};

class Diagnostics {
public:
    static constexpr size_t default_limit = 1000;

    explicit Diagnostics(size_t limit = default_limit) : limit_(limit) {}

    void add(Diagnostic diagnostic);
    void error(RuleId rule, std::string message, std::string expected = {});
    void append(const Diagnostics& other);
    // Appends each diagnostic once: several compilations of one graph share most problems.
    void append_once(const Diagnostics& other);

    const std::vector<Diagnostic>& list() const { return list_; }
    bool has_errors() const { return error_count_ > 0; }
    size_t error_count() const { return error_count_; }
    size_t dropped() const { return dropped_; }  // number of entries after the limit

private:
    std::vector<Diagnostic> list_;
    size_t limit_;
    size_t error_count_ = 0;
    size_t dropped_ = 0;
};

// Returns a diagnostic about a file in general (a mesh, a graph), named as by the user.
Diagnostic file_problem(Severity severity, RuleId rule, std::string file, std::string message,
                        std::string expected);

// Returns "node 'weave': unknown port 'amout' (did you mean 'amount'?)", as in the file.
std::string sentence_of(const Diagnostic& diagnostic);
// Returns one line, escaped by printable(): "graph.json:12:7: error: node 'weave': unknown port
// 'amout' (did you mean 'amount'?)".
std::string to_text(const Diagnostic& diagnostic);
// Returns one line per problem and, if some were dropped, a last line with their count.
std::string to_text(const Diagnostics& diagnostics);
std::string dropped_text(const Diagnostics& diagnostics);  // "and 12 more problems"
// Returns a short description of the current exception. Precondition: called in a catch block.
std::string exception_text();
// {"version": 1, "diagnostics": [{"severity", "rule", "file", "line", "column", "pointer", "node",
//  "message", "expected"}], "dropped": n}
std::string to_json(const Diagnostics& diagnostics);

}  // namespace wrinkle
