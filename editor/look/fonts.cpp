#include "editor/look/fonts.h"

#include <imgui_freetype.h>

#include <filesystem>
#include <initializer_list>

namespace wrinkle::editor {
namespace {

struct Face {
    const char* file;
    float scale;  // so that all faces look equally large
};

constexpr Face regular_faces[] = {{"/usr/share/fonts/opentype/inter/Inter-Regular.otf", 1},
                                  {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 0.94F}};
constexpr Face bold_faces[] = {{"/usr/share/fonts/opentype/inter/Inter-SemiBold.otf", 1},
                               {"/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", 0.90F}};
constexpr Face code_faces[] = {
    {"/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf", 1},
    {"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf", 0.94F}};

constexpr float sizes[] = {8, 9, 10, 11, 12, 13, 14, 15, 16, 18, 20, 24, 28, 36, 48};

// Latin, Greek, general punctuation, arrows, operators.
constexpr ImWchar ranges[] = {0x20,   0xFF,   0x370,  0x3FF,  0x2010, 0x2026,
                              0x2190, 0x21FF, 0x2200, 0x22FF, 0};

template <size_t N>
const Face* installed(const Face (&faces)[N]) {
    for (const Face& face : faces)
        if (std::filesystem::exists(face.file)) return &face;
    return nullptr;
}

ImFont* add(const Face* face, float size) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImFontConfig config;
    config.SizePixels = size;
    if (!face) return atlas.AddFontDefault(&config);
    return atlas.AddFontFromFileTTF(face->file, size * face->scale, nullptr, ranges);
}

}  // namespace

void Fonts::load() {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    io.Fonts->FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    io.Fonts->TexDesiredWidth = 2048;
    const Face* regular = installed(regular_faces);
    const Face* bold = installed(bold_faces);
    for (const float size : sizes) {
        regular_.push_back(add(regular, size));
        bold_.push_back(add(bold ? bold : regular, size));
    }
    code_ = add(installed(code_faces), 15);
    io.FontDefault = Fonts::regular(16);
    io.Fonts->Build();
}

ImFont* Fonts::nearest(const std::vector<ImFont*>& fonts, float size) {
    for (size_t i = 0; i < fonts.size(); ++i)
        if (sizes[i] >= size - 0.5F) return fonts[i];
    return fonts.back();
}

}  // namespace wrinkle::editor
