#include "base/diagnostics.h"

#include <filesystem>
#include <new>
#include <set>
#include <stdexcept>

#include "base/printable.h"
#include "base/text.h"

namespace wrinkle {
namespace {

const char* name_of(Severity severity) {
    return severity == Severity::error ? "error" : "warning";
}

}  // namespace

void Diagnostics::add(Diagnostic diagnostic) {
    if (diagnostic.severity == Severity::error) ++error_count_;
    if (list_.size() < limit_)
        list_.push_back(std::move(diagnostic));
    else
        ++dropped_;
}

void Diagnostics::error(RuleId rule, std::string message, std::string expected) {
    add({.rule = rule, .message = std::move(message), .expected = std::move(expected)});
}

void Diagnostics::append(const Diagnostics& other) {
    const size_t errors = error_count_ + other.error_count_;
    for (const Diagnostic& diagnostic : other.list_)
        add(diagnostic);
    error_count_ = errors;  // includes the dropped ones
    dropped_ += other.dropped_;
}

void Diagnostics::append_once(const Diagnostics& other) {
    if (other.dropped_ > 0) return append(other);  // also adds its count of dropped entries
    std::set<std::string> seen;
    for (const Diagnostic& diagnostic : other.list_)
        if (seen.insert(to_text(diagnostic)).second) add(diagnostic);
}

Diagnostic file_problem(Severity severity, RuleId rule, std::string file, std::string message,
                        std::string expected) {
    return {.rule = rule,
            .severity = severity,
            .where = {std::move(file)},
            .message = std::move(message),
            .expected = std::move(expected)};
}

std::string sentence_of(const Diagnostic& diagnostic) {
    std::string text;
    if (!diagnostic.node.empty()) text += "node '" + diagnostic.node + "': ";
    text += diagnostic.message;
    if (!diagnostic.expected.empty()) text += " (" + diagnostic.expected + ")";
    return text;
}

std::string to_text(const Diagnostic& diagnostic) {
    std::string text;
    const Location& where = diagnostic.where;
    if (!where.file.empty()) {
        text += where.file;
        if (where.line > 0)
            text += ":" + std::to_string(where.line) + ":" + std::to_string(where.column);
        text += ": ";
    }
    return printable(text + name_of(diagnostic.severity) + ": " + sentence_of(diagnostic));
}

std::string to_text(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics.list())
        text += to_text(diagnostic) + "\n";
    if (diagnostics.dropped() > 0) text += dropped_text(diagnostics) + "\n";
    return text;
}

std::string dropped_text(const Diagnostics& diagnostics) {
    return "and " + std::to_string(diagnostics.dropped()) + " more problems";
}

// Reports resource exhaustion as one sentence, like any other problem.
std::string exception_text() {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return "out of memory";
    } catch (const std::length_error&) {
        return "out of memory";
    } catch (const std::filesystem::filesystem_error& error) {
        return error.path1().string() + ": " + error.code().message();
    } catch (const std::exception& error) {
        return error.what();
    } catch (...) {
        return "an unknown exception";
    }
}

std::string to_json(const Diagnostics& diagnostics) {
    const auto object = [](const Diagnostic& d) {
        return "\n  {\"severity\": " + json_quoted(name_of(d.severity)) +
               ", \"rule\": " + json_quoted(info(d.rule).id) +
               ", \"file\": " + json_quoted(d.where.file) +
               ", \"line\": " + std::to_string(d.where.line) +
               ", \"column\": " + std::to_string(d.where.column) +
               ", \"pointer\": " + json_quoted(d.pointer) + ", \"node\": " + json_quoted(d.node) +
               ", \"message\": " + json_quoted(d.message) +
               ", \"expected\": " + json_quoted(d.expected) + "}";
    };
    return "{\"version\": 1, \"diagnostics\": [" + joined(diagnostics.list(), ",", object) +
           "], \"dropped\": " + std::to_string(diagnostics.dropped()) + "}\n";
}

}  // namespace wrinkle
