// Options of wrinkle_graph_compile(), written "NAME=VALUE".
#pragma once

#include <string_view>

#include "api/parts.h"

namespace wrinkle::api {

// Sets one option. Reports an unknown name, and a value that the option does not take.
WRINKLE_INSIDE void set_option(CompileOptions& options, std::string_view text,
                               Diagnostics& diagnostics);

}  // namespace wrinkle::api
