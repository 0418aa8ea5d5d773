#include "editor/view/timings.h"

#include <algorithm>
#include <cstdio>

#include "base/text.h"

namespace wrinkle::editor {
namespace {

double milliseconds(Timings::Clock::duration time) {
    return std::chrono::duration<double, std::milli>(time).count();
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

std::string list(const std::vector<double>& values) {
    return "[" + joined(values, ", ", number) + "]";
}

}  // namespace

void Timings::section(std::string name, uint64_t builds, uint64_t programs) {
    sections_.push_back({.name = std::move(name), .builds = builds, .programs = programs});
    pending_.clear();
}

void Timings::structure(uint64_t compile) {
    pending_.push_back({Clock::now(), compile, 0});
}

void Timings::compiled(uint64_t compile, uint64_t picture) {
    for (Pending& edit : pending_)
        if (edit.compile != 0 && edit.compile <= compile && edit.picture == 0)
            edit.picture = picture;
}

void Timings::values(uint64_t picture) {
    pending_.push_back({Clock::now(), 0, picture});
}

void Timings::frame_ends(uint64_t shown) {
    const Clock::time_point now = Clock::now();
    Section& section = sections_.back();
    section.frames.push_back(milliseconds(now - frame_));
    if (first_frame_ == 0) first_frame_ = milliseconds(now - start_);
    std::erase_if(pending_, [&](const Pending& edit) {
        if (edit.picture == 0 || edit.picture > shown) return false;
        if (first_picture_ == 0) first_picture_ = milliseconds(now - start_);
        (edit.compile != 0 ? section.structure : section.values)
            .push_back(milliseconds(now - edit.since));
        return true;
    });
}

std::string Timings::to_json(uint64_t builds, uint64_t programs) const {
    std::string text = "{\"first_frame_ms\": " + number(first_frame_) +
                       ", \"first_picture_ms\": " + number(first_picture_) + ", \"sections\": [\n";
    for (size_t i = 0; i < sections_.size(); ++i) {
        const Section& s = sections_[i];
        const bool last = i + 1 == sections_.size();
        std::vector<double> sorted = s.frames;
        std::ranges::sort(sorted);
        const double longest = sorted.empty() ? 0 : sorted.back();
        const double middle = sorted.empty() ? 0 : sorted[sorted.size() / 2];
        text += "  {\"section\": \"" + s.name +
                "\", \"frames\": " + std::to_string(s.frames.size()) +
                ", \"longest_frame_ms\": " + number(longest) +
                ", \"median_frame_ms\": " + number(middle) +
                ", \"structure_to_pixels_ms\": " + list(s.structure) +
                ", \"value_to_pixels_ms\": " + list(s.values) + ", \"builds\": " +
                std::to_string((last ? builds : sections_[i + 1].builds) - s.builds) +
                ", \"programs\": " +
                std::to_string((last ? programs : sections_[i + 1].programs) - s.programs) + "}" +
                (last ? "\n" : ",\n");
    }
    return text + "]}\n";
}

}  // namespace wrinkle::editor
