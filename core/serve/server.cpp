#include "serve/server.h"

#include <httplib.h>

#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "base/file.h"
#include "base/text.h"
#include "serve/guard.h"
#include "serve/page.h"

namespace wrinkle::serve {
namespace fs = std::filesystem;
namespace {

constexpr const char* page_policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; "
    "frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
// An output may be a page with scripts (wrinkle test --report): it gets no access to this one.
constexpr const char* output_policy =
    "sandbox allow-scripts; default-src 'none'; img-src data:; style-src 'unsafe-inline'; "
    "script-src 'unsafe-inline'; base-uri 'none'; form-action 'none'; frame-ancestors 'self'";

const char* type_of(const fs::path& file) {
    constexpr std::pair<const char*, const char*> types[] = {{".png", "image/png"},
                                                             {".jpg", "image/jpeg"},
                                                             {".jpeg", "image/jpeg"},
                                                             {".html", "text/html; charset=utf-8"},
                                                             {".exr", "application/octet-stream"},
                                                             {".tif", "application/octet-stream"},
                                                             {".tiff", "application/octet-stream"},
                                                             {".hdr", "application/octet-stream"},
                                                             {".spv", "application/octet-stream"}};
    for (const auto& [extension, type] : types)
        if (file.extension() == extension) return type;
    return "text/plain; charset=utf-8";
}

void send_output(const State& state, const httplib::Request& request, httplib::Response& response) {
    response.set_header("Content-Security-Policy", output_policy);
    const auto number = whole_number(request.matches[1].str());
    const auto file = number ? state.output(static_cast<size_t>(*number)) : std::nullopt;
    std::string why = "no such output";
    auto bytes = file ? read_file(*file, why) : std::nullopt;
    if (bytes) return response.set_content(std::move(*bytes), type_of(*file));
    response.status = 404;
    response.set_content(why + "\n", "text/plain; charset=utf-8");
}

// Ends when the browser closes the connection.
void send_events(const State& state, httplib::Response& response) {
    auto seen = std::make_shared<size_t>(0);
    response.set_chunked_content_provider(
        "text/event-stream", [&state, seen](size_t, httplib::DataSink& sink) {
            const size_t number = state.wait(*seen);
            const std::string text =
                number == *seen ? ": still here\n\n" : "data: " + std::to_string(number) + "\n\n";
            *seen = number;
            return sink.write(text.data(), text.size());
        });
}

void add_routes(httplib::Server& server, const State& state, const int& port) {
    server.new_task_queue = [] { return new httplib::ThreadPool(32); };  // one per open connection
    server.set_socket_options([](int socket) {  // no SO_REUSEPORT: a port has one server
        const int yes = 1;
        setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server.set_default_headers({{"X-Content-Type-Options", "nosniff"},
                                {"Cache-Control", "no-store"},
                                {"Referrer-Policy", "no-referrer"},
                                {"Cross-Origin-Resource-Policy", "same-origin"}});
    server.set_pre_routing_handler([&port](const httplib::Request& q, httplib::Response& r) {
        const std::string host = q.get_header_value("Host"), origin = q.get_header_value("Origin"),
                          site = q.get_header_value("Sec-Fetch-Site");
        if (q.get_header_value_count("Host") == 1 && is_allowed({host, origin, site}, port))
            return httplib::Server::HandlerResponse::Unhandled;
        r.status = 403;
        r.set_content("only pages of this server may use it\n", "text/plain; charset=utf-8");
        return httplib::Server::HandlerResponse::Handled;
    });
    const auto add = [&](const char* path, std::string_view text, const char* type) {
        server.Get(path, [text, type](const httplib::Request&, httplib::Response& r) {
            r.set_header("Content-Security-Policy", page_policy);
            r.set_content(std::string(text), type);
        });
    };
    add("/", texts::index_html, "text/html; charset=utf-8");
    add("/watch.js", texts::watch_js, "text/javascript; charset=utf-8");
    add("/watch.css", texts::watch_css, "text/css; charset=utf-8");
    server.Get("/state", [&](const httplib::Request&, httplib::Response& r) {
        r.set_content(state.json(), "application/json");
    });
    server.Get("/events",
               [&](const httplib::Request&, httplib::Response& r) { send_events(state, r); });
    server.Get(R"(/output/(\d{1,9}))",
               [&](const httplib::Request& q, httplib::Response& r) { send_output(state, q, r); });
}

}  // namespace

void State::set(std::string json, std::vector<fs::path> outputs) {
    const std::lock_guard lock(mutex_);
    json_ = std::move(json);
    outputs_ = std::move(outputs);
    ++number_;
    changed_.notify_all();
}

std::string State::json() const {
    const std::lock_guard lock(mutex_);
    return json_;
}

std::optional<fs::path> State::output(size_t number) const {
    const std::lock_guard lock(mutex_);
    if (number >= outputs_.size()) return {};
    return outputs_[number];
}

size_t State::wait(size_t seen) const {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::seconds(10), [&] { return number_ != seen; });
    return number_;
}

struct Server::Sockets {
    httplib::Server ipv4, ipv6;
    std::vector<std::thread> threads;
    int port = 0;
};

Server::Server(const State& state) : sockets_(std::make_unique<Sockets>()) {
    add_routes(sockets_->ipv4, state, sockets_->port);
    add_routes(sockets_->ipv6, state, sockets_->port);
}

Server::~Server() {
    sockets_->ipv4.stop();
    sockets_->ipv6.stop();
    for (std::thread& thread : sockets_->threads)
        thread.join();
}

std::optional<int> Server::listen(int port) {
    Sockets& s = *sockets_;
    if (port == 0)
        port = s.ipv4.bind_to_any_port("127.0.0.1");
    else if (!s.ipv4.bind_to_port("127.0.0.1", port))
        return {};
    if (port <= 0) return {};
    s.port = port;
    s.threads.emplace_back([&s] { s.ipv4.listen_after_bind(); });
    if (s.ipv6.bind_to_port("::1", port))
        s.threads.emplace_back([&s] { s.ipv6.listen_after_bind(); });
    return port;
}

}  // namespace wrinkle::serve
