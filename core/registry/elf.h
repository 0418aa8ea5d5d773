// Checks the bytes of a shared object before it is loaded: the dynamic loader may crash on a
// truncated file, and reports one for another machine as "not found". Private to core/registry.
#pragma once

#include <string>
#include <string_view>

namespace wrinkle {

// Returns "" if the file may be loaded, else the reason: "the file is cut short".
std::string elf_fault(std::string_view bytes);

}  // namespace wrinkle
