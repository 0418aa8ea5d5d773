#include "editor/model/document/watch.h"

#include <chrono>

namespace wrinkle::editor {

uint64_t checksum(std::string_view bytes) {
    uint64_t sum = 0xCBF29CE484222325;
    for (const char byte : bytes)
        sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001B3;
    return sum;
}

double seconds_now() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

}  // namespace wrinkle::editor
