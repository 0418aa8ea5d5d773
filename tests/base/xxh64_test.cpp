#include "base/checksum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

namespace wrinkle {
namespace {

std::string sum_of(const std::string& bytes, size_t piece) {
    Xxh64 sum;
    for (size_t at = 0; at < bytes.size(); at += piece) {
        sum.add(std::as_bytes(std::span(bytes).subspan(at, std::min(piece, bytes.size() - at))));
        sum.digest();  // digest() does not change the state
    }
    return sum.digest();
}

// Checksums printed by xxh64sum 0.8.1 (`head -c N /dev/zero | tr '\0' a | xxh64sum`).
TEST(Xxh64, BytesInAnyPiecesGiveTheSumOfXxh64sum) {
    const std::pair<size_t, const char*> sums[] = {
        {0, "ef46db3751d8e999"},  {1, "d24ec4f1a98c6e5b"},  {3, "ae01f066e602375b"},
        {4, "42a70d1abf84bf32"},  {7, "d6e4ab2829bc82e5"},  {8, "d5462e501de970f3"},
        {31, "fe47067cda802916"}, {32, "856e843298f99ad7"}, {33, "18f3ff0c21e3b24b"},
        {63, "6ad86a2f6c603cc9"}, {64, "ecdb66a0aa9322e2"}, {1000, "56e43b712eda4223"}};
    for (const auto& [size, sum] : sums)
        for (const size_t piece : {size_t{1}, size_t{31}, size_t{32}, size_t{33}, size_t{999}})
            EXPECT_EQ(sum_of(std::string(size, 'a'), piece), sum) << size << " by " << piece;
}

// Output of `seq 100 | xxh64sum`
TEST(Xxh64, BytesThatDifferGiveTheSumOfXxh64sum) {
    std::string bytes;
    for (int i = 1; i <= 100; ++i)
        bytes += std::to_string(i) + "\n";
    EXPECT_EQ(sum_of(bytes, 7), "c0ba3ff76acc6579");
}

}  // namespace
}  // namespace wrinkle
