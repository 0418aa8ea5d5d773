// Compares texts with files of tests/golden; WRINKLE_UPDATE_GOLDEN=1 writes them.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace wrinkle::test {

testing::AssertionResult equals_golden(const std::string& text, const std::string& file);

}  // namespace wrinkle::test
