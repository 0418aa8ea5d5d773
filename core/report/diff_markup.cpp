#include "report/diff_markup.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "report/markup.h"
#include "report/text_diff.h"

namespace wrinkle::report {
namespace {

using Kind = DiffLine::Kind;

// Part of a line that changed: [begin, end).
struct Part {
    size_t begin = 0, end = 0;
};

bool is_inside_character(std::string_view text, size_t at) {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
}

// The changed parts of two lines: without their common beginning and end. Empty parts if the lines
// have less than a third in common.
std::pair<Part, Part> changed_parts(std::string_view a, std::string_view b) {
    const size_t shorter = std::min(a.size(), b.size());
    size_t head = 0, tail = 0;
    while (head < shorter && a[head] == b[head])
        ++head;
    while (head > 0 && (is_inside_character(a, head) || is_inside_character(b, head)))
        --head;
    while (tail < shorter - head && a[a.size() - 1 - tail] == b[b.size() - 1 - tail])
        ++tail;
    while (tail > 0 && is_inside_character(a, a.size() - tail))
        --tail;
    if ((head + tail) * 3 < std::max(a.size(), b.size())) return {};
    return {{head, a.size() - tail}, {head, b.size() - tail}};
}

// Pairs the removed lines of a change with its added lines if they are as many.
std::vector<Part> parts_of(const std::vector<DiffLine>& lines) {
    std::vector<Part> parts(lines.size());
    for (size_t i = 0; i < lines.size();) {
        const auto end_of = [&](size_t at, Kind kind) {
            while (at < lines.size() && lines[at].kind == kind)
                ++at;
            return at;
        };
        const size_t middle = end_of(i, Kind::removed), end = end_of(middle, Kind::added);
        if (middle - i == end - middle)
            for (size_t k = 0; k < middle - i; ++k)
                std::tie(parts[i + k], parts[middle + k]) =
                    changed_parts(lines[i + k].text, lines[middle + k].text);
        i = std::max(end, i + 1);
    }
    return parts;
}

// Tabs are four spaces.
std::string code(std::string_view line) {
    std::string spaced;
    for (const char c : line)
        spaced += c == '\t' ? std::string("    ") : std::string(1, c);
    return html(spaced);
}

std::string marked(std::string_view line, Part part) {
    if (part.begin == part.end) return code(line);
    return code(line.substr(0, part.begin)) + "<mark>" +
           code(line.substr(part.begin, part.end - part.begin)) + "</mark>" +
           code(line.substr(part.end));
}

std::string node_of(const DiffLine& line, const Check& check) {
    const size_t index = line.actual_line - size_t{1};
    return line.actual_line && index < check.nodes_of_lines.size() ? check.nodes_of_lines[index]
                                                                   : "";
}

std::string row(const DiffLine& line, Part part, const Check& check) {
    if (line.kind == Kind::skipped)
        return "<tr class=\"skipped\"><td colspan=\"5\">\u22ef</td></tr>\n";
    const auto at = [](uint32_t place) {
        return "<td class=\"number\">" + (place ? std::to_string(place) : "") + "</td>";
    };
    const char* mark = line.kind == Kind::removed ? "\u2212" : line.kind == Kind::added ? "+" : "";
    const char* name = line.kind == Kind::removed ? " class=\"removed\""
                       : line.kind == Kind::added ? " class=\"added\""
                                                  : "";
    return "<tr" + std::string(name) + ">" + at(line.expected_line) + at(line.actual_line) +
           "<td class=\"node\">" + html(node_of(line, check)) + "</td><td>" + mark +
           "</td><td><code>" + marked(line.text, part) + "</code></td></tr>\n";
}

}  // namespace

DiffMarkup diff_markup(const Check& check, size_t max_rows) {
    DiffMarkup markup;
    if (check.kind != CheckKind::text || check.actual_text.empty()) return markup;
    const std::vector<DiffLine> lines = diff_lines(check.expected_text, check.actual_text);
    const std::vector<Part> parts = parts_of(lines);
    std::string rows;
    const size_t count = std::min(lines.size(), max_rows);
    for (size_t i = 0; i < count; ++i) {
        rows += row(lines[i], parts[i], check);
        if (lines[i].kind != Kind::added) continue;
        const std::string node = node_of(lines[i], check);
        if (!node.empty() && std::ranges::find(markup.nodes, node) == markup.nodes.end())
            markup.nodes.push_back(node);
    }
    if (count < lines.size())
        rows += "<tr class=\"skipped\"><td colspan=\"5\">" + std::to_string(lines.size() - count) +
                " more lines are not in this page.</td></tr>\n";
    markup.table = "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Lines of " +
                   html(check.id()) +
                   "\"><table class=\"diff\"><thead><tr><th scope=\"col\">Old</th><th "
                   "scope=\"col\">New</th><th scope=\"col\">Node</th><th scope=\"col\"><span "
                   "class=\"hidden\">Mark</span></th><th scope=\"col\">Line</th></tr></thead>"
                   "<tbody>\n" +
                   rows + "</tbody></table></div>\n";
    return markup;
}

}  // namespace wrinkle::report
