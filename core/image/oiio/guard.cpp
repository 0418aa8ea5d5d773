#include "image/oiio/guard.h"

#include <algorithm>
#include <cstring>
#include <mutex>

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
