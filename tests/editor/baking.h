// What tests of bakes from the editor share: a small graph, and files that are to be the same.
#pragma once

#include "editor/bake/choices.h"
#include "headless.h"

namespace wrinkle::editor {

// A rock of noise, with the outputs normal, height and roughness.
extern const char* const rock;

const StoredAs* stored_kind(std::string_view key);

class Baking : public Headless {
protected:
    // Of 256 texels a side on a sphere.
    static BakeChoices choices(const std::vector<std::string>& maps, const std::string& into = {});
    // Names in the test's folder.
    void expect_same(const std::filesystem::path& ours, const std::filesystem::path& theirs) const;
};

}  // namespace wrinkle::editor
