// Recording of the builder calls of a node's build(): recorded in the process that runs plugin
// code, replayed in the process that lowers the graph.
//
// build() can read only the options of the graph: values, images and regions are opaque ids. So the
// recorder returns consecutive ids, and replay() maps them to those of the host. The recorder does
// not check arguments: build() receives an id other than WR_POISON even if the host later reports
// an error for that call.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "wrinkle/plugin.h"

namespace wrinkle {

inline constexpr size_t max_build_calls = 100'000;  // calls of one node
inline constexpr uint32_t max_build_values = 65;    // arguments or results of one call

class Recorder {
public:
    // `options` by port. `on_full` is called on a call beyond max_build_calls; it must not return.
    Recorder(std::span<const int32_t> options, void (*on_full)());
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    const wr_builder* builder() const { return &face_; }
    const std::string& calls() const { return calls_; }

    // Used by the functions of the builder.
    void add(std::string_view call);
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

// Makes the recorded calls on `host`. Returns false if the recording is damaged; the calls before
// the damage have then been made. The plugin may have corrupted the memory of the recording
// process: replay() validates all sizes, and the host checks each call as if the plugin made it.
bool replay(std::string_view calls, const wr_builder* host);

}  // namespace wrinkle
