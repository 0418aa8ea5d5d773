// Identity of the running program: differs between builds that may generate different source.
#pragma once

#include <string>

namespace wrinkle::cli {

// Returns the version and the linker's build id; without a build id, the version and the SHA-256 of
// the program's file; "" if that cannot be read.
std::string program_identity();

// Returns the build ids of the program and all loaded libraries, including the compilers of other
// languages if they are loaded.
std::string loaded_identity();

}  // namespace wrinkle::cli
