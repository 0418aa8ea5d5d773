// Results with texts that attack each format, for tests of writers and their readers.
#pragma once

#include <string>

#include "report/results.h"

namespace wrinkle::test {

// Quotes, markup, ends of CDATA and of commands, every control character, an ANSI color, a terminal
// title, bytes that are not UTF-8, characters beyond the first plane.
inline std::string hostile_text() {
    std::string text = "<a href=\"x\">'&amp;' ]]> %0A::error::x --> # \\ {0}\t\r\n";
    for (char c = 1; c < 0x20; ++c)
        if (c != 0x1B) text += c;
    text += '\0';
    text +=
        "\x1B[31mred\x1B[0m \x1B]0;title\a \xFF\xC0\x80 \xED\xA0\x80 \xEF\xBF\xBE \xF0\x9F\x8E\xA8";
    return text + " \xC2\x85 \xE2\x80\xA8 \xE2\x80\xAE end";
}

// One check of each status, those that did not pass with hostile texts.
inline report::Results hostile_results() {
    using namespace report;
    Results results;
    results.version = "1.0.0";
    results.started = "2026-11-26T02:00:00Z";
    for (const Status status :
         {Status::passed, Status::failed, Status::error, Status::added, Status::deleted}) {
        Check check;
        check.test = "graphs/rings.old";
        check.name = "points/" + std::to_string(results.checks.size());
        check.file = "graphs/rings.test.json";
        check.line = 7;
        check.column = 3;
        check.kind = CheckKind::point;
        check.status = status;
        check.seconds = 0.25;
        if (status != Status::passed) check.message = "differs: " + hostile_text();
        if (status == Status::failed) {
            check.measured = {{"normal" + hostile_text(), "weave.normal", "[0, 0, 1]", "[0, 1, 0]",
                               90, 0.05, "degrees"},
                              {"height", "", "1", "1", 0, 0.0001, ""}};
            check.joined_image = "images/rings <&>.png";
        }
        results.checks.push_back(std::move(check));
    }
    Check& name = results.checks.emplace_back(results.checks[1]);
    name.test = "graphs/\"<&>\"\n" + hostile_text();
    name.name = hostile_text();
    name.joined_image.clear();
    return results;
}

}  // namespace wrinkle::test
