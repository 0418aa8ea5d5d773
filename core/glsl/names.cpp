#include "glsl/names.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/printable.h"
#include "base/text.h"
#include "base/text_hash.h"

namespace wrinkle {
namespace {

constexpr size_t longest_name = 120;
constexpr size_t longest_comment = 160;

constexpr std::string_view kept_prefixes[] = {"gl_", "GL_", "webgl_", "_webgl_"};

bool has_kept_prefix(std::string_view name) {
    return std::any_of(std::begin(kept_prefixes), std::end(kept_prefixes),
                       [&](std::string_view prefix) { return name.starts_with(prefix); });
}

// Most names are what legal() would make of them.
bool is_legal(std::string_view name) {
    if (name.empty() || name.size() > longest_name || name.back() == '_') return false;
    if (!is_identifier(name)) return false;
    constexpr std::string_view first_of_kept = "gGw_";
    return first_of_kept.find(name[0]) == std::string_view::npos || !has_kept_prefix(name);
}

std::string legal(std::string_view wanted) {
    std::string name = identifier(wanted);
    while (name.size() > 1 && name.back() == '_')
        name.pop_back();
    if (has_kept_prefix(name) || name == "_") name.insert(0, "n");
    if (name.size() > longest_name) name.resize(longest_name);
    while (name.size() > 1 && name.back() == '_')
        name.pop_back();
    return name;
}

uint32_t hash_of(std::string_view name) {
    return static_cast<uint32_t>(text_hash(name));
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

bool is_plain_comment(std::string_view text) {
    static constexpr auto plain = [] {
        std::array<bool, 256> table{};
        for (unsigned char c = 0x20; c < 0x7F; ++c)
            table[c] = c != '\\' && c != '?';
        return table;
    }();
    return text.size() <= longest_comment && std::all_of(text.begin(), text.end(), [](char c) {
               return plain[static_cast<unsigned char>(c)];
           });
}

}  // namespace

// Of a text that is there or the free one for it; until the next make_room().
size_t NameSet::slot_of(std::string_view name, uint32_t hash) const {
    const size_t mask = slots_.size() - 1;
    const auto is_other = [&](const Entry& entry) {
        return entry.hash != hash || text(entry.name) != name;
    };
    size_t slot = hash & mask;
    while (slots_[slot] > 0 && is_other(entries_[slots_[slot] - 1]))
        slot = (slot + 1) & mask;
    return slot;
}

bool NameSet::has(std::string_view name, uint32_t hash) const {
    return !slots_.empty() && slots_[slot_of(name, hash)] > 0;
}

bool NameSet::taken_outside(std::string_view name, uint32_t hash) const {
    for (const NameSet* outer = outer_; outer; outer = outer->outer_)
        if (outer->has(name, hash)) return true;
    return false;
}

void NameSet::make_room(size_t more) {
    constexpr size_t least = 32;
    size_t size = std::max(slots_.size(), least);
    while ((entries_.size() + more) * 2 > size)
        size *= 2;
    if (size == slots_.size()) return;
    entries_.reserve(size / 2);
    slots_.assign(size, 0);
    for (size_t i = 0; i < entries_.size(); ++i) {
        size_t slot = entries_[i].hash & (size - 1);
        while (slots_[slot] > 0)
            slot = (slot + 1) & (size - 1);
        slots_[slot] = static_cast<uint32_t>(i + 1);
    }
}

Name NameSet::fill(size_t slot, size_t begin, uint32_t hash) {
    const Name name{static_cast<uint32_t>(begin), static_cast<uint32_t>(pool_.size() - begin)};
    entries_.push_back({name, hash});
    slots_[slot] = static_cast<uint32_t>(entries_.size());
    return name;
}

Name NameSet::add(const WantedName& wanted) {
    const size_t begin = pool_.size();
    if (!wanted.first.empty()) pool_.add(wanted.first).add('_');
    pool_.add(wanted.second);
    if (!is_legal(text_behind(begin))) {
        const std::string made = legal(std::string(text_behind(begin)));
        pool_.cut(begin);
        pool_.add(made);
    }
    const std::string_view name = text_behind(begin);
    const uint32_t hash = hash_of(name);
    make_room(2);  // a numbered name is added to its own
    const size_t slot = slot_of(name, hash);
    if (slots_[slot] > 0) {
        pool_.cut(begin);
        return numbered(entries_[slots_[slot] - 1]);
    }
    const Name added = fill(slot, begin, hash);
    return taken_outside(name, hash) ? numbered(entries_.back()) : added;
}

// There is room for one more, so what is taken stays where it is.
Name NameSet::numbered(Entry& taken) {
    const std::string stem(text(taken.name));
    const size_t begin = pool_.size();
    for (;;) {
        pool_.cut(begin);
        pool_.add(stem).add('_').add(std::to_string(taken.next++));
        const std::string_view name = text_behind(begin);
        const uint32_t hash = hash_of(name);
        const size_t slot = slot_of(name, hash);
        if (slots_[slot] == 0 && !taken_outside(name, hash)) return fill(slot, begin, hash);
    }
}

std::string_view change_name(uint32_t input_extra) {
    static const auto names = [] {
        std::array<std::array<std::string, 2>, surface_input_count> table;
        for (int i = 0; i < surface_input_count; ++i) {
            const auto input = static_cast<SurfaceInput>(i);
            const bool position = input == SurfaceInput::position_;
            const std::string stem = position ? "dp" : "d" + std::string(info(input).name) + "_";
            table[static_cast<size_t>(i)] = {stem + "dx", stem + "dy"};
        }
        return table;
    }();
    const Variant variant = variant_of(input_extra);
    const SurfaceInput input = input_of(input_extra);
    if (variant == Variant::value) return info(input).name;
    return names[static_cast<size_t>(input)][variant == Variant::dy];
}

std::string comment_text(std::string_view text) {
    if (is_plain_comment(text)) return std::string(text);
    std::string line;
    while (!text.empty()) {
        const Character character = first_character(text);
        if (line.size() + character.bytes > longest_comment) break;
        if (text[0] == '\\')
            line += '/';
        else if (is_printable(character))
            line += text.substr(0, character.bytes);
        else
            line += ' ';
        text.remove_prefix(character.bytes);
        if (line.ends_with("?\?/")) line.back() = ' ';  // a backslash to old compilers
    }
    return line;
}

void append_comment_text(Line& line, std::string_view text) {
    if (is_plain_comment(text))
        line.add(text);
    else
        line.add(comment_text(text));
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
