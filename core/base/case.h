// Lower case of ASCII letters. Other bytes are unchanged, so UTF-8 stays valid, in every locale.
#pragma once

#include <string>
#include <string_view>

namespace wrinkle {

inline char lower_case(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        c = lower_case(c);
    return lower;
}

}  // namespace wrinkle
