// Results of `wrinkle test`: the verdict of each check of each regression case, and its evidence.
// Results of `wrinkle diff`: the same, compared with the first graph instead of a baseline.
// The writers in this folder turn them into a page (page.h), JSON (results_json.h), and formats
// for CI systems (ci_formats.h).
//
// A case is an entry of a test file (docs/test-cases.md). A check is one result that the case holds
// to a baseline or budget: a point, the text, the image or the cost. Texts are UTF-8 as the graph's
// author wrote them: every writer escapes them for its format.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::report {

enum class Status : uint8_t {
    passed,
    failed,   // differs from its baseline by more than the limit
    error,    // could not run
    added,    // has no baseline yet
    deleted,  // a baseline that no check reads
    changed,  // differs between two graphs, by any amount
};
inline constexpr std::array status_names = {"passed", "failed",  "error",
                                            "new",    "deleted", "changed"};
inline std::string_view name_of(Status status) {
    return status_names[static_cast<size_t>(status)];
}

enum class CheckKind : uint8_t { point, text, image, cost, none };  // none: the entire case
inline constexpr std::array kind_names = {"point", "text", "image", "cost", "case"};
inline std::string_view name_of(CheckKind kind) {
    return kind_names[static_cast<size_t>(kind)];
}

// A number that was held to a limit. An output of a point, a measure of an image, a cost.
struct Measured {
    std::string name;      // "normal", "rms", "alu"
    std::string node;      // where it comes from: "weave.normal"; "" if not known
    std::string expected;  // as printed: "[0, 0, 1]"; may be empty
    std::string actual;
    // The difference and its limit; of a cost, the cost, and between two graphs its increase.
    double value = 0, limit = 0;
    std::string unit;  // "degrees", "of 255"; "" for plain numbers
    bool within() const { return value <= limit; }
    // value / limit, at most max_excess. If the limit is 0, 0 within it and max_excess beyond.
    // NaN gives max_excess.
    double excess() const;
    static constexpr double max_excess = 1e9;
};

struct Check {
    std::string test;     // the case: "graphs/rings", or "graphs/rings.old" of an entry "old"
    std::string name;     // within the case: "points/2", "glsl", "render", "budget"
    std::string file;     // the test file
    uint32_t line = 0;    // the check's line in it; 0: the file in general
    uint32_t column = 0;  // from 1
    std::string pointer;  // JSON pointer of the check: "/points/2", "/cases/0/render"
    CheckKind kind = CheckKind::none;
    Status status = Status::passed;
    std::string message;   // one sentence; "" if passed
    std::string expected;  // a hint: the remedy; may be empty
    double seconds = 0;    // time of the check; the first of a case has the time of compiling
    std::vector<Measured> measured;

    std::string graph;     // file, for programs that read the JSON
    std::string inputs;    // SHA-256 of all files that the case reads; "" if the check passed
    std::string baseline;  // file that holds it, for example golden/rings.png
    // Texts that are not passed; for points the values of the outputs as JSON.
    std::string expected_text, actual_text;
    std::vector<std::string> nodes_of_lines;  // for each line of actual_text; "": none
    // PNG files, relative to the folder of the report; may be empty.
    std::string expected_image, actual_image, map_image;
    std::string map_measure;         // "flip" or "degrees"
    double map_scale = 0;            // value of the map's last color
    uint32_t width = 0, height = 0;  // size of the images

    std::string joined_image;  // the images side by side, for systems that show one

    double excess() const;  // the largest of its numbers; 0 without numbers
    // Unique in a run, and the same in every run: "graphs/rings.old/render".
    std::string id() const { return test + "/" + name; }
};

struct Results {
    std::string version;                // Wrinkle's
    std::string driver;                 // OpenGL's; "" if no image was drawn
    std::string command;                // command line that repeats the run
    std::string approval;               // command line that accepts; names follow
    std::string started;                // ISO 8601, UTC
    double seconds = 0;                 // time of the run
    bool added_fails = false;           // checks with Status::added are failures
    std::string before, after;          // files of the two graphs; "" of a test run
    std::vector<std::string> changes;   // a line per change of the graph
    std::vector<std::string> problems;  // for the entire run: no OpenGL
    std::vector<std::string> causes;    // likely causes of failures (suspects.h), a clause each
    std::vector<Check> checks;          // in the order of their files

    size_t count(Status status) const;
    bool compares_graphs() const { return !after.empty(); }
    // Returns true unless the check passed, or is new and not added_fails.
    bool fails(const Check& check) const;
    bool fails() const;  // a check fails
    // Indices of the checks that are not passed: errors; failed and changed ones by their excess;
    // deleted; new.
    std::vector<size_t> by_severity() const;
};

}  // namespace wrinkle::report
