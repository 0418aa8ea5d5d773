// Tests that merges of random pairs of edits have every edit of both sides, or list a conflict.
#include <gtest/gtest.h>

#include <cstdlib>

#include "difference/merge.h"
#include "difference/random_edits.h"
#include "graph/read.h"

namespace wrinkle::difference {
namespace {

using test::EditPair;
using test::Model;

Document graph_of(const Model& model) {
    Diagnostics diagnostics;
    Document document = read_document(test::model_text(model), "g.json", diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << to_text(diagnostics);
    return document;
}

Model normalized(const Model& model) {
    return test::model_of(test::model_text(model));
}

std::set<test::ModelConflict> listed(const std::vector<Conflict>& conflicts) {
    std::set<test::ModelConflict> list;
    for (const Conflict& conflict : conflicts)
        list.emplace(std::string(section_names[size_t(conflict.section)]), conflict.id,
                     (conflict.key.is_port ? "in." : "") + conflict.key.name +
                         (conflict.kind == ConflictKind::error ? conflict.message : ""));
    return list;
}

std::string description(const EditPair& pair) {
    std::string text;
    for (const std::string& line : pair.log)
        text += line + "\n";
    return text;
}

// WRINKLE_MERGES=N merges N pairs.
unsigned pairs() {
    const char* count = std::getenv("WRINKLE_MERGES");
    return count ? static_cast<unsigned>(std::atoi(count)) : 500;
}

TEST(RandomMerge, LosesNoEdit) {
    size_t edits = 0, conflicts = 0, lost = 0;
    for (unsigned seed = 1; seed <= pairs() && lost < 3; ++seed) {
        const EditPair pair = test::random_edits(seed);
        const Merged merged =
            merge(graph_of(pair.base), graph_of(pair.ours), graph_of(pair.theirs));
        const bool is_complete = test::model_of(merged.text) == normalized(pair.expected) &&
                                 listed(merged.conflicts) == pair.conflicts;
        edits += pair.log.size();
        conflicts += pair.conflicts.size();
        lost += !is_complete;
        EXPECT_TRUE(is_complete) << "seed " << seed << "\n"
                                 << description(pair) << "base " << test::model_text(pair.base)
                                 << "merged " << merged.text << "expected "
                                 << test::model_text(pair.expected)
                                 << conflicts_text(merged.conflicts);
    }
    EXPECT_EQ(lost, 0U);
    EXPECT_GT(edits, pairs() * 4);
    EXPECT_GT(conflicts, pairs());
    RecordProperty("edits", static_cast<int>(edits));
    RecordProperty("conflicts", static_cast<int>(conflicts));
}

}  // namespace
}  // namespace wrinkle::difference
