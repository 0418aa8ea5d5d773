#include "editor/model/document/text_delta.h"

#include <algorithm>
#include <charconv>
#include <unordered_map>

namespace wrinkle::editor {
namespace {

std::string_view line_at(std::string_view text, size_t offset) {
    const size_t end = text.find('\n', offset);
    return text.substr(offset, end == text.npos ? end : end - offset + 1);
}

// Copies lines of `after` that occur in `middle`, which starts at offset `first`; adds the others.
void match_lines(DeltaWriter& maker, size_t first, std::string_view middle,
                 std::string_view after) {
    std::unordered_map<std::string_view, size_t> places;
    for (size_t at = 0; at < middle.size();) {
        const std::string_view line = line_at(middle, at);
        places.emplace(line, first + at);
        at += line.size();
    }
    for (size_t at = 0; at < after.size();) {
        const std::string_view line = line_at(after, at);
        const auto found = places.find(line);
        if (maker.goes_on(line))
            maker.copy(maker.end_of_copy(), line.size());
        else if (found != places.end())
            maker.copy(found->second, line.size());
        else
            maker.add(line);
        at += line.size();
    }
}

// Takes "12," or "12\n" from the front.
std::optional<size_t> take_number(std::string_view& text, char end) {
    size_t number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const auto used = static_cast<size_t>(stop - text.data());
    if (error != std::errc() || used == text.size() || *stop != end) return std::nullopt;
    text.remove_prefix(used + 1);
    return number;
}

}  // namespace

void DeltaWriter::copy(size_t offset, size_t length) {
    if (length == 0) return;
    if (length_ > 0 && offset == offset_ + length_) {
        length_ += length;
        return;
    }
    flush();
    offset_ = offset;
    length_ = length;
}

void DeltaWriter::add(std::string_view bytes) {
    if (length_ > 0) flush();
    added_ += bytes;
}

bool DeltaWriter::goes_on(std::string_view bytes) const {
    return length_ > 0 && before_.substr(offset_ + length_, bytes.size()) == bytes;
}

std::string DeltaWriter::take() {
    flush();
    return std::move(delta_);
}

void DeltaWriter::flush() {
    if (!added_.empty()) delta_ += "+" + std::to_string(added_.size()) + "\n" + added_;
    if (length_ > 0) delta_ += "=" + std::to_string(offset_) + "," + std::to_string(length_) + "\n";
    added_.clear();
    length_ = 0;
}

std::string text_delta(std::string_view before, std::string_view after) {
    const size_t most = std::min(before.size(), after.size());
    const auto differs = std::mismatch(before.begin(), before.begin() + most, after.begin());
    size_t head = static_cast<size_t>(differs.first - before.begin());
    while (head > 0 && before[head - 1] != '\n')
        --head;
    const auto from_end =
        std::mismatch(before.rbegin(), before.rbegin() + (most - head), after.rbegin());
    size_t tail = static_cast<size_t>(from_end.first - before.rbegin());
    while (tail > 0 && before.size() != tail && before[before.size() - tail - 1] != '\n')
        --tail;
    DeltaWriter maker(before);
    maker.copy(0, head);
    match_lines(maker, head, before.substr(head, before.size() - head - tail),
                after.substr(head, after.size() - head - tail));
    maker.copy(before.size() - tail, tail);
    return maker.take();
}

std::optional<std::string> apply_text_delta(std::string_view before, std::string_view delta) {
    std::string after;
    while (!delta.empty()) {
        const char what = delta[0];
        delta.remove_prefix(1);
        if (what == '=') {
            const auto offset = take_number(delta, ',');
            const auto length = offset ? take_number(delta, '\n') : std::nullopt;
            if (!length || *offset > before.size() || *length > before.size() - *offset) return {};
            after += before.substr(*offset, *length);
        } else if (what == '+') {
            const auto length = take_number(delta, '\n');
            if (!length || *length > delta.size()) return {};
            after += delta.substr(0, *length);
            delta.remove_prefix(*length);
        } else {
            return {};
        }
    }
    return after;
}

}  // namespace wrinkle::editor
