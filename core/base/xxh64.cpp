#include "base/checksum.h"

#include <bit>
#include <cstring>

namespace wrinkle {
namespace {

constexpr uint64_t prime_1 = 0x9e3779b185ebca87, prime_2 = 0xc2b2ae3d27d4eb4f,
                   prime_3 = 0x165667b19e3779f9, prime_4 = 0x85ebca77c2b2ae63,
                   prime_5 = 0x27d4eb2f165667c5;

template <class Word>
uint64_t read(const std::byte* at) {
    static_assert(std::endian::native == std::endian::little);
    Word word;
    std::memcpy(&word, at, sizeof word);
    return word;
}

uint64_t round(uint64_t lane, uint64_t word) {
    return std::rotl(lane + word * prime_2, 31) * prime_1;
}

void add_stripe(std::array<uint64_t, 4>& lanes, const std::byte* at) {
    for (size_t i = 0; i < lanes.size(); ++i)
        lanes[i] = round(lanes[i], read<uint64_t>(at + i * sizeof(uint64_t)));
}

uint64_t joined(const std::array<uint64_t, 4>& lanes) {
    uint64_t sum = std::rotl(lanes[0], 1) + std::rotl(lanes[1], 7) + std::rotl(lanes[2], 12) +
                   std::rotl(lanes[3], 18);
    for (const uint64_t lane : lanes)
        sum = (sum ^ round(0, lane)) * prime_1 + prime_4;
    return sum;
}

uint64_t with_rest(uint64_t sum, std::span<const std::byte> rest) {
    for (; rest.size() >= 8; rest = rest.subspan(8))
        sum = std::rotl(sum ^ round(0, read<uint64_t>(rest.data())), 27) * prime_1 + prime_4;
    for (; rest.size() >= 4; rest = rest.subspan(4))
        sum = std::rotl(sum ^ (read<uint32_t>(rest.data()) * prime_1), 23) * prime_2 + prime_3;
    for (const std::byte byte : rest)
        sum = std::rotl(sum ^ (static_cast<uint64_t>(byte) * prime_5), 11) * prime_1;
    return sum;
}

}  // namespace

void Xxh64::add(std::span<const std::byte> bytes) {
    const size_t held = size_ % stripe;
    size_ += bytes.size();
    if (held > 0 && held + bytes.size() >= stripe) {
        std::memcpy(rest_.data() + held, bytes.data(), stripe - held);
        add_stripe(lanes_, rest_.data());
        bytes = bytes.subspan(stripe - held);
    }
    auto lanes = lanes_;  // bytes may alias a member, which would keep it out of registers
    for (; bytes.size() >= stripe; bytes = bytes.subspan(stripe))
        add_stripe(lanes, bytes.data());
    lanes_ = lanes;
    // Append after the pending bytes, or at the start if these completed a stripe.
    const size_t at = size_ % stripe - bytes.size();
    if (!bytes.empty()) std::memcpy(rest_.data() + at, bytes.data(), bytes.size());
}

std::string Xxh64::digest() const {
    uint64_t sum = size_ >= stripe ? joined(lanes_) : prime_5;
    sum = with_rest(sum + size_, std::span(rest_).first(size_ % stripe));
    sum = (sum ^ (sum >> 33)) * prime_2;
    sum = (sum ^ (sum >> 29)) * prime_3;
    sum ^= sum >> 32;
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4)
        text += "0123456789abcdef"[sum >> shift & 15];
    return text;
}

}  // namespace wrinkle
