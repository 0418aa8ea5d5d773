// A line of text in the making.
//
// It is made of many pieces of a few letters, so a short piece is copied without a call.
#pragma once

#include <cstring>
#include <memory>
#include <string>
#include <string_view>

namespace wrinkle {

class Line {
public:
    void clear() { size_ = 0; }
    void cut(size_t size) { size_ = size; }  // what is behind
    size_t size() const { return size_; }
    std::string_view view() const { return {data_.get(), size_}; }

    Line& add(std::string_view piece) {
        if (capacity_ - size_ < piece.size()) grow(piece.size());
        copy(data_.get() + size_, piece.data(), piece.size());
        size_ += piece.size();
        return *this;
    }
    Line& add(char letter) { return add(std::string_view(&letter, 1)); }
    // Spaces up to this size.
    Line& pad(size_t size) {
        while (size_ < size)
            add(' ');
        return *this;
    }

private:
    static void copy(char* to, const char* from, size_t size) {
        if (size > 16) {
            std::memcpy(to, from, size);
        } else if (size >= 8) {
            copy_ends<8>(to, from, size);
        } else if (size >= 4) {
            copy_ends<4>(to, from, size);
        } else if (size > 0) {
            to[0] = from[0];
            to[size / 2] = from[size / 2];
            to[size - 1] = from[size - 1];
        }
    }
    // The two may overlap.
    template <size_t half>
    static void copy_ends(char* to, const char* from, size_t size) {
        char first[half], last[half];
        std::memcpy(first, from, half);
        std::memcpy(last, from + size - half, half);
        std::memcpy(to, first, half);
        std::memcpy(to + size - half, last, half);
    }
    void grow(size_t more) {
        constexpr size_t least = 256;
        capacity_ = 2 * (size_ + more) + least;
        auto larger = std::make_unique<char[]>(capacity_);
        if (size_ > 0) std::memcpy(larger.get(), data_.get(), size_);
        data_ = std::move(larger);
    }

    std::unique_ptr<char[]> data_;
    size_t size_ = 0, capacity_ = 0;
};

}  // namespace wrinkle
