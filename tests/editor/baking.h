// Shared by the tests of bakes from the editor: a small graph, a fixture, file comparison.
#pragma once

#include "editor/model/bake/choices.h"
#include "headless.h"

namespace wrinkle::editor {

// A graph of noise with the outputs normal, height and roughness.
extern const char* const rock;

const StoredAs* stored_kind(std::string_view key);

class Baking : public Headless {
protected:
    // Bakes onto a sphere, 256 texels per row.
    static BakeChoices choices(const std::vector<std::string>& maps, const std::string& into = {});
    // Checks that both files have the same bytes. Paths are relative to the test's folder.
    void expect_same(const std::filesystem::path& ours, const std::filesystem::path& theirs) const;
};

}  // namespace wrinkle::editor
