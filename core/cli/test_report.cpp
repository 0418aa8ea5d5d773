#include "cli/test_report.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <set>

#include "base/file.h"
#include "base/printable.h"
#include "cli/arguments.h"
#include "report/page.h"
#include "report/results_json.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

using report::Check;
using report::Status;

constexpr std::array image_folders = {"expected", "actual", "map", "joined"};

std::array<std::string Check::*, 4> image_members() {
    return {&Check::expected_image, &Check::actual_image, &Check::map_image, &Check::joined_image};
}

// Removes images that no check names, and folders without any.
void remove_images(const fs::path& folder, const report::Results& results) {
    std::set<fs::path> named;
    for (const Check& check : results.checks)
        for (const auto member : image_members())
            if (!(check.*member).empty())
                named.insert((folder / (check.*member)).lexically_normal());
    std::error_code problem;
    for (const char* name : image_folders) {
        if (!is_in_report(folder, folder / name)) continue;
        std::vector<fs::path> unnamed;
        for (fs::directory_iterator at(folder / name, problem), end; !problem && at != end;
             at.increment(problem))
            if (at->path().extension() == ".png" && !named.contains(at->path().lexically_normal()))
                unnamed.push_back(at->path());
        for (const fs::path& file : unnamed)
            fs::remove(file, problem);
        fs::remove(folder / name, problem);  // fails if it is not empty
    }
}

bool has_report(const fs::path& folder) {
    std::error_code ignored;
    return fs::exists(folder / results_file, ignored);
}

std::string place_of(const Check& check) {
    if (check.status == Status::deleted) return check.file;
    return check.line ? check.file + ":" + std::to_string(check.line) : check.file;
}

const char* verdict_of(Status status) {
    switch (status) {
        case Status::added:
            return "NEW";
        case Status::deleted:
            return "DELETED";
        case Status::error:
            return "ERROR";
        default:
            return "FAIL";
    }
}

const char* fixed_time() {
    return std::getenv("SOURCE_DATE_EPOCH");
}

}  // namespace

std::string time_of_report() {
    std::time_t now = std::time(nullptr);
    if (fixed_time()) parse_number(std::string_view(fixed_time()), now);
    std::tm utc{};
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", gmtime_r(&now, &utc));
    return text;
}

void clear_durations_if_reproducible(report::Results& results) {
    if (!fixed_time()) return;
    results.seconds = 0;
    for (Check& check : results.checks)
        check.seconds = 0;
}

bool is_in_report(const fs::path& folder, const fs::path& file) {
    return inside(folder, link_target(file)) &&
           (folder != default_report || inside(".", link_target(folder)));
}

bool make_report_folder(const fs::path& folder, std::string& why) {
    for (const char* name : {page_file, results_file})
        if (!is_in_report(folder, folder / name)) {
            why = (folder / name).string() + ": leads outside the report";
            return false;
        }
    std::error_code problem;
    fs::create_directories(folder, problem);
    if (problem) {
        why = folder.string() + ": cannot be created: " + problem.message();
        return false;
    }
    if (!has_report(folder) && fs::exists(folder / page_file, problem)) {
        why = (folder / page_file).string() + ": is not of a report";
        return false;
    }
    if (folder != default_report) return true;
    const fs::path ignore = folder.parent_path() / ".gitignore";
    if (!inside(".", link_target(ignore))) return true;
    if (write_file(ignore, "*\n", why)) return true;
    why = ignore.string() + ": " + why;
    return false;
}

bool write_report(const report::Results& results, const fs::path& folder, std::string& why) {
    if (!make_report_folder(folder, why)) return false;
    if (has_report(folder)) remove_images(folder, results);
    const std::string page = report::page(results, folder);
    const std::string json = report::to_json(results);
    const FileBytes files[] = {{folder / page_file, page}, {folder / results_file, json}};
    return write_files(files, why);
}

void remove_report(const fs::path& folder) {
    if (!has_report(folder)) return;
    remove_images(folder, {});
    std::error_code ignored;
    for (const char* name : {page_file, results_file})
        fs::remove(folder / name, ignored);
}

bool merge_report(const fs::path& shard, const fs::path& folder, report::Results& results,
                  std::string& why) {
    Diagnostics problems;
    auto part = report::read_results(shard / results_file, problems);
    if (!part) {
        why = to_text(problems.list().front());
        return false;
    }
    for (Check& check : part->checks) {
        for (const auto member : image_members()) {
            std::string& image = check.*member;
            if (image.empty()) continue;
            const auto from = inside(shard, shard / image);
            const auto bytes = from ? read_file(*from, why) : std::nullopt;
            if (!bytes) {
                image.clear();
                continue;
            }
            const fs::path to = folder / image;
            if (!is_in_report(folder, to)) continue;
            std::error_code ignored;
            fs::create_directories(to.parent_path(), ignored);
            if (!write_file(to, *bytes, why)) return false;
        }
        results.checks.push_back(std::move(check));
    }
    results.seconds += part->seconds;
    results.added_fails = results.added_fails || part->added_fails;
    if (results.driver.empty()) results.driver = part->driver;
    if (results.command.empty()) results.command = part->command;
    if (results.started.empty() || part->started < results.started) results.started = part->started;
    results.causes.insert(results.causes.end(), part->causes.begin(), part->causes.end());
    results.problems.insert(results.problems.end(), part->problems.begin(), part->problems.end());
    return true;
}

std::string failures_text(const report::Results& results) {
    std::string text;
    for (const Check& check : results.checks) {
        if (check.status == Status::passed) continue;
        text += verdict_of(check.status);
        text += " " + printable(check.id() + ": " + check.message + " (" + place_of(check) + ")") +
                "\n";
    }
    return text;
}

std::string counts_text(const report::Results& results) {
    std::string text =
        std::to_string(results.count(Status::passed)) + " passed, " +
        std::to_string(results.count(Status::failed) + results.count(Status::error)) + " failed";
    for (const Status status : {Status::added, Status::deleted})
        if (const size_t count = results.count(status))
            text += ", " + std::to_string(count) + " " + std::string(report::name_of(status));
    return text;
}

}  // namespace wrinkle::cli
