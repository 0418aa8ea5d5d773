#include "image/codec_support.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace wrinkle::codec {

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

std::string numbers_as_text(const std::vector<ImageNumber>& numbers) {
    std::string text;
    for (const ImageNumber& number : numbers) {
        char value[64];
        std::snprintf(value, sizeof value, "=%.9g", static_cast<double>(number.value));
        text += (text.empty() ? "" : " ") + number.name + value;
    }
    return text;
}

bool find_number(std::string_view text, std::string_view name, float& value) {
    const std::string all = " " + std::string(text);
    const std::string key = " " + std::string(name) + "=";
    const size_t found = all.find(key);
    if (found == all.npos) return false;
    const char* begin = all.c_str() + found + key.size();
    char* end = nullptr;
    value = std::strtof(begin, &end);
    return end != begin;
}

}  // namespace wrinkle::codec
