#include "registry/probe.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "base/folders.h"
#include "base/text.h"
#include "json/parse.h"
#include "registry/library.h"

namespace wrinkle {
namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t most_output = 64 << 20;  // bytes
constexpr auto short_while = std::chrono::milliseconds(10);

std::string probe_program() {
    return (installation_folder() / "lib/wrinkle/wrinkle-plugin-probe").string();
}

// What a probe said and how it ended.
struct Ended {
    std::string said;
    bool late = false;
    bool too_much = false;
    siginfo_t how{};
};

class Process {
public:
    // Not started when `error` is set.
    Process(const std::string& program, const std::string& path, const std::string& sha256) {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) {
            error = errno;
            return;
        }
        posix_spawn_file_actions_t files;
        posix_spawn_file_actions_init(&files);
        for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
            posix_spawn_file_actions_addopen(&files, file, "/dev/null", O_RDWR, 0);
        posix_spawn_file_actions_adddup2(&files, ends[1], probe_output);
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
        char* const words[] = {const_cast<char*>(program.c_str()), const_cast<char*>(path.c_str()),
                               const_cast<char*>(sha256.c_str()), nullptr};
        error = posix_spawn(&process_, program.c_str(), &files, &attributes, words, environ);
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&files);
        close(ends[1]);
        output_ = ends[0];
        fcntl(output_, F_SETFL, O_NONBLOCK);
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process() {
        if (output_ >= 0) close(output_);
    }

    Ended finish(std::chrono::milliseconds limit) {
        Ended ended;
        const auto end = Clock::now() + limit;
        bool open = true;
        while (!has_exited(ended.how)) {
            ended.late = Clock::now() >= end;
            ended.too_much = ended.said.size() > most_output;
            if (ended.late || ended.too_much) break;
            pollfd waiting{open ? output_ : -1, POLLIN, 0};
            poll(&waiting, 1, static_cast<int>(short_while.count()));
            open = open && take(ended.said);
        }
        kill(-process_, SIGKILL);  // before it is waited for: the number of its group is still its
        while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
        if (open) take(ended.said);  // no longer: a child that left the group may hold it open
        return ended;
    }

    int error = 0;

private:
    bool has_exited(siginfo_t& how) const {
        how = {};
        waitid(P_PID, static_cast<id_t>(process_), &how, WEXITED | WNOHANG | WNOWAIT);
        return how.si_pid == process_;
    }

    // False at the end of what there is, and when nothing has come.
    bool take(std::string& said) const {
        char part[1 << 16];
        ssize_t count = 0;
        while ((count = read(output_, part, sizeof part)) > 0 && said.size() <= most_output)
            said.append(part, static_cast<size_t>(count));
        return count < 0 && (errno == EAGAIN || errno == EINTR);
    }

    pid_t process_ = -1;
    int output_ = -1;
};

std::string while_doing(std::string_view stage) {
    if (stage == "load") return "while it was loaded";
    if (stage == "enter") return "in its wrinkle_plugin()";
    return "while its descriptors were read";
}

std::string signal_text(int number) {
    const char* name = sigabbrev_np(number);
    const char* words = sigdescr_np(number);
    return (name ? "SIG" + std::string(name) : "signal " + std::to_string(number)) +
           (words ? " (" + std::string(words) + ")" : "");
}

// Takes the lines of stages off the front of `said`; the last one.
std::string last_stage(std::string_view& said) {
    std::string stage = "load";
    while (said.starts_with(probe_stage)) {
        const size_t end = said.find('\n');
        if (end == said.npos) break;
        stage = said.substr(probe_stage.size(), end - probe_stage.size());
        said.remove_prefix(end + 1);
    }
    return stage;
}

// Faults as the probe wrote them: base/diagnostics.h to_json().
void read_faults(std::string_view text, const std::string& origin, Diagnostics& diagnostics) {
    Diagnostics none;
    const json::Value root = json::parse(std::string(text), origin, none).root;
    const auto word = [](const json::Value& object, std::string_view key) {
        const json::Value value = object.is(json::Kind::object) ? object.find(key) : json::Value();
        return value.is(json::Kind::string) ? std::string(value.as_string()) : std::string();
    };
    if (!root.is(json::Kind::object)) return;
    for (const json::Member& each : root.find("diagnostics").children()) {
        Diagnostic fault;
        fault.where.file = origin;
        fault.node = word(each.value, "node");
        fault.message = word(each.value, "message");
        fault.expected = word(each.value, "expected");
        if (!fault.message.empty()) diagnostics.add(std::move(fault));
    }
}

std::string ending(const Ended& ended, const std::string& doing, std::chrono::milliseconds limit) {
    if (ended.late)
        return "it hung " + doing + ": it was ended after " +
               shortest(std::chrono::duration<double>(limit).count()) + " s";
    if (ended.too_much) return "it describes more than can be";
    if (ended.how.si_code != CLD_EXITED)
        return "it crashed " + doing + ": " + signal_text(ended.how.si_status);
    return "it ended the program " + doing + ", with exit code " +
           std::to_string(ended.how.si_status);
}

}  // namespace

std::optional<PluginListing> probe_plugin(const std::string& path, const std::string& sha256,
                                          const std::string& origin,
                                          std::chrono::milliseconds limit,
                                          Diagnostics& diagnostics) {
    const std::string program = probe_program();
    Process process(program, path, sha256);
    if (process.error != 0) {
        add_fault(diagnostics, origin,
                  "it cannot be looked into: " + program + ": " + strerror(process.error),
                  "that program is installed beside this one");
        return std::nullopt;
    }
    const Ended ended = process.finish(limit);
    std::string_view said = ended.said;
    const std::string doing = while_doing(last_stage(said));
    const bool whole = !ended.late && !ended.too_much && ended.how.si_code == CLD_EXITED &&
                       ended.how.si_status == 0;
    if (whole && said.starts_with(probe_fine))
        return read_listing(std::string(said.substr(probe_fine.size())), origin, origin,
                            diagnostics);
    const size_t before = diagnostics.error_count();
    if (whole && said.starts_with(probe_refused))
        read_faults(said.substr(probe_refused.size()), origin, diagnostics);
    if (diagnostics.error_count() == before)
        add_fault(diagnostics, origin, ending(ended, doing, limit));
    return std::nullopt;
}

}  // namespace wrinkle
