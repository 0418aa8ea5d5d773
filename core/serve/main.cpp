// wrinkle-watch-server PORT: the page of `wrinkle watch --serve`, which starts it with a socket
// (SOCK_SEQPACKET) as standard input. It sends the port, or nothing if it has none, and ends when
// the socket is closed. A message is the state as JSON, then the paths of the outputs, each ended
// by a zero byte.
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>

#include "base/text.h"
#include "serve/server.h"

int main(int argc, char** argv) {
    using namespace wrinkle;
    const auto wanted = whole_number(argc == 2 ? argv[1] : "");
    if (!wanted || *wanted > 65535) return 2;
    serve::State state;
    serve::Server server(state);
    const auto port = server.listen(static_cast<int>(*wanted));
    if (!port) return 1;
    const std::string answer = std::to_string(*port);
    if (send(STDIN_FILENO, answer.data(), answer.size(), MSG_NOSIGNAL) < 0) return 1;
    std::string message(size_t{1} << 18, '\0');
    ssize_t size = 0;
    while ((size = recv(STDIN_FILENO, message.data(), message.size(), 0)) > 0) {
        const std::string_view text(message.data(), static_cast<size_t>(size));
        const auto parts = split(text, '\0');
        std::vector<std::filesystem::path> outputs;
        for (size_t i = 1; i + 1 < parts.size(); ++i)
            outputs.emplace_back(parts[i]);
        state.set(std::string(parts[0]), std::move(outputs));
    }
    std::_Exit(0);  // does not wait for open connections
}
