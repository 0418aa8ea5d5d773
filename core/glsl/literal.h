// Literals with a type that shows: 1.0, 3, 3u, true; what has no spelling by its bits.
#pragma once

#include <string>

#include "ir/op.h"

namespace wrinkle {

void append_literal(std::string& text, Type type, double value);

// Whether that text begins with a minus.
bool is_negative_literal(Type type, double value);

}  // namespace wrinkle
