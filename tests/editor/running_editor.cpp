#include "running_editor.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cstdlib>

namespace wrinkle::editor {

RunningEditor::RunningEditor(const VirtualScreen& screen,
                             const std::vector<std::string>& arguments) {
    int ends[2];
    if (pipe(ends) != 0) return;
    process_ = fork();
    if (process_ == 0) {
        dup2(ends[1], STDOUT_FILENO);
        dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
        close(ends[0]);
        std::string display = screen.variable();
        putenv(display.data());
        unsetenv("WAYLAND_DISPLAY");
        unsetenv("WRINKLE_PLUGIN_PATH");
        setenv("WRINKLE_NO_DEFAULT_PLUGINS", "1", 1);
        std::vector<char*> words = {const_cast<char*>(WRINKLE_EDITOR)};
        for (const std::string& argument : arguments)
            words.push_back(const_cast<char*>(argument.c_str()));
        words.push_back(nullptr);
        execv(WRINKLE_EDITOR, words.data());
        _exit(127);
    }
    close(ends[1]);
    output_ = ends[0];
}

RunningEditor::~RunningEditor() {
    kill();
    close(output_);
}

void RunningEditor::listen(Clock::time_point end, const char* word) {
    while (Clock::now() < end) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
        pollfd waiting{output_, POLLIN, 0};
        if (poll(&waiting, 1, static_cast<int>(left.count()) + 1) <= 0) continue;
        if (!take()) return;
        if (word && said_.find(word) != said_.npos) return;
    }
}

const std::string& RunningEditor::kill() {
    if (process_ <= 0) return said_;
    ::kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    process_ = -1;
    while (take()) {
    }
    return said_;
}

bool RunningEditor::take() {
    char bytes[256];
    const ssize_t count = read(output_, bytes, sizeof bytes);
    if (count > 0) said_.append(bytes, static_cast<size_t>(count));
    return count > 0;
}

}  // namespace wrinkle::editor
