// A node with a build() that is replayed from bytes.
#pragma once

#include <string>
#include <vector>

namespace wrinkle::fuzz {

// Returns the calls that its build() records without damage, for each choice of its options.
std::vector<std::string> right_calls();

}  // namespace wrinkle::fuzz
