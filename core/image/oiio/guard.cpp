#include "image/oiio/guard.h"

#include <unistd.h>

#ifdef WRINKLE_SANITIZED
#include <sanitizer/lsan_interface.h>
#endif

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <mutex>

namespace wrinkle::oiio {

namespace {

thread_local int quiet_depth = 0;

ssize_t write_unless_quiet(void*, const char* text, size_t size) {
    return quiet_depth > 0 ? static_cast<ssize_t>(size) : write(STDERR_FILENO, text, size);
}

void exempt_from_leak_check([[maybe_unused]] bool exempt) {
#ifdef WRINKLE_SANITIZED
    exempt ? __lsan_disable() : __lsan_enable();
#endif
}

// `stderr` is a variable in glibc; it holds the filter while any thread has a Quiet.
struct Filter {
    std::mutex mutex;
    int users = 0;
    std::FILE* original = nullptr;
    std::FILE* stream = nullptr;

    Filter() {
        cookie_io_functions_t functions = {};
        functions.write = write_unless_quiet;
        stream = fopencookie(nullptr, "w", functions);
        if (stream) std::setvbuf(stream, nullptr, _IONBF, 0);
    }
};

// Never destroyed: a thread may still print through it at exit.
Filter& filter() {
    static Filter* const the = new Filter;
    return *the;
}

}  // namespace

Quiet::Quiet() {
    ++quiet_depth;
    exempt_from_leak_check(true);
    Filter& shared = filter();
    const std::lock_guard lock(shared.mutex);
    if (shared.users++ > 0 || !shared.stream) return;
    shared.original = stderr;
    stderr = shared.stream;
}

Quiet::~Quiet() {
    Filter& shared = filter();
    {
        const std::lock_guard lock(shared.mutex);
        if (--shared.users == 0 && shared.stream) stderr = shared.original;
    }
    exempt_from_leak_check(false);
    --quiet_depth;
}

std::string sentence(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' '))
        text.pop_back();
    std::ranges::replace(text, '\n', ' ');
    return text.empty() ? "it ends early or holds impossible values" : text;
}

void set_text(WrinkleImageText why, const std::string& text) {
    if (why.capacity == 0) return;
    const size_t count = std::min<size_t>(text.size(), why.capacity - 1);
    std::memcpy(why.text, text.data(), count);
    why.text[count] = 0;
}

// Sets OpenImageIO's attributes once: no threads and no size limit, because the caller has both.
void set_up_once() {
    static std::once_flag once;
    std::call_once(once, [] {
        OIIO::attribute("threads", 1);
        OIIO::attribute("exr_threads", -1);
        OIIO::attribute("tiff:half", 1);
        OIIO::attribute("limits:imagesize_MB", 0);
    });
}

}  // namespace wrinkle::oiio
