// Damages samples: cut, copied, swapped or flipped bytes, and bytes of another sample. The same
// number gives the same damage on every machine.
#pragma once

#include <span>
#include <string>

namespace wrinkle::fuzz {

std::string damaged(std::span<const std::string> samples, uint32_t number);

// Corrects the checksums of a PNG, so that the code after their verification is tested too.
std::string with_checksums(std::string png);

}  // namespace wrinkle::fuzz
