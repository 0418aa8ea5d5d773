// Which program this is: what two builds that may write different texts differ in.
#pragma once

#include <string>

namespace wrinkle::cli {

// The version and the sum that the linker left in the program (its build id); where there is none
// the sum of the program's file, "" when that cannot be read either.
std::string program_identity();

// The build ids of all that the program has loaded, its compilers of other languages among them
// once they are.
std::string loaded_identity();

}  // namespace wrinkle::cli
