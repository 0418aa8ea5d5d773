// How long the window took, for whoever asks (`wrinkle-editor --timings FILE`): the start, frames,
// and the way from an edit to the first frame that shows its pixels. Milliseconds.
//
// An edit counts from the frame that sees its new document to the end of the frame that shows the
// picture made of it. A script's `section NAME` begins a new part.
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
    // The picture that was shown is of this version; all that was asked for up to it is there.
    void frame_ends(uint64_t shown);

    // The document changed in structure: job `compile` goes to the compiler.
    void structure(uint64_t compile);
    void compiled(uint64_t compile, uint64_t picture);  // its program is in this picture
    void values(uint64_t picture);                      // of a running program

    std::string to_json(uint64_t builds, uint64_t programs) const;

private:
    struct Section {
        std::string name = "start";
        std::vector<double> frames, structure, values;
        uint64_t builds = 0, programs = 0;  // when it began
    };
    struct Pending {
        Clock::time_point since;
        uint64_t compile = 0, picture = 0;  // 0: not known yet, none
    };
    Clock::time_point start_ = Clock::now(), frame_ = start_;
    double first_frame_ = 0, first_picture_ = 0;  // their ends
    std::vector<Section> sections_{1};
    std::vector<Pending> pending_;
};

}  // namespace wrinkle::editor
