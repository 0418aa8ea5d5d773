// Functions for codecs: exceptions become messages in the caller's buffer (`why`), and numbers are
// stored as text.
#pragma once

#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "image/codec.h"

namespace wrinkle::codec {

struct Failure : std::runtime_error {
    using runtime_error::runtime_error;
};

// Returns an error message as one line; a default message if it is empty.
std::string sentence(std::string text);
// Copies the text to the caller's buffer, truncated to its capacity.
void set_text(WrinkleImageText why, const std::string& text);

// Returns the result of `work`. If it throws, writes the message to `why` and returns a
// value-initialised result.
template <typename Work>
auto guarded(WrinkleImageText why, Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::exception& error) {
        set_text(why, sentence(error.what()));
    } catch (...) {
        set_text(why, "an unknown failure in a library");
    }
    return {};
}

// Returns the numbers as "NAME=VALUE NAME=VALUE", for formats without attributes of any name.
std::string numbers_as_text(const std::vector<ImageNumber>& numbers);
// Finds a number in such a text; returns false if there is none.
bool find_number(std::string_view text, std::string_view name, float& value);

}  // namespace wrinkle::codec
