#include "image/oiio/exr_header.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>

#include "image/codec_support.h"

namespace wrinkle::oiio {

using codec::Failure;
namespace {

constexpr uint32_t several_parts = 1 << 12;  // flag in the version field
constexpr size_t max_name = 255;

class Header {
public:
    explicit Header(const char* path) : file_(path, std::ios::binary | std::ios::ate) {
        end_ = file_.tellg();
        file_.seekg(0);
    }

    ExrSize read() {
        number();  // magic number
        const bool has_parts = number() & several_parts;
        while (attributes() > 0 && has_parts) {
        }
        return size_;
    }

private:
    // Reads the attributes up to the empty name; returns their number.
    size_t attributes() {
        size_t count = 0;
        for (std::string name = text(); !name.empty(); name = text(), ++count) {
            text();  // attribute type
            const int64_t size = static_cast<int32_t>(number());
            const int64_t begin = file_.tellg();
            if (size < 0 || size > end_ - begin)
                throw Failure("its attribute '" + name + "' is larger than the file");
            if (name == "dataWindow" && size == 16) window();
            file_.seekg(begin + size);
        }
        return count;
    }

    void window() {
        std::array<int64_t, 4> sides{};  // min x, min y, max x, max y, in texels
        for (int64_t& side : sides)
            side = static_cast<int32_t>(number());
        size_.width = std::max(size_.width, sides[2] - sides[0] + 1);
        size_.height = std::max(size_.height, sides[3] - sides[1] + 1);
    }

    uint32_t number() {
        std::array<unsigned char, 4> bytes{};
        if (!file_.read(reinterpret_cast<char*>(bytes.data()), bytes.size())) ended();
        return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | uint32_t{bytes[3]} << 24;
    }

    std::string text() {
        std::string text;
        for (int c = file_.get(); c != 0; c = file_.get()) {
            if (c < 0) ended();
            if (text.size() == max_name) throw Failure("a name in its header is too long");
            text += static_cast<char>(c);
        }
        return text;
    }

    [[noreturn]] static void ended() { throw Failure("it ends within its header"); }

    std::ifstream file_;
    int64_t end_ = 0;
    ExrSize size_;
};

}  // namespace

ExrSize size_of_exr(const char* path) {
    return Header(path).read();
}

}  // namespace wrinkle::oiio
