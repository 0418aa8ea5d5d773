// Tests of wrinkle watch --serve: the page and its outputs, and the requests that it refuses.
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

class WatchPageTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        put("g.json", ramp_graph("1.5"));
        const fs::path printed = folder.parent_path() / "printed";
        const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
        const int text = open(printed.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
        std::vector<std::string> words = {"watch", "--serve", "--port", "0"};
        words.insert(words.end(), command_.begin(), command_.end());
        child_ = start(words, nothing, nothing, text, {});
        close(nothing);
        close(text);
        std::string said;
        ASSERT_TRUE(becomes([&] {
            said = bytes_of(printed);
            return says(said, "watches ");
        })) << said;
        const std::string before = "http://localhost:";
        port_ = said.substr(said.find(before) + before.size());
        port_.resize(port_.find('\n'));
    }
    void TearDown() override {
        kill(child_, SIGTERM);
        int status = 0;
        waitpid(child_, &status, 0);
        EXPECT_EQ(status, 0);
    }

    template <class Condition>
    static bool becomes(Condition condition) {
        for (int i = 0; i < 6000; ++i) {
            if (condition()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return false;
    }

    // Sends a request and returns all of the response.
    std::string get_page(const std::string& path, const std::string& host,
                         const std::string& more = "") const {
        const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_in address = {};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<uint16_t>(std::stoi(port_)));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
        const std::string request = "GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\n" + more +
                                    "Connection: close\r\n\r\n";
        EXPECT_GT(send(socket, request.data(), request.size(), MSG_NOSIGNAL), 0);
        std::string response;
        char block[4096];
        ssize_t count = 0;
        while ((count = read(socket, block, sizeof block)) > 0)
            response.append(block, static_cast<size_t>(count));
        close(socket);
        return response;
    }
    std::string own() const { return "localhost:" + port_; }
    std::string code(const std::string& path, const std::string& host,
                     const std::string& more = "") const {
        return get_page(path, host, more).substr(9, 3);
    }

    std::vector<std::string> command_ = {"compile", "g.json", "-o", "out.glsl"};
    std::string port_;
    pid_t child_ = -1;
};

TEST_F(WatchPageTest, ShowsOutputsAndErrors) {
    EXPECT_TRUE(says(get_page("/", own()), "default-src 'none'"));
    EXPECT_TRUE(becomes([&] {  // the server receives the outcome of the build
        return get_page("/state", own()).find("\"name\": \"out.glsl\"") != std::string::npos;
    }));
    EXPECT_TRUE(get_page("/output/0", own()).ends_with(get("out.glsl")));
    EXPECT_TRUE(says(get_page("/output/0", own()), "X-Content-Type-Options: nosniff"));
    put("g.json", "[]");
    EXPECT_TRUE(becomes([&] {
        return get_page("/state", own()).find("g.json:1:1: error: ") != std::string::npos;
    }));
    EXPECT_TRUE(says(get_page("/state", own()), "\"name\": \"out.glsl\""));
    EXPECT_TRUE(says(get_page("/state", own()), "\"made_outputs\": false"));
}

class TestPageTest : public WatchPageTest {
protected:
    TestPageTest() { command_ = {"test", "g.test.json", "--report", "out"}; }
    void SetUp() override {
        put("g.test.json", R"({"points": [{"normal": [0, 0, 1]}], "expect": [{"heigth": 3}]})");
        WatchPageTest::SetUp();
    }
};

TEST_F(TestPageTest, ShowsTheReportOfAFailedRun) {
    std::string state;  // the server receives the outcome of the build
    EXPECT_TRUE(becomes([&] {
        state = get_page("/state", own());
        return state.find("\"ok\": false") != std::string::npos;
    })) << state;
    EXPECT_TRUE(says(state, "\"made_outputs\": true")) << state;
    EXPECT_TRUE(says(state, "\"outputs\": [{\"name\": \"out/index.html\", \"kind\": \"page\"}]"))
        << state;
    EXPECT_TRUE(says(get_page("/output/0", own()), "Failed</h1>"));
}

TEST_F(WatchPageTest, AnswersItsOwnPagesOnly) {
    for (const char* host : {"localhost:", "127.0.0.1:", "[::1]:"})
        EXPECT_EQ(code("/state", host + port_), "200") << host;
    for (const std::string& host :
         {std::string("evil.example"), "evil.example:" + port_, "127.0.0.1.evil.example:" + port_,
          std::string("localhost"), std::string("localhost:1"), std::string()})
        EXPECT_EQ(code("/state", host), "403") << host;
    EXPECT_EQ(code("/state", own(), "Host: evil.example\r\n"), "403");
    EXPECT_EQ(code("/state", own(), "Origin: http://" + own() + "\r\n"), "200");
    for (const std::string& origin : {std::string("null"), std::string("http://evil.example"),
                                      "https://" + own(), std::string("http://localhost:1")})
        EXPECT_EQ(code("/state", own(), "Origin: " + origin + "\r\n"), "403") << origin;
    EXPECT_EQ(code("/output/0", own(), "Sec-Fetch-Site: cross-site\r\n"), "403");
    EXPECT_EQ(get_page("/state", own()).find("Access-Control"), std::string::npos);
}

TEST_F(WatchPageTest, NamesNoFileButOutputs) {
    for (const char* path : {"/g.json", "/output/1", "/output/-1", "/output/99999999999999999999",
                             "/output/../../etc/passwd", "/output/..%2f..%2fetc%2fpasswd",
                             "//etc/passwd", "/%2e%2e/etc/passwd", "/output/0/../g.json"})
        EXPECT_EQ(code(path, own()), "404") << path;
}

TEST_F(WatchPageTest, APortHasOneServer) {
    const Ran ran = run({"watch", "--serve", "--port", port_, "compile", "g.json"});
    EXPECT_EQ(ran.code, 3);
    EXPECT_TRUE(says(ran.err, "is in use; --port"));
}

}  // namespace
}  // namespace wrinkle::test
