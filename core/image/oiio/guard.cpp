#include "image/oiio/guard.h"

#include <algorithm>
#include <cstring>
#include <mutex>
#include <thread>

namespace wrinkle::oiio {

std::string sentence(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' '))
        text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.empty() ? "it ends early or holds impossible values" : text;
}

void tell(WrinkleImageText why, const std::string& text) {
    if (why.capacity == 0) return;
    const size_t count = std::min<size_t>(text.size(), why.capacity - 1);
    std::memcpy(why.text, text.data(), count);
    why.text[count] = 0;
}

// The caller has its own limits and its own threads.
void set_up_once() {
    static std::once_flag once;
    std::call_once(once, [] {
        OIIO::attribute("threads", 1);
        OIIO::attribute("exr_threads", -1);
        OIIO::attribute("tiff:half", 1);
        OIIO::attribute("limits:imagesize_MB", 0);
    });
}

// The pool is the process's, so it only grows: another writer may be using it.
void need_exr_threads(uint32_t threads) {
    static std::mutex mutex;
    static uint32_t most = 1;
    const std::lock_guard lock(mutex);
    if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
    if (threads <= most) return;
    most = threads;
    OIIO::attribute("exr_threads", static_cast<int>(most));
}

}  // namespace wrinkle::oiio
