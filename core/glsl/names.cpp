#include "glsl/names.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"
#include "base/text_hash.h"

namespace wrinkle {
namespace {

constexpr size_t longest_name = 120;
constexpr size_t longest_comment = 160;

std::string legal(std::string_view wanted) {
    std::string name = identifier(wanted);
    while (name.size() > 1 && name.back() == '_')
        name.pop_back();
    constexpr std::string_view kept[] = {"gl_", "GL_", "webgl_", "_webgl_"};
    const auto begins = [&](std::string_view prefix) { return name.starts_with(prefix); };
    if (std::any_of(std::begin(kept), std::end(kept), begins) || name == "_") name.insert(0, "n");
    if (name.size() > longest_name) name.resize(longest_name);
    while (name.size() > 1 && name.back() == '_')
        name.pop_back();
    return name;
}

// A sample, or what constants and swizzles make of it.
bool is_texel(const Module& m, Id id) {
    for (int steps = 0; steps < 6; ++steps) {
        const Inst& inst = m[id];
        if (inst.op == Op::sample_ || inst.op == Op::sample_lod_ || inst.op == Op::sample_grad_)
            return true;
        const bool scaled = (inst.op == Op::add_ || inst.op == Op::sub_ || inst.op == Op::mul_) &&
                            m.is_constant(inst.arg[1]);
        if (!scaled && inst.op != Op::swizzle_) return false;
        id = inst.arg[0];
    }
    return false;
}

constexpr std::pair<Op, std::string_view> op_words[] = {{Op::image_size_, "size"},
                                                        {Op::add_, "sum"},
                                                        {Op::sub_, "difference"},
                                                        {Op::mul_, "product"},
                                                        {Op::matrix_product_, "product"},
                                                        {Op::div_, "quotient"},
                                                        {Op::neg_, "negated"},
                                                        {Op::normalize_, "unit"},
                                                        {Op::select_, "choice"},
                                                        {Op::construct_, "vector"},
                                                        {Op::transform_, "transformed"},
                                                        {Op::lt_, "test"},
                                                        {Op::le_, "test"},
                                                        {Op::gt_, "test"},
                                                        {Op::ge_, "test"},
                                                        {Op::eq_, "test"},
                                                        {Op::ne_, "test"},
                                                        {Op::and_, "test"},
                                                        {Op::or_, "test"},
                                                        {Op::not_, "test"},
                                                        {Op::bit_and_, "bits"},
                                                        {Op::bit_or_, "bits"},
                                                        {Op::bit_xor_, "bits"},
                                                        {Op::shift_left_, "bits"},
                                                        {Op::shift_right_, "bits"},
                                                        {Op::sign_nonzero_, "sign"},
                                                        {Op::to_float_, "number"},
                                                        {Op::to_int_, "whole"},
                                                        {Op::to_uint_, "whole"},
                                                        {Op::mod_, "remainder"},
                                                        {Op::abs_, "magnitude"},
                                                        {Op::floor_, "floored"},
                                                        {Op::ceil_, "raised"},
                                                        {Op::fract_, "fraction"},
                                                        {Op::min_, "least"},
                                                        {Op::max_, "greatest"},
                                                        {Op::clamp_, "clamped"},
                                                        {Op::mix_, "mixed"},
                                                        {Op::step_, "edge"},
                                                        {Op::smoothstep_, "ramp"},
                                                        {Op::sqrt_, "root"},
                                                        {Op::inversesqrt_, "inverse_root"},
                                                        {Op::pow_, "power"},
                                                        {Op::exp_, "exponential"},
                                                        {Op::exp2_, "exponential"},
                                                        {Op::log_, "logarithm"},
                                                        {Op::log2_, "logarithm"},
                                                        {Op::sin_, "sine"},
                                                        {Op::cos_, "cosine"},
                                                        {Op::asin_, "angle"},
                                                        {Op::acos_, "angle"},
                                                        {Op::atan_, "angle"},
                                                        {Op::atan2_, "angle"},
                                                        {Op::dot_, "dot_product"},
                                                        {Op::cross_, "cross_product"},
                                                        {Op::length_, "extent"},
                                                        {Op::reflect_, "reflected"},
                                                        {Op::transpose_, "transposed"}};

bool is_continuation(char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

// How many bytes the text's first character has if it ends a line, turns the direction of writing
// or is another control character; else 0.
size_t unseen_at(std::string_view text) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x20 || byte(0) == 0x7F) return 1;
    if (byte(0) == 0xC2 && text.size() > 1 && byte(1) < 0xA0) return 2;  // U+0080 to U+009F
    if (byte(0) != 0xE2 || text.size() < 3) return 0;
    const unsigned low = (byte(1) & 0x3FU) << 6 | (byte(2) & 0x3FU);  // behind U+2000
    const bool line_or_turn = 0x28 <= low && low <= 0x2E;
    return line_or_turn || low == 0x0E || low == 0x0F || (0x66 <= low && low <= 0x69) ? 3 : 0;
}

}  // namespace

