#include "json/tree.h"

#include <algorithm>

namespace wrinkle::json {
namespace {

constexpr uint32_t block_size = 4096;  // a location costs one block, however long the line is

uint32_t count_characters(const char* begin, const char* end) {
    uint32_t count = 0;
    for (; begin != end; ++begin)
        count += (static_cast<unsigned char>(*begin) & 0xC0) != 0x80;
    return count;
}

}  // namespace

void Tree::index_source() {
    lines.assign(1, source.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0);
    for (size_t at = source.find('\n'); at != source.npos; at = source.find('\n', at + 1))
        lines.push_back(static_cast<uint32_t>(at + 1));
    blocks.assign(1, 0);
    const char* data = source.data();
    for (size_t end = block_size; end <= source.size(); end += block_size)
        blocks.push_back(blocks.back() + count_characters(data + end - block_size, data + end));
}

uint32_t Tree::characters_before(uint32_t offset) const {
    const uint32_t block = offset / block_size;
    const char* data = source.data();
    return blocks[block] + count_characters(data + block * block_size, data + offset);
}

Location Tree::location(uint32_t offset) const {
    const auto after = std::upper_bound(lines.begin() + 1, lines.end(), offset);
    const uint32_t begin = std::min(*(after - 1), offset);
    const auto line = static_cast<uint32_t>(after - lines.begin());
    return {file, line, characters_before(offset) - characters_before(begin) + 1};
}

}  // namespace wrinkle::json
