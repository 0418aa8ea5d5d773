#include "import/texture_names.h"

#include <algorithm>
#include <array>

#include "base/case.h"
#include "base/text.h"

namespace wrinkle::textures {
namespace {

using enum Channel;
using enum Component;

constexpr ChannelSource color_rgb[] = {{color, rgb}};
constexpr ChannelSource color_and_opacity[] = {{color, rgb}, {opacity, alpha}};
constexpr ChannelSource normal_rgb[] = {{normal, rgb}};
constexpr ChannelSource rough_red[] = {{roughness, red}};
constexpr ChannelSource gloss_red[] = {{roughness, red, true}};
constexpr ChannelSource metal_red[] = {{metalness, red}};
constexpr ChannelSource occlusion_red[] = {{occlusion, red}};
constexpr ChannelSource height_red[] = {{height, red}};
constexpr ChannelSource opacity_red[] = {{opacity, red}};
constexpr ChannelSource emission_rgb[] = {{emission, rgb}};
constexpr ChannelSource orm[] = {{occlusion, red}, {roughness, green}, {metalness, blue}};
constexpr ChannelSource rma[] = {{roughness, red}, {metalness, green}, {occlusion, blue}};
constexpr ChannelSource mra[] = {{metalness, red}, {roughness, green}, {occlusion, blue}};
constexpr ChannelSource ord[] = {{occlusion, red}, {roughness, green}, {height, blue}};
constexpr ChannelSource gltf[] = {{roughness, green}, {metalness, blue}};
constexpr ChannelSource unity[] = {{metalness, red}, {roughness, alpha, true}};
constexpr ChannelSource hdrp[] = {{metalness, red}, {occlusion, green}, {roughness, alpha, true}};

// Alternatives of one role are separated by spaces.
struct Row {
    std::string_view keys;
    std::span<const ChannelSource> sources;
    uint8_t rank = 0;
    NamedGreen green = NamedGreen::unknown;
};

// clang-format off
constexpr Row rows[] = {
    {"basecolor basecolor albedo alb color color col bc basemap", color_rgb},
    {"diffuse diff diffusecolor diffusecolor d", color_rgb, 1},
    {"albedotransparency albedoopacity albedoalpha basecoloropacity basecoloralpha "
     "basecolortransparency diffusealpha", color_and_opacity},
    {"normalgl normalogl normalopengl norgl nrmgl", normal_rgb, 0, NamedGreen::gl},
    {"normal normals nor nrm norm tangentnormal n", normal_rgb, 1},
    {"normaldx normaldirectx nordx nrmdx", normal_rgb, 2, NamedGreen::dx},
    {"roughness rough rgh r", rough_red},
    {"gloss glossiness smoothness smooth", gloss_red, 1},
    {"metalness metallic metal mtl m", metal_red},
    {"ambientocclusion ambientocc occlusion occ ao", occlusion_red},
    {"height displacement displace disp dsp h", height_red},
    {"bump", height_red, 1},
    {"opacity alpha", opacity_red},
    {"emission emissive emit emissioncolor emissivecolor e", emission_rgb},
    {"orm arm occlusionroughnessmetallic occlusionroughnessmetalness aoroughnessmetallic "
     "aoroughmetal ambientocclusionroughnessmetallic", orm, 2},
    {"rma roughnessmetallicao roughnessmetallicocclusion", rma, 2},
    {"mra metallicroughnessao metallicroughnessocclusion", mra, 2},
    {"ord ordp occlusionroughnessdisplacement", ord, 2},
    {"metallicroughness metalnessroughness", gltf, 2},
    {"metallicsmoothness metallicgloss", unity, 3},
    {"maskmap", hdrp, 3},
    {"specular spec specularlevel reflection refl cavity cav curvature thickness translucency fuzz preview "
     "thumbnail normalobject objectnormal worldnormal", {}},
};
// clang-format on

constexpr size_t max_key_words = 4;

struct Word {
    std::string text;  // lower case
    size_t begin = 0;  // in the name
};

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_upper(char c) {
    return c >= 'A' && c <= 'Z';
}
bool is_lower(char c) {
    return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;  // or part of UTF-8
}

// Returns true if a word begins at `i`, after another character of a word.
bool begins_word(std::string_view name, size_t i) {
    const char before = name[i - 1], here = name[i];
    if (is_digit(here))
        return !is_digit(before) && (before != 'x' || i < 2 || !is_digit(name[i - 2]));
    if (!is_upper(here)) return false;
    return is_lower(before) || (is_upper(before) && i + 1 < name.size() && is_lower(name[i + 1]));
}

std::vector<Word> words_of(std::string_view name) {
    std::vector<Word> words;
    bool inside = false;
    for (size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        const bool is_part = is_digit(c) || is_upper(c) || is_lower(c);
        if (is_part && (!inside || begins_word(name, i))) words.push_back({"", i});
        if (is_part) words.back().text += lower_case(c);
        inside = is_part;
    }
    return words;
}

bool all_digits(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, is_digit);
}

// "2k", "2048x1024".
bool is_resolution(std::string_view word) {
    if (word.ends_with('k')) return all_digits(word.substr(0, word.size() - 1));
    const size_t cross = word.find('x');
    return cross != word.npos && all_digits(word.substr(0, cross)) &&
           all_digits(word.substr(cross + 1));
}

// Resolution, format, bit depth, color space, level of detail or index.
bool is_qualifier(std::string_view word) {
    static constexpr std::string_view known[] = {
        "map",   "tex",    "texture", "png",  "jpg",     "jpeg", "exr",  "tif",  "tiff",
        "tga",   "lod",    "var",     "srgb", "raw",     "bit",  "bits", "8bit", "16bit",
        "32bit", "linear", "256",     "512",  "utility", "s",    "rgb"};
    if (std::ranges::find(known, word) != std::end(known)) return true;
    if (is_resolution(word)) return true;
    return all_digits(word) && word.size() != 3 && word.size() <= 5;
}

const TextureRole* role_of_key(std::string_view key) {
    static const std::vector<TextureRole> roles = [] {
        std::vector<TextureRole> made;
        for (const Row& row : rows)
            for (const std::string_view each : split(row.keys, ' '))
                made.push_back({each, row.sources, row.green, row.rank});
        return made;
    }();
    const auto found = std::ranges::find(roles, key, &TextureRole::key);
    return found == roles.end() ? nullptr : &*found;
}

struct Match {
    std::vector<Word> words;
    const TextureRole* role = nullptr;
    size_t begin = 0, end = 0;  // words of the key
};

// Finds the longest key that ends with word `end`.
bool match_before(Match& match, size_t end) {
    const size_t most = std::min(max_key_words, end);
    for (size_t count = most; count > 0; --count) {
        std::string key;
        for (size_t i = end - count; i < end; ++i)
            key += match.words[i].text;
        if (const TextureRole* role = role_of_key(key)) {
            match.role = role;
            match.begin = end - count;
            match.end = end;
            return true;
        }
    }
    return false;
}

// Finds a key before word `end`, skipping qualifiers; without one the match is unchanged.
void match_from(Match& match, size_t end) {
    while (end > 0 && !match_before(match, end) && is_qualifier(match.words[end - 1].text))
        --end;
}

Match match_of(std::string_view stem) {
    Match match;
    match.words = words_of(stem);
    match_from(match, match.words.size());
    // Poliigon: "Bricks01_COL_2K_METALNESS", where the last word names the workflow.
    const bool is_workflow =
        match.role && (match.role->key == "metalness" || match.role->key == "specular");
    if (is_workflow && match.begin > 1 && is_resolution(match.words[match.begin - 1].text))
        match_from(match, match.begin - 1);
    return match;
}

// Returns the number of words that all matches begin with.
size_t common_words(const std::vector<const Match*>& matches) {
    if (matches.size() < 2) return 0;
    size_t count = matches.front()->words.size();
    for (const Match* match : matches) {
        const auto [a, b] = std::ranges::mismatch(matches.front()->words, match->words, {},
                                                  &Word::text, &Word::text);
        count = std::min(count, static_cast<size_t>(a - matches.front()->words.begin()));
    }
    return count;
}

std::vector<const Match*> recognised(const std::vector<Match>& matches) {
    std::vector<const Match*> found;
    for (const Match& match : matches)
        if (match.role) found.push_back(&match);
    return found;
}

// Drops the names that end within the common beginning, unless none would remain.
void drop_names_of_set(std::vector<Match>& matches) {
    const size_t common = common_words(recognised(matches));
    const auto is_set = [&](const Match& match) { return match.role && match.end <= common; };
    const bool others = std::ranges::any_of(
        matches, [&](const Match& match) { return match.role && !is_set(match); });
    for (Match& match : matches)
        if (others && is_set(match)) match.role = nullptr;
}

std::string set_name(const std::vector<Match>& matches, std::span<const std::string> stems) {
    const std::vector<const Match*> found = recognised(matches);
    if (found.empty()) return {};
    size_t end = found.size() > 1 ? common_words(found) : found.front()->begin;
    for (const Match* match : found)
        end = std::min(end, match->begin);
    const Match& first = *found.front();
    const auto is_trailing = [&](const std::string& word) {
        return is_qualifier(word) && !(all_digits(word) && word.size() <= 3);
    };
    while (end > 0 && is_trailing(first.words[end - 1].text))
        --end;
    if (end == 0) return {};
    const std::string& stem = stems[static_cast<size_t>(found.front() - matches.data())];
    const Word& last = first.words[end - 1];
    return stem.substr(first.words[0].begin, last.begin + last.text.size() - first.words[0].begin);
}

}  // namespace

std::string_view name_of(Channel channel) {
    static constexpr std::array<std::string_view, channel_count> names = {
        "color", "normal", "roughness", "metalness", "occlusion", "height", "opacity", "emission"};
    return names[static_cast<size_t>(channel)];
}

std::string_view name_of(Component component) {
    static constexpr std::array<std::string_view, 5> names = {"color", "red", "green", "blue",
                                                              "alpha"};
    return names[static_cast<size_t>(component)];
}

RecognisedNames recognise(std::span<const std::string> stems) {
    std::vector<Match> matches;
    for (const std::string& stem : stems)
        matches.push_back(match_of(stem));
    drop_names_of_set(matches);
    RecognisedNames result;
    for (const Match& match : matches)
        result.roles.push_back(match.role);
    result.set = set_name(matches, stems);
    return result;
}

}  // namespace wrinkle::textures
