// The page of `wrinkle watch --serve`: starts wrinkle-watch-server (core/serve) and sends it the
// outcome of each build.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wrinkle::cli {

class WatchPage {
public:
    // Listens on `port` of the loopback addresses, 0 for any. Returns std::nullopt and the reason
    // in `why` on failure.
    static std::optional<WatchPage> start(int port, std::string& why);
    WatchPage(WatchPage&& other) noexcept;
    WatchPage& operator=(WatchPage&& other) noexcept;
    ~WatchPage();

    int port() const { return port_; }

    struct News {
        bool ok = false;
        std::string command;  // "compile"
        std::string line, text;
        std::vector<std::filesystem::path> outputs;
        bool made_outputs = false;  // this build made them; otherwise an earlier one
    };
    void send(const News& news);

private:
    WatchPage(int socket, pid_t server) : socket_(socket), server_(server) {}

    int socket_ = -1;
    pid_t server_ = -1;
    int port_ = 0;
    size_t builds_ = 0;
};

}  // namespace wrinkle::cli
