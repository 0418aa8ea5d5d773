// Helpers of the image tests: a temporary folder, raw files, and a PNG writer that is independent
// of the code under test.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "image/image.h"
#include "image/load.h"
#include "support/files.h"

namespace wrinkle::test {

namespace fs = std::filesystem;

// Creates a temporary folder per test and removes it afterwards.
class ImageTest : public testing::Test {
protected:
    fs::path put(const std::string& name, std::string_view bytes) const {
        return temporary.put(name, bytes);
    }

    TemporaryFolder temporary;
    fs::path folder = temporary.path();
};

inline constexpr auto u8 = PixelType::u8, u16 = PixelType::u16, half = PixelType::half,
                      f32 = PixelType::float32;

inline std::string big_endian(uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(value >> shift);
    return bytes;
}

inline std::string png_chunk(const std::string& name, const std::string& content) {
    uint32_t crc = 0xFFFFFFFF;
    for (const char c : name + content) {
        crc ^= static_cast<uint8_t>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320 : 0);
    }
    return big_endian(static_cast<uint32_t>(content.size())) + name + content + big_endian(~crc);
}

// One stored deflate block. Precondition: `content` is shorter than 64 KiB.
inline std::string zlib_stored(const std::string& content) {
    uint32_t a = 1, b = 0;
    for (const char c : content) {
        a = (a + static_cast<uint8_t>(c)) % 65521;
        b = (b + a) % 65521;
    }
    const auto size = static_cast<uint16_t>(content.size());
    std::string bytes = {'\x78', '\x01', '\x01'};
    for (const int word : {int{size}, ~int{size}})
        bytes += {static_cast<char>(word), static_cast<char>(word >> 8)};
    return bytes + content + big_endian(b << 16 | a);
}

// `rows`: top to bottom, each with its filter byte 0 in front. Color 0 gray, 2 rgb, 4 gray and
// alpha, 6 rgba.
inline std::string png_file(uint32_t width, uint32_t height, char bits, char color,
                            const std::string& rows, const std::string& extra_chunks = "",
                            char interlace = 0) {
    const std::string header =
        big_endian(width) + big_endian(height) + bits + color + std::string(2, '\0') + interlace;
    return "\x89PNG\r\n\x1A\n" + png_chunk("IHDR", header) + extra_chunks +
           png_chunk("IDAT", zlib_stored(rows)) + png_chunk("IEND", "");
}

// Every sample has a different value, exact in u8 and thus in every type.
inline Image sample_image(uint32_t width, uint32_t height, uint32_t channels) {
    Image image = make_image(width, height, channels);
    for (size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = static_cast<float>((i * 37 + 5) % 256) / 255.0f;
    return image;
}

inline Image loaded(const fs::path& path) {
    Diagnostics diagnostics;
    const auto image = load_image(path, diagnostics);
    EXPECT_TRUE(image && diagnostics.list().empty()) << to_text(diagnostics);
    return image.value_or(Image{});
}

// Returns the only error of a load that must fail.
inline Diagnostic refusal(const fs::path& path, const ImageLimits& limits = {}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(load_image(path, limits, diagnostics));
    EXPECT_EQ(diagnostics.list().size(), 1u) << to_text(diagnostics);
    return diagnostics.list().empty() ? Diagnostic{} : diagnostics.list().front();
}

}  // namespace wrinkle::test
