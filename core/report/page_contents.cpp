#include "report/page_contents.h"

#include <string_view>
#include <unordered_map>
#include <utility>

#include "base/text.h"
#include "report/case_markup.h"
#include "report/diff_markup.h"

namespace wrinkle::report {
namespace fs = std::filesystem;

std::vector<Case> cases_by_severity(const Results& results) {
    std::vector<Case> cases;
    std::unordered_map<std::string_view, size_t> places;  // in `cases`
    for (const size_t i : results.by_severity()) {
        const std::string& name = results.checks[i].test;
        if (places.emplace(name, cases.size()).second) cases.push_back({name, {}, {}});
    }
    for (size_t i = 0; i < results.checks.size(); ++i) {
        const Check& check = results.checks[i];
        const auto place = places.find(check.test);
        if (place == places.end()) continue;
        cases[place->second].checks.push_back(i);
        if (check.status != Status::passed) cases[place->second].differing.push_back(i);
    }
    return cases;
}

Contents contents_within(const Results& results, const std::vector<Case>& cases,
                         const fs::path& folder, uint64_t max_bytes, uint64_t fixed) {
    Contents contents;
    contents.parts.resize(results.checks.size());
    uint64_t used = fixed;
    for (const Case& each : cases) {
        used += html(each.name).size() + heading_markup(results, each).size() +
                points_markup(results, each, false).size() + 60;
        for (const size_t i : each.differing)
            used += check_markup(results.checks[i], {}, false).size();
    }
    const auto fits = [&](size_t bytes) {
        if (used + bytes > max_bytes) return false;
        used += bytes;
        return true;
    };
    for (const Case& each : cases)
        for (const size_t i : each.differing) {
            DiffMarkup diff = diff_markup(results.checks[i]);
            std::string nodes = joined(diff.nodes, " ");
            if (fits(diff.table.size() + 2 * html(nodes).size() + 100))
                contents.parts[i] = {std::move(diff.table), std::move(nodes), {}};
            else if (!diff.table.empty())
                ++contents.lines_left_out;
        }
    for (const Case& each : cases)
        for (const size_t i : each.differing) {
            InlinedImages images = inlined_images(results.checks[i], folder);
            if (images.bytes() == 0) continue;
            if (fits(images.bytes() + 300))
                contents.parts[i].images = std::move(images);
            else
                ++contents.images_left_out;
        }
    return contents;
}

}  // namespace wrinkle::report
