// Review of a run at the terminal: shows each pending check and reads a decision.
#pragma once

#include <filesystem>

#include "cli/test_accept.h"

namespace wrinkle::cli {

// Reads one command per line from standard input: a accept, s skip, r reject; A, S and R for the
// rest; d shows the check again, o opens its image, q or the end of the input ends the review.
// Each decision takes effect at once, so that an interrupted review loses none. A rejected check is
// removed from the results; the next run finds it again.
Acceptance review_results(report::Results& results, const std::filesystem::path& folder,
                          const Registry& registry, const CommonOptions& common);

}  // namespace wrinkle::cli
