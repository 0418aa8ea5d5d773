#include "cli/test_review.h"

#include <spawn.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <set>

#include "base/file.h"
#include "base/printable.h"
#include "cli/test_report.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

using report::Check;

constexpr const char* keys =
    "a accept, s skip, r reject; A, S, R the rest; d show again, o open the image, q quit";

// Opens a file with the program of the desktop; does not wait.
void open_file(const fs::path& file) {
    std::string name = "xdg-open", path = file.string();
    char* const arguments[] = {name.data(), path.data(), nullptr};
    pid_t process = 0;
    if (posix_spawnp(&process, name.c_str(), nullptr, nullptr, arguments, environ) != 0)
        std::printf("%s\n", printable(path).c_str());
}

class Review {
public:
    Review(report::Results& results, const fs::path& folder, const Registry& registry,
           const CommonOptions& common)
        : results_(results), folder_(folder), registry_(registry), common_(common) {}

    Acceptance run() {
        std::set<std::string> pending;
        for (const Check& check : results_.checks)
            if (is_pending(check)) pending.insert(check.id());
        const size_t count = pending.size();
        std::printf("%zu to review. %s\n", count, keys);
        for (size_t i = 1; !pending.empty() && !quits_; ++i) {
            const Check* check = next_of(pending);
            pending.erase(check->id());
            std::printf("\n%zu of %zu  ", i, count);
            show(*check);
            while (!decide(*check, pending)) {
            }
        }
        return std::move(all_);
    }

private:
    const Check* next_of(const std::set<std::string>& pending) const {
        for (const Check& check : results_.checks)
            if (pending.contains(check.id())) return &check;
        return nullptr;
    }

    void show(const Check& check) const {
        std::printf("%s\n  %s\n", printable(check.id()).c_str(), printable(check.message).c_str());
        for (const report::Measured& each : check.measured)
            if (!each.within())
                std::printf("  %s: %s -> %s\n", printable(each.name).c_str(),
                            printable(each.expected).c_str(), printable(each.actual).c_str());
        if (!check.actual_image.empty())
            std::printf("  %s\n", printable((folder_ / check.actual_image).string()).c_str());
    }

    // Reads one command; returns true after a decision.
    bool decide(const Check& check, std::set<std::string>& pending) {
        std::printf("> ");
        std::fflush(stdout);
        std::string line;
        if (!std::getline(std::cin, line)) line = "q";
        std::set<std::string> decided = {check.id()};
        if (line == "A" || line == "R" || line == "S") decided.merge(pending);
        if (line == "A" || line == "R" || line == "S") pending.clear();
        if (line == "a" || line == "A") return accept_these(decided);
        if (line == "r" || line == "R") return reject(decided);
        if (line == "d") show(check);
        if (line == "o")
            open_file(folder_ / (check.actual_image.empty() ? "index.html" : check.actual_image));
        if (line == "q") quits_ = true;
        const bool known = line.size() == 1 &&
                           std::string_view("asrASRdoq").find(line[0]) != std::string_view::npos;
        if (!known) std::printf("%s\n", keys);
        return line == "s" || line == "S" || quits_;
    }

    bool accept_these(const std::set<std::string>& ids) {
        Acceptance accepted = accept(
            results_, folder_, [&](const Check& each) { return ids.contains(each.id()); },
            registry_, common_);
        for (const std::string& file : accepted.written)
            std::printf("  wrote %s\n", printable(file).c_str());
        for (const std::string& sentence : accepted.refused)
            std::printf("  refused %s\n", printable(sentence).c_str());
        all_.written.insert(all_.written.end(), accepted.written.begin(), accepted.written.end());
        all_.refused.insert(all_.refused.end(), accepted.refused.begin(), accepted.refused.end());
        if (all_.environment.empty()) all_.environment = accepted.environment;
        return save();
    }

    bool reject(const std::set<std::string>& ids) {
        std::erase_if(results_.checks, [&](const Check& each) { return ids.contains(each.id()); });
        return save();
    }

    bool save() {
        std::string why;
        if (!write_report(results_, folder_, why) && all_.environment.empty())
            all_.environment = why;
        return true;
    }

    report::Results& results_;
    const fs::path& folder_;
    const Registry& registry_;
    const CommonOptions& common_;
    Acceptance all_;
    bool quits_ = false;
};

}  // namespace

Acceptance review_results(report::Results& results, const fs::path& folder,
                          const Registry& registry, const CommonOptions& common) {
    return Review(results, folder, registry, common).run();
}

}  // namespace wrinkle::cli
