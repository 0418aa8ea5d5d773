#include "cli/watch_page.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/folders.h"
#include "base/text.h"
#include "cli/arguments.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

constexpr size_t max_text = size_t{1} << 16, max_outputs = 16;

std::string kind_of(const fs::path& file) {
    const std::string type = file.extension().string();
    if (type == ".png" || type == ".jpg" || type == ".jpeg") return "image";
    if (type == ".html") return "page";
    for (const char* binary : {".exr", ".tif", ".tiff", ".hdr", ".spv", ".npy"})
        if (type == binary) return "file";
    return "text";
}

// Starts the server with one end of the socket as its standard input; returns 0 or an errno.
int spawn_server(int end, int port, pid_t& server) {
    const std::string program = (installation_folder() / "lib/wrinkle/wrinkle-watch-server");
    const std::string number = std::to_string(port);
    char* words[] = {const_cast<char*>(program.c_str()), const_cast<char*>(number.c_str()),
                     nullptr};
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, end, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    const int error = posix_spawn(&server, program.c_str(), &files, nullptr, words, environ);
    posix_spawn_file_actions_destroy(&files);
    return error;
}

}  // namespace

std::optional<WatchPage> WatchPage::start(int port, std::string& why) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) {
        why = std::strerror(errno);
        return {};
    }
    WatchPage page(ends[0], -1);
    const int error = spawn_server(ends[1], port, page.server_);
    close(ends[1]);
    if (error != 0) {
        why = std::string("wrinkle-watch-server cannot be started: ") + std::strerror(error);
        return {};
    }
    char answer[16] = {};
    const ssize_t size = recv(page.socket_, answer, sizeof answer, 0);
    if (size > 0 && parse_number({answer, static_cast<size_t>(size)}, page.port_)) return page;
    why = "port " + std::to_string(port) + " is in use; --port chooses another, 0 a free one";
    return {};
}

WatchPage::WatchPage(WatchPage&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)),
      server_(std::exchange(other.server_, -1)),
      port_(other.port_),
      builds_(other.builds_) {}

WatchPage& WatchPage::operator=(WatchPage&& other) noexcept {
    std::swap(socket_, other.socket_);
    std::swap(server_, other.server_);
    std::swap(port_, other.port_);
    std::swap(builds_, other.builds_);
    return *this;
}

WatchPage::~WatchPage() {
    if (socket_ >= 0) close(socket_);  // ends the server
    if (server_ > 0) waitpid(server_, nullptr, 0);
}

// A message that does not fit into the socket is dropped: a stopped server stops no build.
void WatchPage::send(const News& news) {
    const size_t count = std::min(news.outputs.size(), max_outputs);
    std::string list, paths;
    for (size_t i = 0; i < count; ++i) {
        const fs::path& file = news.outputs[i];
        list += (i ? ", " : "") + ("{\"name\": " + json_quoted(file.native())) + ", \"kind\": \"" +
                kind_of(file) + "\"}";
        paths += fs::absolute(file).native() + '\0';
    }
    const std::string message =
        "{\"build\": " + std::to_string(++builds_) + ", \"ok\": " + (news.ok ? "true" : "false") +
        ", \"made_outputs\": " + (news.made_outputs ? "true" : "false") +
        ", \"command\": " + json_quoted(news.command) + ", \"line\": " + json_quoted(news.line) +
        ", \"text\": " + json_quoted(news.text.substr(0, max_text)) + ", \"outputs\": [" + list +
        "]}" + '\0' + paths;
    ::send(socket_, message.data(), message.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
}

}  // namespace wrinkle::cli
