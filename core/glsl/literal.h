// Literals spelled with their type: 1.0, 3, 3u, true. NaN, infinities and the minimum int are
// spelled by their bits, because GLSL has no literals for them.
#pragma once

#include <string>

#include "ir/op.h"

namespace wrinkle {

void append_literal(std::string& text, Type type, double value);

// Returns true if append_literal() writes a leading minus.
bool is_negative_literal(Type type, double value);

}  // namespace wrinkle
