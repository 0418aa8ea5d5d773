// Timings of the window in milliseconds (`wrinkle-editor --timings FILE`): startup, frames, and the
// latency from an edit to the first frame that shows its pixels.
//
// An edit is measured from the frame that detects the new document to the end of the frame that
// shows its rendering. The script step `section NAME` begins a new section.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace wrinkle::editor {

class Timings {
public:
    using Clock = std::chrono::steady_clock;

    void section(std::string name, uint64_t builds, uint64_t programs);
    void frame_begins() { frame_ = Clock::now(); }
    // `shown` is the version of the rendering in this frame; edits up to it are complete.
    void frame_ends(uint64_t shown);

    // The structure of the document or the preview request changed; `compile` is the version of the
    // compile job.
    void structure(uint64_t compile);
    void compiled(uint64_t compile, uint64_t picture);  // version of its first rendering
    void values(uint64_t picture);                      // only uniform values changed

    std::string to_json(uint64_t builds, uint64_t programs) const;

private:
    struct Section {
        std::string name = "start";
        std::vector<double> frames = {}, structure = {}, values = {};
        uint64_t builds = 0, programs = 0;  // counts at its begin
    };
    struct Pending {
        Clock::time_point since;
        uint64_t compile = 0, picture = 0;  // versions; 0: not known yet, or none
    };
    Clock::time_point start_ = Clock::now(), frame_ = start_;
    double first_frame_ = 0, first_picture_ = 0;  // ends, since the start
    std::vector<Section> sections_{1};
    std::vector<Pending> pending_;
};

}  // namespace wrinkle::editor
