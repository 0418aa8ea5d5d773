#include "image/oiio/settings.h"

#include <mutex>

namespace wrinkle::oiio {

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
