#include "fuzz/damage.h"

#include <algorithm>
#include <random>

#include "image/support.h"

namespace wrinkle::fuzz {
namespace {

using Random = std::mt19937;

size_t below(Random& random, size_t limit) {
    return limit == 0 ? 0 : random() % limit;
}

// Returns a random boundary value, as bytes or as text.
std::string token(Random& random) {
    static const std::string tokens[] = {std::string(4, '\0'),
                                         "\xFF\xFF\xFF\xFF",
                                         "\x7F\xFF\xFF\xFF",
                                         std::string(2, '\x80'),
                                         "-1",
                                         "1e999",
                                         "nan",
                                         "99999999999",
                                         "null",
                                         "[[[[",
                                         "{}",
                                         "\"",
                                         "\\ud800",
                                         "\xC3",
                                         "/",
                                         "\n"};
    return tokens[below(random, std::size(tokens))];
}

constexpr const char* word_bytes =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.+-";

struct Range {
    size_t begin = 0, size = 0;
};

// Returns the next name or number; replacing words preserves the structure of the text.
Range word_after(const std::string& text, size_t at) {
    const size_t begin = std::min(text.find_first_of(word_bytes, at), text.size());
    return {begin, std::min(text.find_first_not_of(word_bytes, begin), text.size()) - begin};
}

void exchange_word(std::string& bytes, size_t at, const std::string& other, Random& random) {
    const Range old = word_after(bytes, at);
    const Range taken = word_after(other, below(random, other.size()));
    bytes.replace(old.begin, old.size, other.substr(taken.begin, taken.size));
}

void damage(std::string& bytes, const std::string& other, Random& random) {
    const size_t at = below(random, bytes.size() + 1);
    const size_t length = below(random, below(random, 4) == 0 ? bytes.size() + 1 : 24);
    switch (below(random, 8)) {
        case 0:
            bytes.erase(at, length);
            break;
        case 1:
            bytes.insert(at,
                         bytes.substr(below(random, bytes.size()), std::min<size_t>(length, 4096)));
            break;
        case 2:
            bytes.insert(at, token(random));
            break;
        case 3: {
            const std::string piece = token(random);
            bytes.replace(at, piece.size(), piece);
            break;
        }
        case 4:
            bytes.replace(at, length, other.substr(below(random, other.size()), length));
            break;
        case 5:
        case 6:
            exchange_word(bytes, at, other, random);
            break;
        default:
            if (at < bytes.size()) bytes[at] = static_cast<char>(random());
    }
}

uint32_t big_endian_at(const std::string& bytes, size_t at) {
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<uint8_t>(bytes[at + i]);
    return value;
}

}  // namespace

std::string damaged(std::span<const std::string> samples, uint32_t number) {
    Random random(number);
    std::string bytes = samples[below(random, samples.size())];
    const std::string& other = samples[below(random, samples.size())];
    for (size_t k = 1 + below(random, 5); k > 0; --k)
        damage(bytes, other, random);
    return bytes;
}

std::string with_checksums(std::string png) {
    if (!png.starts_with("\x89PNG")) return png;
    for (size_t at = 8; at + 12 <= png.size();) {
        const size_t length = big_endian_at(png, at);
        if (length > png.size() - at - 12) break;
        const std::string chunk =
            test::png_chunk(png.substr(at + 4, 4), png.substr(at + 8, length));
        png.replace(at, chunk.size(), chunk);
        at += chunk.size();
    }
    return png;
}

}  // namespace wrinkle::fuzz
