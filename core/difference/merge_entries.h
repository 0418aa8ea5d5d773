// Merge of one section; private to core/difference. The rules are in merge.h.
#pragma once

#include <vector>

#include "difference/merge.h"

namespace wrinkle::difference {

struct EntriesOfSides {
    const std::vector<Entry>&base, &ours, &theirs;
};

std::vector<Entry> merge_section(Section section, const EntriesOfSides& sides, MergePurpose purpose,
                                 std::vector<Conflict>& conflicts);

}  // namespace wrinkle::difference
