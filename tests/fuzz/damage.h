// Bytes with a few things wrong: cut, copied, swapped, flipped, taken from another sample. The same
// number gives the same damage everywhere.
#pragma once

#include <span>
#include <string>

namespace wrinkle::fuzz {

std::string damaged(std::span<const std::string> samples, uint32_t number);

// A PNG's checksums made right again, so that what is behind them is met as well.
std::string with_checksums(std::string png);

}  // namespace wrinkle::fuzz
