// The calls that a node's build() makes of its builder, as data: recorded in the process that runs
// the plugin's code, replayed in the one that lowers the graph.
//
// build() learns nothing of the graph but its options: values, images and regions are numbers that
// mean something to the host alone. So a recorder answers each call with the next number, and the
// replay puts the host's numbers in their place. What a call gets that makes no sense is therefore
// seen by the host alone, which records the diagnostic; the plugin gets a number, not poison.
//
// A recording comes from a process whose memory a plugin may have written over: replay() believes
// none of its sizes, and the host checks each call as if the plugin made it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "wrinkle/plugin.h"

namespace wrinkle {

inline constexpr size_t max_build_calls = 100'000;  // of one node
inline constexpr uint32_t max_build_values = 65;    // that one call takes or gives

class Recorder {
public:
    // `options` by port. `on_full` is called instead of a call beyond max_build_calls; it does not
    // return.
    Recorder(std::span<const int32_t> options, void (*on_full)());
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    const wr_builder* builder() const { return &face_; }
    const std::string& calls() const { return calls_; }

    // For the functions of the builder.
    void begin(uint32_t call);
    void word(uint32_t value);
    void words(const uint32_t* values, uint32_t count);  // too many are not copied
    void number(double value);
    void text(const char* source);  // cut off behind what a text may have
    uint32_t next() { return ++last_; }
    int32_t option(uint32_t port) const { return port < options_.size() ? options_[port] : 0; }

private:
    wr_builder face_{};
    std::span<const int32_t> options_;
    void (*on_full_)();
    std::string calls_;
    size_t count_ = 0;
    uint32_t last_ = 0;
};

// Makes the calls of `host`. False when they are damaged: what came before the damage was called.
bool replay(std::string_view calls, const wr_builder* host);

}  // namespace wrinkle
