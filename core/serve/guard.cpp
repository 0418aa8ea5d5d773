#include "serve/guard.h"

#include <string>

namespace wrinkle::serve {
namespace {

bool is_this_host(std::string_view host, int port) {
    const std::string end = ":" + std::to_string(port);
    for (const char* name : {"localhost", "127.0.0.1", "[::1]"})
        if (host == name + end) return true;
    return false;
}

}  // namespace

bool is_allowed(const RequestNames& names, int port) {
    constexpr std::string_view scheme = "http://";
    if (!is_this_host(names.host, port)) return false;
    if (!names.fetch_site.empty() && names.fetch_site != "same-origin" &&
        names.fetch_site != "none")
        return false;
    return names.origin.empty() || (names.origin.starts_with(scheme) &&
                                    is_this_host(names.origin.substr(scheme.size()), port));
}

}  // namespace wrinkle::serve
