// String interning: each distinct string is stored once and has a number.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle {

class StringPool {
public:
    // Returns the number of `text`, equal for equal strings; 0 is "".
    uint32_t add(std::string_view text) {
        if (text.empty()) return 0;
        const auto known = numbers_.find(text);
        if (known != numbers_.end()) return known->second;
        texts_.emplace_back(text);
        const auto number = static_cast<uint32_t>(texts_.size() - 1);
        return numbers_.emplace(texts_.back(), number).first->second;
    }
    const std::string& operator[](uint32_t number) const { return texts_[number]; }

private:
    std::vector<std::string> texts_{std::string()};
    std::map<std::string, uint32_t, std::less<>> numbers_;
};

}  // namespace wrinkle
