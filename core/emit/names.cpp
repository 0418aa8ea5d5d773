#include "emit/names.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/printable.h"
#include "base/text.h"
#include "ir/op_traits.h"

namespace wrinkle {
namespace {

constexpr size_t max_name = 120;
constexpr size_t max_comment = 160;

constexpr std::string_view kept_prefixes[] = {"gl_", "GL_", "webgl_", "_webgl_"};

bool has_kept_prefix(std::string_view name) {
    return std::any_of(std::begin(kept_prefixes), std::end(kept_prefixes),
                       [&](std::string_view prefix) { return name.starts_with(prefix); });
}

// Returns true if legal() would return the name unchanged, as for most names.
bool is_legal(std::string_view name) {
    if (name.empty() || name.size() > max_name || name.back() == '_') return false;
    if (!is_identifier(name)) return false;
    constexpr std::string_view first_of_kept = "gGw_";
    return first_of_kept.find(name[0]) == std::string_view::npos || !has_kept_prefix(name);
}

std::string legal(std::string_view wanted) {
    std::string name = identifier(wanted);
    while (name.size() > 1 && name.back() == '_')
        name.pop_back();
    if (has_kept_prefix(name) || name == "_") name.insert(0, "n");
    if (name.size() > max_name) name.resize(max_name);
    while (name.size() > 1 && name.back() == '_')
        name.pop_back();
    return name;
}

// Returns true for a texture sample, also after up to five swizzles and sums, differences or
// products with a constant.
bool is_texel(const Module& m, Id id) {
    for (int steps = 0; steps < 6; ++steps) {
        const Inst& inst = m[id];
        if (is_sample(inst.op)) return true;
        const bool scaled = (inst.op == Op::add_ || inst.op == Op::sub_ || inst.op == Op::mul_) &&
                            m.is_constant(inst.arg[1]);
        if (!scaled && inst.op != Op::swizzle_) return false;
        id = inst.arg[0];
    }
    return false;
}

bool is_plain_comment(std::string_view text) {
    static constexpr auto plain = [] {
        std::array<bool, 256> table{};
        for (unsigned char c = 0x20; c < 0x7F; ++c)
            table[c] = c != '\\' && c != '?';
        return table;
    }();
    return text.size() <= max_comment && std::all_of(text.begin(), text.end(), [](char c) {
               return plain[static_cast<unsigned char>(c)];
           });
}

}  // namespace

bool NameSet::is_taken_outside(const std::string& name) const {
    for (const NameSet* outer = outer_; outer; outer = outer->outer_)
        if (outer->next_.contains(name)) return true;
    return false;
}

std::string_view NameSet::add(const NameHint& wanted) {
    constexpr uint32_t first_number = 2;
    std::string name(wanted.first);
    if (!name.empty()) name += '_';
    name += wanted.second;
    if (!is_legal(name)) name = legal(name);
    const auto [entry, added] = next_.try_emplace(std::move(name), first_number);
    if (added && !is_taken_outside(entry->first)) return entry->first;
    const std::string& stem = entry->first;  // stays valid while the map grows
    uint32_t& next = entry->second;
    for (;;) {
        std::string numbered = stem + "_" + std::to_string(next++);
        if (is_taken_outside(numbered)) continue;
        const auto [found, free] = next_.try_emplace(std::move(numbered), first_number);
        if (free) return found->first;
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
        if (line.size() + character.bytes > max_comment) break;
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

void append_comment_text(std::string& line, std::string_view text) {
    if (is_plain_comment(text))
        line.append(text);
    else
        line.append(comment_text(text));
}

std::string_view word_for(const Module& module, Id id) {
    if (is_texel(module, id)) return "texel";
    const Op op = module[id].op;
    if (op == Op::result_) {
        const Region& region = module.region(module[module[id].arg[0]].extra);
        const std::string_view name = region.name;
        return region.kind == RegionKind::loop ? "state" : name.substr(name.rfind('_') + 1);
    }
    return traits(op).word;
}

}  // namespace wrinkle
