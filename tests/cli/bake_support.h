// Fixture of the tests of `wrinkle bake`: loads the baked images as numbers.
#pragma once

#include "cli/support.h"
#include "image/load.h"

namespace wrinkle::test {

class BakeTest : public CliTest {
protected:
    using Names = std::vector<std::string>;

    // Runs `wrinkle bake graph --mesh MESH -o OUT MORE...`.
    Ran bake(const std::string& mesh, const std::string& out, Names more = {}) const {
        more.insert(more.begin(), {"bake", graph, "--mesh", mesh, "-o", out});
        return run(more);
    }
    Image picture(const std::string& name) const {
        Diagnostics diagnostics;
        auto image = load_image(folder / name, diagnostics);
        EXPECT_TRUE(image) << to_text(diagnostics);
        return image ? std::move(*image) : make_image(1, 1, 3);
    }
    testing::AssertionResult same_files(const std::string& a, const std::string& b) const {
        if (get(a) == get(b)) return testing::AssertionSuccess();
        return testing::AssertionFailure() << a << " and " << b << " differ";
    }

    std::string graph = WRINKLE_SOURCE_DIR "/graphs/noise_rock.json";
};

}  // namespace wrinkle::test
