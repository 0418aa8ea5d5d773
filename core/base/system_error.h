// The error of the last system call that failed.
#pragma once

#include <cerrno>
#include <system_error>

namespace wrinkle {

inline std::error_code last_error() {
    return {errno, std::generic_category()};
}

}  // namespace wrinkle
