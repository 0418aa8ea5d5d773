#include "base/limits.h"

#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include "base/text.h"

namespace wrinkle {
namespace {

// Returns std::nullopt unless `text` is a whole number from 1.
std::optional<uint64_t> limit_in(std::string_view text) {
    const auto number = whole_number(text);
    return number && *number > 0 ? number : std::nullopt;
}

const char* text_of(const LimitRow& row) {
    return std::getenv(row.variable.data());  // rows are literals with a terminating zero
}

std::string remedy(Limit limit, uint64_t value) {
    return "fewer nodes in a row that need the slope of what comes before or read it as a field, "
           "or bake that into an image first; set " +
           std::string(row_of(limit).variable) + " above " + std::to_string(value) +
           " where it must be";
}

}  // namespace

uint64_t limit_of(Limit limit) {
    const char* text = text_of(row_of(limit));
    return text ? limit_in(text).value_or(row_of(limit).default_value)
                : row_of(limit).default_value;
}

bool report_limits(Diagnostics& diagnostics) {
    bool fine = true;
    for (const LimitRow& row : limit_rows) {
        const char* text = text_of(row);
        if (!text || limit_in(text)) continue;
        fine = false;
        diagnostics.error(
            RuleId::environment,
            "environment variable " + std::string(row.variable) + " is '" + text + "'",
            "a whole number from 1 to " + std::to_string(std::numeric_limits<uint64_t>::max()));
    }
    return fine;
}

OverLimit::OverLimit(Limit which, uint64_t value, uint32_t at, std::string called)
    : std::runtime_error("the graph becomes more than " + std::to_string(value) + " " +
                         std::string(row_of(which).unit) +
                         (which == Limit::text_bytes ? " of text" : "")),
      limit(which),
      node(at),
      path(std::move(called)),
      message(what()),
      expected(remedy(which, value)) {}

}  // namespace wrinkle
