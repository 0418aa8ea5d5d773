// save FILE: writes an image of one texel; exits with 3 and the errors on stderr if it cannot.
#include <cstdio>
#include <string_view>

#include "image/load.h"

int main(int, char** arguments) {
    const wrinkle::Image image = wrinkle::make_image(1, 1, 1);
    wrinkle::Diagnostics diagnostics;
    const bool png = std::string_view(arguments[1]).ends_with(".png");
    const auto type = png ? wrinkle::PixelType::u8 : wrinkle::PixelType::float32;
    if (wrinkle::save_image(image, arguments[1], {.type = type}, diagnostics)) return 0;
    std::fputs(wrinkle::to_text(diagnostics).c_str(), stderr);
    return 3;
}
