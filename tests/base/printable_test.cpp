// Tests of the printable form of text that comes from files.
#include "base/printable.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace wrinkle {
namespace {

std::string utf8(uint32_t code) {
    std::string text;
    if (code < 0x80) return {static_cast<char>(code)};
    if (code >= 0x10000) {
        text = {static_cast<char>(0xF0 | code >> 18),
                static_cast<char>(0x80 | (code >> 12 & 0x3F))};
    } else if (code >= 0x800) {
        text = {static_cast<char>(0xE0 | code >> 12)};
    }
    if (code >= 0x800)
        text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
    else
        text += static_cast<char>(0xC0 | code >> 6);
    return text += static_cast<char>(0x80 | (code & 0x3F));
}

// General category Cc, Zl, Zp, or the property Bidi_Control of the Unicode Character Database.
bool is_dangerous(uint32_t code) {
    constexpr uint32_t bidi_control[] = {0x061C, 0x200E, 0x200F, 0x202A, 0x202B, 0x202C,
                                         0x202D, 0x202E, 0x2066, 0x2067, 0x2068, 0x2069};
    for (const uint32_t each : bidi_control)
        if (code == each) return true;
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x2028 || code == 0x2029;
}

TEST(Printable, EveryCharacterIsKeptOrEscaped) {
    for (uint32_t code = 0; code <= 0x10FFFF; ++code) {
        if (code >= 0xD800 && code <= 0xDFFF) continue;
        const std::string text = "a" + utf8(code) + "b";
        const std::string shown = printable(text);
        ASSERT_EQ(shown == text, !is_dangerous(code)) << code;
        if (shown == text) continue;
        for (const char c : shown)
            ASSERT_TRUE(c >= 0x20 && c < 0x7F) << code;
        ASSERT_EQ(shown[1], '\\') << code;
    }
}

TEST(Printable, EscapesAreThoseOfC) {
    EXPECT_EQ(printable("a\n\r\tb"), "a\\n\\r\\tb");
    EXPECT_EQ(printable(std::string_view("\0\x1B\x7F", 3)), "\\x00\\x1b\\x7f");
    EXPECT_EQ(printable("\u0085\u061C\u2029"), "\\u0085\\u061c\\u2029");
}

TEST(Printable, BytesThatAreNotUtf8AreEscapedOneByOne) {
    EXPECT_EQ(printable("\xFFz\xC3"), "\\xffz\\xc3");
    EXPECT_EQ(printable("\xC0\x80"), "\\xc0\\x80");           // overlong
    EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80");  // a surrogate
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
    EXPECT_EQ(printable("\xE2\x80"), "\\xe2\\x80");
}

}  // namespace
}  // namespace wrinkle
