#include "baking.h"

namespace wrinkle::editor {

const char* const rock = R"({
  "wrinkle": 1,
  "nodes": {
    "noise": { "type": "gradient_noise", "in": { "scale": 3.0 } },
    "normal": { "type": "resolve", "in": { "gradient": { "from": "noise.height" } } }
  },
  "outputs": {
    "normal": { "from": "normal.normal" },
    "height": { "from": "noise.height" },
    "roughness": { "from": "noise.height" }
  }
}
)";

const StoredAs* stored_kind(std::string_view key) {
    for (const StoredAs& each : stored_kinds())
        if (each.key == key) return &each;
    ADD_FAILURE() << key;
    return stored_kinds().data();
}

BakeChoices Baking::choices(const std::vector<std::string>& maps, const std::string& into) {
    BakeChoices chosen;
    chosen.mesh = "sphere";
    chosen.maps = maps;
    chosen.width = 256;
    chosen.into = into;
    return chosen;
}

void Baking::expect_same(const std::filesystem::path& ours,
                         const std::filesystem::path& theirs) const {
    const std::string bytes = text_of(folder.path() / ours);
    EXPECT_GT(bytes.size(), 100U) << ours;
    EXPECT_TRUE(bytes == text_of(folder.path() / theirs)) << ours << " and " << theirs;
}

}  // namespace wrinkle::editor
