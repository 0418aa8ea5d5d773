// Manual pages in roff (man(7)), made from the commands as they are declared: `wrinkle man` prints
// the program's, `wrinkle man COMMAND` that of a command.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace wrinkle::cli {

std::string manual_page(const CLI::App& app);
std::string manual_page(const CLI::App& app, const CLI::App& command);

}  // namespace wrinkle::cli
