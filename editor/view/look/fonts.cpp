#include "editor/view/look/fonts.h"

#include <imgui_freetype.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <set>

namespace wrinkle::editor {
namespace {

struct Face {
    const char* file;
    float scale;  // makes all faces appear equally large
};

constexpr Face regular_faces[] = {{"/usr/share/fonts/opentype/inter/Inter-Regular.otf", 1},
                                  {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 0.875F}};
constexpr Face bold_faces[] = {{"/usr/share/fonts/opentype/inter/Inter-SemiBold.otf", 1},
                               {"/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", 0.85F}};
constexpr Face code_faces[] = {
    {"/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf", 1},
    {"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf", 0.875F}};

// Device pixels. Each size is at least four fifths of the next; up to `whole` all integers are
// included.
constexpr float sizes[] = {6,  7,  8,  9,  10, 11, 12, 13, 14, 15, 16, 17,
                           18, 19, 20, 24, 28, 34, 40, 48, 58, 72, 90, 112};
constexpr float whole = 20;
constexpr float interface_sizes[] = {14, 16, 18, 24};  // logical pixels
constexpr float max_zoom = 4, largest_text = 18;

// Latin, Greek, general punctuation, arrows, operators.
constexpr ImWchar all_letters[] = {0x20,   0xFF,   0x370,  0x3FF,  0x2010, 0x2026,
                                   0x2190, 0x21FF, 0x2200, 0x22FF, 0};
// Glyphs for names and numbers only: large sizes take long to bake.
constexpr ImWchar few_letters[] = {0x20, 0xFF, 0x391, 0x3C9, 0x2013, 0x2026, 0};

template <size_t N>
const Face* installed(const Face (&faces)[N]) {
    for (const Face& face : faces)
        if (std::filesystem::exists(face.file)) return &face;
    return nullptr;
}

ImFont* add(const Face* face, float pixels, float scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImFontConfig config;
    config.SizePixels = pixels;
    const ImWchar* letters = pixels > 24 * scale ? few_letters : all_letters;
    ImFont* font =
        face ? atlas.AddFontFromFileTTF(face->file, pixels * face->scale, nullptr, letters)
             : atlas.AddFontDefault(&config);
    font->Scale = 1 / scale;
    return font;
}

std::set<float> wanted_sizes(float scale) {
    std::set<float> wanted;
    for (const float size : interface_sizes)
        wanted.insert(size * scale);
    for (const float size : sizes) {
        wanted.insert(size);
        if (size >= largest_text * max_zoom * scale) break;
    }
    return wanted;
}

// Gives all digits the width of the widest, so that a dragged number does not shift.
void level_digits(ImFont& font) {
    float widest = 0;
    for (ImWchar c = '0'; c <= '9'; ++c)
        widest = std::max(widest, font.GetCharAdvance(c));
    for (ImFontGlyph& glyph : font.Glyphs) {
        if (glyph.Codepoint < '0' || glyph.Codepoint > '9') continue;
        const float shift = std::floor((widest - glyph.AdvanceX) / 2);
        glyph.X0 += shift;
        glyph.X1 += shift;
        glyph.AdvanceX = widest;
    }
    font.BuildLookupTable();
}

}  // namespace

void Fonts::load(float scale) {
    static uint64_t loads = 0;
    generation_ = ++loads;
    scale_ = scale;
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    io.Fonts->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    io.Fonts->FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    io.Fonts->TexDesiredWidth = 2048;
    const Face* regular = installed(regular_faces);
    const Face* bold = installed(bold_faces);
    regular_.clear();
    bold_.clear();
    for (const float pixels : wanted_sizes(scale)) {
        regular_.push_back({pixels, add(regular, pixels, scale)});
        bold_.push_back({pixels, add(bold ? bold : regular, pixels, scale)});
    }
    code_ = add(installed(code_faces), 16 * scale, scale);
    io.FontDefault = Fonts::regular(16);
    io.Fonts->Build();
    for (ImFont* font : io.Fonts->Fonts)
        level_digits(*font);
}

const Fonts::Baked& Fonts::at_least(const std::vector<Baked>& fonts, float pixels) {
    for (const Baked& baked : fonts)
        if (baked.pixels >= pixels - 0.01F) return baked;
    return fonts.back();
}

ImFont* Fonts::magnified(bool bold, float size, float& drawn) const {
    const float pixels = size * scale_;
    const Baked& baked =
        at_least(bold ? bold_ : regular_, pixels <= whole ? std::round(pixels) : pixels);
    const float part = pixels <= whole ? 1 : std::min(pixels / baked.pixels, 1.0F);
    drawn = baked.font->FontSize * part / scale_;
    return baked.font;
}

}  // namespace wrinkle::editor
