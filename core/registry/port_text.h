// Text and JSON descriptions of one port; private to core/registry.
#pragma once

#include <string>

#include "registry/registry.h"

namespace wrinkle {

std::string_view kind_word(Port::Kind kind);  // "input", "choice"
std::string kind_text(const Port& port);      // "float", "choice", "field of height"
std::string details_text(const Port& port);   // "m, default 0.1, 0 to 1"; may be empty
std::string default_json(const Port& port);   // "" if it has none; a surface default is a link
std::string port_json(const Port& port);      // one object

}  // namespace wrinkle
