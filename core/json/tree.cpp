#include "json/tree.h"

#include <algorithm>

namespace wrinkle::json {
namespace {

constexpr uint32_t block_size = 4096;  // a location costs one block, for lines of any length

uint32_t count_characters(const char* begin, const char* end) {
    uint32_t count = 0;
    for (; begin != end; ++begin)
        count += (static_cast<unsigned char>(*begin) & 0xC0) != 0x80;
    return count;
}

}  // namespace

void Lines::find_all(std::string_view text) {
    begins_.assign(1, begin_of(text));
    for (size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1))
        begins_.push_back(static_cast<uint32_t>(at + 1));
    blocks_.assign(1, 0);
    const char* data = text.data();
    for (size_t end = block_size; end <= text.size(); end += block_size)
        blocks_.push_back(blocks_.back() + count_characters(data + end - block_size, data + end));
}

uint32_t Lines::characters_before(std::string_view text, uint32_t offset) const {
    const uint32_t block = offset / block_size;
    const char* data = text.data();
    return blocks_[block] + count_characters(data + block * block_size, data + offset);
}

Location Lines::location(std::string_view text, uint32_t offset) {
    std::call_once(found_, [&] { find_all(text); });
    const auto after = std::upper_bound(begins_.begin() + 1, begins_.end(), offset);
    const uint32_t begin = std::min(*(after - 1), offset);
    const auto line = static_cast<uint32_t>(after - begins_.begin());
    return {"", line, characters_before(text, offset) - characters_before(text, begin) + 1};
}

Location Tree::location(uint32_t offset) const {
    Location location = lines->location(source, offset);
    location.file = file;
    return location;
}

}  // namespace wrinkle::json
