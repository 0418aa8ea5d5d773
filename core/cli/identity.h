// Identity of results: fields to be hashed, and the identity of the program, which is one of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::cli {

// Identity of the running program: differs between builds that may generate different source.
// Returns the version and the linker's build id; without a build id, the version and the SHA-256 of
// the program's file; "" if that cannot be read.
std::string program_identity();

// Returns the build ids of the program and all loaded libraries, including the compilers of other
// languages if they are loaded.
std::string loaded_identity();

// Serialises strings into one and back; split_fields() returns std::nullopt if the bytes are not an
// output of join_fields().
std::string join_fields(const std::vector<std::string>& fields);
std::optional<std::vector<std::string>> split_fields(std::string_view bytes);

}  // namespace wrinkle::cli
