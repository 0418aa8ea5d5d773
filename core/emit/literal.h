// Literals spelled with their type: 1.0, 3, 3u, true. NaN, infinities and the minimum int, which
// have no literals, are expressions.
#pragma once

#include <string>

#include "emit/language.h"

namespace wrinkle {

void append_literal(const Language& language, std::string& text, Type type, double value);

// Returns true if append_literal() writes a leading minus.
bool is_negative_literal(Type type, double value);

}  // namespace wrinkle