size_t NameSet::place_of(std::string_view name) const {
    const size_t mask = entries_.size() - 1;
    size_t place = text_hash(name) & mask;
    const auto is_other = [&](const Entry& entry) {
        return entry.length > 0 &&
               std::string_view(pool_).substr(entry.begin, entry.length) != name;
    };
    while (is_other(entries_[place]))
        place = (place + 1) & mask;
    return place;
}

bool NameSet::taken(std::string_view name) const {
    const bool own = !entries_.empty() && entries_[place_of(name)].length > 0;
    return own || (outer_ && outer_->taken(name));
}

NameSet::Entry& NameSet::entry_of(std::string_view name) {
    if ((count_ + 1) * 2 > entries_.size()) grow();
    Entry& entry = entries_[place_of(name)];
    if (entry.length > 0) return entry;
    ++count_;
    entry.begin = static_cast<uint32_t>(pool_.size());
    entry.length = static_cast<uint32_t>(name.size());
    pool_ += name;
    return entry;
}

void NameSet::grow() {
    const std::vector<Entry> before =
        std::exchange(entries_, std::vector<Entry>(std::max<size_t>(2 * entries_.size(), 32)));
    for (const Entry& entry : before)
        if (entry.length > 0)
            entries_[place_of(std::string_view(pool_).substr(entry.begin, entry.length))] = entry;
}

std::string NameSet::unique(std::string_view wanted) {
    std::string name = legal(wanted);
    if (!taken(name) && !is_reserved(name)) {
        entry_of(name);
        return name;
    }
    const std::string stem = std::move(name);
    uint32_t number = entry_of(stem).next;
    do
        name = stem + "_" + std::to_string(number++);
    while (taken(name) || is_reserved(name));
    entry_of(stem).next = number;
    entry_of(name);
    return name;
}

std::string change_name(uint32_t input_extra) {
    const Variant variant = variant_of(input_extra);
    const std::string input(info(input_of(input_extra)).name);
    if (variant == Variant::value) return input;
    const std::string axis = variant == Variant::dx ? "dx" : "dy";
    return input_of(input_extra) == SurfaceInput::position_ ? "dp" + axis
                                                            : "d" + input + "_" + axis;
}

void append_comment_text(std::string& line, std::string_view text) {
    const auto plain = [](char c) { return 0x20 <= c && c < 0x7F && c != '\\' && c != '?'; };
    if (text.size() <= longest_comment && std::all_of(text.begin(), text.end(), plain)) {
        line += text;
        return;
    }
    const size_t begin = line.size();
    size_t end = std::min(text.size(), longest_comment);
    while (end > 0 && end < text.size() && is_continuation(text[end]))
        --end;
    for (size_t at = 0; at < end;) {
        const size_t unseen = std::min(unseen_at(text.substr(at)), end - at);
        line += unseen > 0 ? ' ' : text[at] == '\\' ? '/' : text[at];
        at += std::max(unseen, size_t{1});
        // A backslash to old compilers.
        if (line.size() >= begin + 3 && line.ends_with("?\?/")) line.back() = ' ';
    }
}

std::string comment_text(std::string_view text) {
    std::string result;
    append_comment_text(result, text);
    return result;
}

std::string_view word_for(const Module& module, Id id) {
    if (is_texel(module, id)) return "texel";
    const Op op = module[id].op;
    if (op == Op::result_) {
        const Region& region = module.region(module[module[id].arg[0]].extra);
        return region.kind == RegionKind::loop ? "state" : std::string_view(region.name);
    }
    static constexpr auto words = [] {
        std::array<std::string_view, tables::op_count> table{};
        for (const auto& [known, word] : op_words)
            table[static_cast<size_t>(known)] = word;
        return table;
    }();
    const std::string_view word = words[static_cast<size_t>(op)];
    return word.empty() ? info(op).name : word;
}

}  // namespace wrinkle
