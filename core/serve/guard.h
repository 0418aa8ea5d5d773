// Which requests a loopback server answers. A page of another site can send requests to it, and
// its domain can resolve to 127.0.0.1 (DNS rebinding), so the headers decide.
#pragma once

#include <string_view>

namespace wrinkle::serve {

// Headers of a request; "" if absent.
struct RequestNames {
    std::string_view host, origin, fetch_site;
};

// Returns true if the host is localhost, 127.0.0.1 or [::1] with the port of the server, the origin
// is absent or http:// and such a host, and Sec-Fetch-Site is absent, "same-origin" or "none".
bool is_allowed(const RequestNames& names, int port);

}  // namespace wrinkle::serve
