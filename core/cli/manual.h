// Manual pages in roff (man(7)), made from the declared commands: `wrinkle man` prints the page of
// the program, `wrinkle man COMMAND` the page of a command.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace wrinkle::cli {

std::string manual_page(const CLI::App& app);
std::string manual_page(const CLI::App& app, const CLI::App& command);

}  // namespace wrinkle::cli
