// The node whose build() is played from bytes.
#pragma once

#include <string>
#include <vector>

namespace wrinkle::fuzz {

// What its right build() records, for each choice of its options.
std::vector<std::string> right_calls();

}  // namespace wrinkle::fuzz
