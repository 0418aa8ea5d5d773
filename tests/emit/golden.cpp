#include "golden.h"

#include <cstdlib>

#include "base/file.h"

namespace wrinkle::test {

testing::AssertionResult equals_golden(const std::string& text, const std::string& file) {
    const std::string path = std::string(WRINKLE_SOURCE_DIR) + "/tests/golden/" + file;
    std::string why;
    if (std::getenv("WRINKLE_UPDATE_GOLDEN")) {
        if (!write_file(path, text, why)) return testing::AssertionFailure() << path << " " << why;
        return testing::AssertionSuccess();
    }
    const auto golden = read_file(path, why);
    if (!golden) return testing::AssertionFailure() << path << " " << why;
    if (*golden == text) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "differs from " << path << ":\n" << text;
}

}  // namespace wrinkle::test
