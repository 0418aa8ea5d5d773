// How far long work is: a line that is written over on a terminal, a line of JSON each time for
// tools, nothing in a pipe.
//
//   {"done": 131072, "total": 1048576, "per_second": 5.2e7, "seconds_left": 0.02}
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace wrinkle::cli {

class Progress {
public:
    enum class Form : uint8_t { none, line, json };

    // `unit` is counted: "texels".
    Progress(Form form, std::string unit, uint64_t total);
    ~Progress();  // takes the line away
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    static Form form_for(bool json);  // a line where standard error is a terminal

    // What was done in another run counts for no rate.
    void skip(uint64_t count);
    void add(uint64_t count);

private:
    using Clock = std::chrono::steady_clock;
    void show(double seconds) const;

    Form form_;
    std::string unit_;
    uint64_t total_, done_ = 0, skipped_ = 0;
    Clock::time_point begun_ = Clock::now(), shown_{};
};

}  // namespace wrinkle::cli
