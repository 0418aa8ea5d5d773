// HTTP server of the page of `wrinkle watch --serve`, on 127.0.0.1 and, if the machine has it, ::1.
//
//   /             the page, with /watch.js and /watch.css
//   /state        the last build as JSON
//   /events       server-sent events: one per build
//   /output/N     output N of the last build; no other file can be named
#pragma once

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace wrinkle::serve {

// The last build. Thread-safe.
class State {
public:
    void set(std::string json, std::vector<std::filesystem::path> outputs);
    std::string json() const;
    // Returns std::nullopt if no output has this number.
    std::optional<std::filesystem::path> output(size_t number) const;
    // Waits until another build than `seen` is set, 10 s at most; returns the number of the build.
    size_t wait(size_t seen) const;

private:
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::string json_ = "{}";
    std::vector<std::filesystem::path> outputs_;
    size_t number_ = 0;
};

class Server {
public:
    explicit Server(const State& state);  // which outlives the server
    ~Server();

    // Listens on `port`, 0 for any, on new threads. Returns the port; std::nullopt if it
    // cannot be bound.
    std::optional<int> listen(int port);

private:
    struct Sockets;
    std::unique_ptr<Sockets> sockets_;
};

}  // namespace wrinkle::serve
