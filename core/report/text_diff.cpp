#include "report/text_diff.h"

#include <algorithm>
#include <span>

#include "base/text.h"

namespace wrinkle::report {
namespace {

using Lines = std::vector<std::string_view>;
using Kind = DiffLine::Kind;

constexpr size_t max_cells = 4'000'000;

Lines lines_of(std::string_view text) {
    Lines lines = split(text, '\n');
    if (!lines.empty() && lines.back().empty()) lines.pop_back();
    return lines;
}

// Lengths of the longest common subsequences of the ends of two lists.
class CommonLengths {
public:
    CommonLengths(std::span<const std::string_view> a, std::span<const std::string_view> b)
        : columns_(b.size() + 1), cells_((a.size() + 1) * columns_) {
        for (size_t i = a.size(); i-- > 0;)
            for (size_t j = b.size(); j-- > 0;)
                at(i, j) =
                    a[i] == b[j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
    }
    uint32_t& at(size_t i, size_t j) { return cells_[i * columns_ + j]; }

private:
    size_t columns_;
    std::vector<uint32_t> cells_;
};

// Both texts, without the lines that they have in common at their beginnings and ends.
class Differ {
public:
    Differ(Lines expected, Lines actual) : a_(std::move(expected)), b_(std::move(actual)) {}

    std::vector<DiffLine> run() {
        while (i_ < a_.size() && i_ < b_.size() && a_[i_] == b_[i_])
            common();
        size_t ends = 0;
        while (ends < std::min(a_.size(), b_.size()) - i_ &&
               a_[a_.size() - 1 - ends] == b_[b_.size() - 1 - ends])
            ++ends;
        middle(a_.size() - ends, b_.size() - ends);
        while (i_ < a_.size())
            common();
        return std::move(lines_);
    }

private:
    void middle(size_t a_end, size_t b_end) {
        const size_t first_a = i_, first_b = j_;
        const std::span a = std::span(a_).subspan(first_a, a_end - first_a);
        const std::span b = std::span(b_).subspan(first_b, b_end - first_b);
        if (a.size() * b.size() <= max_cells) {
            CommonLengths lengths(a, b);
            while (i_ < a_end && j_ < b_end) {
                const size_t i = i_ - first_a, j = j_ - first_b;
                if (a[i] == b[j])
                    common();
                else if (lengths.at(i + 1, j) >= lengths.at(i, j + 1))
                    remove();
                else
                    add();
            }
        }
        while (i_ < a_end)
            remove();
        while (j_ < b_end)
            add();
    }

    void common() {
        lines_.push_back({Kind::common, number(i_), number(j_), b_[j_]});
        ++i_, ++j_;
    }
    void remove() {
        lines_.push_back({Kind::removed, number(i_), 0, a_[i_]});
        ++i_;
    }
    void add() {
        lines_.push_back({Kind::added, 0, number(j_), b_[j_]});
        ++j_;
    }
    static uint32_t number(size_t index) { return static_cast<uint32_t>(index + 1); }

    Lines a_, b_;
    size_t i_ = 0, j_ = 0;
    std::vector<DiffLine> lines_;
};

}  // namespace

std::vector<DiffLine> diff_lines(std::string_view expected, std::string_view actual,
                                 uint32_t context) {
    const std::vector<DiffLine> all = Differ(lines_of(expected), lines_of(actual)).run();
    std::vector<bool> shown(all.size());
    for (size_t i = 0; i < all.size(); ++i)
        if (all[i].kind != Kind::common)
            for (size_t k = i - std::min<size_t>(i, context);
                 k <= std::min(i + context, all.size() - 1); ++k)
                shown[k] = true;
    std::vector<DiffLine> lines;
    for (size_t i = 0; i < all.size(); ++i)
        if (shown[i])
            lines.push_back(all[i]);
        else if (lines.empty() || lines.back().kind != Kind::skipped)
            lines.push_back({Kind::skipped, 0, 0, {}});
    return lines;
}

}  // namespace wrinkle::report
