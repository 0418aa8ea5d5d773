// What went wrong, said so that its reader can mend it.
//
// A Diagnostic names the user's thing: file, line and column of the JSON token, the JSON pointer,
// the node, what was found and what was expected. A Diagnostics list collects every problem of a
// run; functions that can fail take one, add to it, and return an empty or poison result. It keeps
// the first `limit` entries and counts the rest. Our own bugs are asserts, never diagnostics.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace wrinkle {

enum class Severity : uint8_t { error, warning };

// Where in a text file; line and column count from 1, 0 means "the file as a whole".
struct Location {
    std::string file;
    uint32_t line = 0;
    uint32_t column = 0;
};

struct Diagnostic {
    Severity severity = Severity::error;
    Location where;
    std::string pointer;   // JSON pointer of the token, "" for the document
    std::string node;      // node id; in a sub-graph "outer/inner"; "" when no node is at fault
    std::string message;   // one sentence: what is wrong with the user's thing
    std::string expected;  // the remedy: what would be right, or the nearest name; may be empty
};

class Diagnostics {
public:
    static constexpr size_t default_limit = 1000;

    explicit Diagnostics(size_t limit = default_limit) : limit_(limit) {}

    void add(Diagnostic diagnostic);
    void error(std::string message, std::string expected = {});
    void append(const Diagnostics& other);
    // Each once: several compilations of one graph have most problems in common.
    void append_once(const Diagnostics& other);

    const std::vector<Diagnostic>& list() const { return list_; }
    bool has_errors() const { return error_count_ > 0; }
    size_t error_count() const { return error_count_; }
    size_t dropped() const { return dropped_; }  // how many came after the limit

private:
    std::vector<Diagnostic> list_;
    size_t limit_;
    size_t error_count_ = 0;
    size_t dropped_ = 0;
};

// "graph.json:12:7: error: node 'weave': unknown port 'amout' (did you mean 'amount'?)": one line,
// as printable() makes it.
std::string to_text(const Diagnostic& diagnostic);
// One line per problem and, when some were dropped, a last line with their count.
std::string to_text(const Diagnostics& diagnostics);
std::string dropped_text(const Diagnostics& diagnostics);  // "and 12 more problems"
// In a catch block: the exception under way, in a few words for people.
std::string exception_text();
// {"version": 1, "diagnostics": [{"severity", "file", "line", "column", "pointer", "node",
//  "message", "expected"}], "dropped": n}
std::string to_json(const Diagnostics& diagnostics);

}  // namespace wrinkle
