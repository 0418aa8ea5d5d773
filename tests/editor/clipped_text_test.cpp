// No text of panels, dialogs and cards is cut at the right or left border of its box, or shortened
// to end with "...", at four window sizes. Text that scrolls or moves with the canvas is left out.
#include <array>
#include <map>
#include <set>

#include "editor/view/commands/commands.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

struct Size {
    ImVec2 points;
    float scale;  // pixels per point
};
const Size sizes[] = {{{1280, 720}, 1}, {{1600, 900}, 1}, {{2560, 1440}, 1}, {{1920, 1080}, 2}};

// Text of the canvas and of lines of code may be cut.
bool may_be_cut(std::string_view owner) {
    return owner == "##canvas" || owner.find("##code") != std::string_view::npos;
}

// A letter as drawn.
struct Letter {
    char32_t code = 0;
    ImVec2 low, high;  // as far as it has ink
    ImVec4 clip;
};

using Codes = std::map<std::pair<float, float>, char32_t>;  // by the corner in the font's texture

Codes codes_of_fonts() {
    Codes codes;
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
        for (const ImFontGlyph& glyph : font->Glyphs)
            codes[{glyph.U0, glyph.V0}] = static_cast<char32_t>(glyph.Codepoint);
    return codes;
}

std::vector<Letter> letters_of(const ImDrawList& list, const Codes& codes) {
    std::vector<Letter> letters;
    for (const ImDrawCmd& command : list.CmdBuffer)
        for (unsigned i = 0; i + 6 <= command.ElemCount; i += 3) {
            const ImDrawIdx* index = &list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
            if (index[3] != index[0] || index[4] != index[2] || index[5] != index[0] + 3) continue;
            const ImDrawVert* a = &list.VtxBuffer[static_cast<int>(command.VtxOffset + index[0])];
            if (a[0].uv.x >= a[1].uv.x || a[0].uv.y >= a[2].uv.y) continue;  // no letter
            const auto code = codes.find({a[0].uv.x, a[0].uv.y});
            letters.push_back(
                {code == codes.end() ? U'?' : code->second, a[0].pos, a[2].pos, command.ClipRect});
        }
    return letters;
}

bool is_in_sight(const Letter& letter) {
    return letter.high.y > letter.clip.y && letter.low.y < letter.clip.w;
}

bool is_cut(const Letter& letter) {
    return letter.low.x < letter.clip.x - 1 || letter.high.x > letter.clip.z + 1;
}

std::string place_of(const ImDrawList& list, const Letter& letter) {
    return std::string(list._OwnerName) + " at " + std::to_string(static_cast<int>(letter.low.x)) +
           ", " + std::to_string(static_cast<int>(letter.low.y));
}

// Returns the word that ends with letter `last`, without spaces.
std::string word_before(const std::vector<Letter>& letters, size_t last) {
    std::string word;
    for (size_t i = last + 1; i-- > 0 && last - i < 24;) {
        if (i < last && letters[i + 1].low.x - letters[i].high.x > 12) break;
        if (i < last && letters[i + 1].low.x < letters[i].low.x) break;
        word.insert(word.begin(), letters[i].code < 128 ? static_cast<char>(letters[i].code) : '?');
    }
    return word;
}

// Labels of commands and buttons that open a dialog, without spaces.
std::set<std::string> labels_with_dots() {
    std::set<std::string> labels = {"Browse..."};
    for (const Command& command : commands()) {
        std::string label(command.title);
        std::erase(label, ' ');
        if (label.ends_with("...")) labels.insert(label);
    }
    return labels;
}

// Returns the windows with letters that stick out of their clip rectangle sideways, and with cut
// words, with positions. A doc line of the search may be cut: the chosen row shows it whole.
std::set<std::string> windows_with_cut_text() {
    std::set<std::string> found;
    const Codes codes = codes_of_fonts();
    const std::set<std::string> labels = labels_with_dots();
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int n = 0; n < data.CmdListsCount; ++n) {
        const ImDrawList& list = *data.CmdLists[n];
        if (may_be_cut(list._OwnerName)) continue;
        const std::vector<Letter> letters = letters_of(list, codes);
        for (size_t i = 0; i < letters.size(); ++i) {
            if (!is_in_sight(letters[i])) continue;
            if (is_cut(letters[i])) found.insert(place_of(list, letters[i]));
            if (std::string_view(list._OwnerName) == "##palette") continue;
            const std::string word = word_before(letters, i);
            if (word.ends_with("...") && !labels.contains(word))
                found.insert(place_of(list, letters[i]) + ": " + word);
        }
    }
    return found;
}

class ClippedText : public Headless {
protected:
    void expect_none(const std::string& shown) {
        const std::set<std::string> found = windows_with_cut_text();
        std::string text;
        for (const std::string& window : found)
            text += window + "\n";
        const ImVec2 room = ImGui::GetIO().DisplaySize;
        EXPECT_EQ(text, "") << shown << ", " << room.x << " x " << room.y;
    }
    template <typename Check>
    void at_each_size(const Check& check) {
        for (const Size& size : sizes) {
            ImGui::GetIO().DisplaySize = size.points;
            ImGui::GetIO().DisplayFramebufferScale = {size.scale, size.scale};
            for (int i = 0; i < 4; ++i)
                frame();
            check();
        }
    }
};

TEST_F(ClippedText, NoneOnTheStartPage) {
    at_each_size([&] { expect_none("start page"); });
}

TEST_F(ClippedText, NoneWithAGraph) {
    open(text_of(std::filesystem::path(WRINKLE_SOURCE_DIR) / "graphs/materials/lava.json"));
    state.status.clear();  // a long path is cut
    at_each_size([&] {
        expect_none("code");
        play("key Shift+E");
        expect_none("inputs");
        play("key Shift+E");
    });
}

TEST_F(ClippedText, NoneInDialogsAndLists) {
    open(small_graph);
    constexpr std::array<const char*, 12> keys = {
        "Space",  "Ctrl+P",       "Ctrl+H", "Ctrl+F",   "Ctrl+B", "Ctrl+Shift+E",
        "Ctrl+O", "Ctrl+Shift+S", "F1",     "Shift+F1", "7",      "S"};
    at_each_size([&] {
        for (const char* key : keys) {
            play(std::string("key ") + key + "\nwait 3");
            expect_none(key);
            play("key Escape\nwait 2");
        }
    });
}

}  // namespace
}  // namespace wrinkle::editor
