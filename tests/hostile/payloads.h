// Strings that escape from their context: comments, terminals, paths, shells, Make, JSON, HTML,
// format strings. Each string that is code contains the word HOSTILE.
#pragma once

#include <string>
#include <vector>

namespace wrinkle::hostile {

// At least 50 strings, some of them not UTF-8.
const std::vector<std::string>& payloads();

}  // namespace wrinkle::hostile
