// Whether a file can be a shared object of this machine, seen from its bytes: the system's loader
// may end the program over one that is cut short, and calls one of another machine "not found". For
// core/registry alone.
#pragma once

#include <string>
#include <string_view>

namespace wrinkle {

// "" when nothing speaks against loading it, else the reason: "the file is cut short".
std::string elf_fault(std::string_view bytes);

}  // namespace wrinkle
