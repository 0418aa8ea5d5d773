#include "cli/test_accept.h"

#include <algorithm>
#include <functional>

#include "base/checksum.h"
#include "base/file.h"
#include "base/text.h"
#include "cli/identity.h"
#include "cli/meshes.h"
#include "cli/test_baselines.h"
#include "cli/test_selection.h"
#include "json/write.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

using report::Check;
using report::CheckKind;
using report::Status;

// Accepts the checks of one run.
class Accepting {
public:
    Accepting(const fs::path& folder, const Registry& registry, const CommonOptions& common)
        : folder_(folder), registry_(registry), common_(common) {}

    void accept(std::vector<Check*>& checks);
    Acceptance result;

private:
    void accept_deleted(Check& check);
    void accept_case(const std::vector<Check*>& checks);
    void accept_text(const TestCase& test, Check& check);
    void accept_image(const TestCase& test, Check& check);
    void accept_points(const TestCase& test, const std::vector<Check*>& points);
    bool write(const TestCase& test, const fs::path& file, std::string_view bytes);
    void refuse(const Check& check, const std::string& why) {
        result.refused.push_back(check.id() + ": " + why);
    }
    void accepted(Check& check) { check.status = Status::passed; }

    const fs::path& folder_;
    const Registry& registry_;
    const CommonOptions& common_;
};

void Accepting::accept(std::vector<Check*>& checks) {
    for (size_t first = 0; first < checks.size();) {
        size_t last = first;
        while (last < checks.size() && checks[last]->test == checks[first]->test)
            ++last;
        if (checks[first]->status == Status::deleted)
            for (size_t i = first; i < last; ++i)
                accept_deleted(*checks[i]);
        else
            accept_case({checks.begin() + static_cast<long>(first),
                         checks.begin() + static_cast<long>(last)});
        first = last;
    }
}

void Accepting::accept_deleted(Check& check) {
    const auto unread = unread_baselines(fs::path(check.baseline).parent_path().parent_path());
    const auto is_it = [&](const fs::path& each) { return near_path(each) == check.baseline; };
    if (std::ranges::none_of(unread, is_it))
        return refuse(check, "there is no such file, or a case reads it; run the tests again");
    std::error_code problem;
    if (fs::remove(check.baseline, problem)) {
        result.written.push_back(check.baseline + ": removed");
        accepted(check);
    } else if (result.environment.empty()) {
        result.environment = check.baseline + ": cannot be removed: " + problem.message();
    }
}

// Accepts checks of one case. The file is read again, since another case may have changed it.
void Accepting::accept_case(const std::vector<Check*>& checks) {
    Diagnostics ignored;
    const std::vector<TestCase> cases = read_test_cases(checks.front()->file, ignored);
    const auto test = std::ranges::find(cases, checks.front()->test, &TestCase::full_name);
    const bool is_current =
        test != cases.end() && hash_of_inputs(*test, registry_, common_) == checks.front()->inputs;
    std::vector<Check*> points;
    for (Check* check : checks) {
        if (!is_current)
            refuse(*check, "its files changed after the run; run the tests again");
        else if (check->kind == CheckKind::text)
            accept_text(*test, *check);
        else if (check->kind == CheckKind::image)
            accept_image(*test, *check);
        else
            points.push_back(check);
    }
    if (!points.empty()) accept_points(*test, points);
}

void Accepting::accept_text(const TestCase& test, Check& check) {
    if (write(test, test.golden(".glsl"), check.actual_text)) accepted(check);
}

void Accepting::accept_image(const TestCase& test, Check& check) {
    std::string why;
    const auto file = inside(folder_, folder_ / check.actual_image);
    const auto bytes = file ? read_file(*file, why) : std::nullopt;
    if (!bytes) return refuse(check, "its image is not in the report " + folder_.string());
    if (write(test, test.golden(".png"), *bytes)) accepted(check);
}

// Replaces entries of "expect"; those of other points are copied unchanged, or are empty objects.
void Accepting::accept_points(const TestCase& test, const std::vector<Check*>& points) {
    std::vector<Check*> writable;
    std::vector<std::string> entries;
    for (size_t point = 0; point < test.points.count(); ++point) {
        const bool has_entry = point < test.expect.size();
        const json::Value entry = has_entry ? test.expect.at(point) : json::Value();
        entries.push_back(has_entry ? container_text(entry) : "{}");
        const auto found = std::ranges::find(points, "points/" + std::to_string(point),
                                             [](const Check* check) { return check->name; });
        if (found == points.end()) continue;
        Check& check = **found;
        if (check.actual_text.find("null") != std::string::npos) {
            refuse(check, "its values are not finite");
        } else if (check.expected_text != (entry.size() > 0 ? json::one_line(entry) : "")) {
            refuse(check, "its entry of 'expect' changed after the run; run the tests again");
        } else {
            entries.back() = check.actual_text;
            writable.push_back(&check);
        }
    }
    while (!entries.empty() && entries.back() == "{}")
        entries.pop_back();
    if (writable.empty() || !write(test, test.file, with_expect(test, entries))) return;
    for (Check* check : writable)
        accepted(*check);
}

bool Accepting::write(const TestCase& test, const fs::path& file, std::string_view bytes) {
    if (!inside(root_of(test, common_), link_target(file))) {
        result.refused.push_back(file.string() + ": leads outside the root");
        return false;
    }
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    std::string why;
    if (!write_file(file, bytes, why)) {
        if (result.environment.empty()) result.environment = file.string() + ": " + why;
        return false;
    }
    result.written.push_back(file.string());
    return true;
}

}  // namespace

bool is_pending(const Check& check) {
    const bool differs = check.status == Status::failed || check.status == Status::added ||
                         check.status == Status::deleted;
    return differs && check.kind != CheckKind::cost;
}

bool selects(std::string_view name, const Check& check) {
    if (name == "all") return true;
    if (name == "changed") return check.status == Status::failed;
    if (name == report::name_of(Status::added)) return check.status == Status::added;
    if (name == report::name_of(Status::deleted)) return check.status == Status::deleted;
    while (name.ends_with('/'))
        name.remove_suffix(1);
    const std::string id = check.id();
    if (name.empty() || !id.starts_with(name)) return false;
    const char next = id.c_str()[name.size()];
    return next == '\0' || next == '/' || next == '.';
}

Acceptance accept(report::Results& results, const fs::path& folder,
                  const std::function<bool(const Check&)>& accepts, const Registry& registry,
                  const CommonOptions& common) {
    std::vector<Check*> selected;
    for (Check& check : results.checks)
        if (is_pending(check) && accepts(check)) selected.push_back(&check);
    Accepting accepting(folder, registry, common);
    accepting.accept(selected);
    return std::move(accepting.result);
}

std::string hash_of_inputs(const TestCase& test, const Registry& registry,
                           const CommonOptions& common) {
    std::string hashes = program_identity() + "\n" + test.preset + "\n" + joined(test.set, "\n");
    for (const json::Member& member : test.object.children())
        if (member.key != "expect" && member.key != "cases")
            hashes += "\n" + std::string(member.key) + " " + json::one_line(member.value);
    for (const std::string& path : case_inputs(test, registry, common)) {
        std::string why;
        hashes += "\n" + path + " " + sha256(read_file(path, why).value_or(""));
    }
    return sha256(hashes);
}

}  // namespace wrinkle::cli
