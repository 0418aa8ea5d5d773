// Functions of panels, popups and the widgets that they share. A panel draws into the current ImGui
// window; a popup is a window of its own, which draws nothing while it is closed. ui.cpp has the
// table of panels.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/words.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

// Draws one frame of the window; call between ImGui::NewFrame() and ImGui::Render().
void draw_ui(State& state);

void draw_recent_files(State& state);  // rows of the File menu
// One-line hint in the middle of the status bar: available actions, or the current gesture's keys.
std::string_view hint_of(const State& state, const Regions& regions);
float problems_height(const State& state);
void next_problem(State& state);                   // shows its message and frames its node
std::string_view no_problems(const State& state);  // a sentence if there are none, else ""

// Returns true if there is no file, node or undo step, and no empty graph was requested.
bool is_at_start(const State& state);
// Returns the folder of the samples: ../share/wrinkle/graphs relative to the program's folder, or
// graphs in the source tree that it was built in; "" if neither exists.
std::filesystem::path samples_folder();
// Returns the samples sorted by name; skips graphs that cannot be read.
std::vector<Sample> list_samples(const std::filesystem::path& folder);

struct WindowStyle {
    ImVec2 padding{0, 0};
    ImU32 ground = 0, border = 0;  // border 0: none
    float rounding = 0;
    ImGuiWindowFlags flags = ImGuiWindowFlags_NoScrollbar;
    bool opening = false;  // takes focus
};

// ImGui window without decoration at a fixed position, ended by the destructor. A size of 0 is that
// of the content.
class FixedWindow {
public:
    FixedWindow(const char* id, ImVec2 at, ImVec2 size, const WindowStyle& style);
    FixedWindow(const FixedWindow&) = delete;
    FixedWindow& operator=(const FixedWindow&) = delete;
    ~FixedWindow();
    bool has_lost_focus() const;  // false while it opens

private:
    bool opening_;
};
// Flags of a window over a panel. It does not take focus, so that a drag on the panel continues.
inline constexpr ImGuiWindowFlags overlay_flags =
    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNavFocus |
    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoNavInputs;

// Modal window that is centered at the fraction `y` of the window's height, opened by the first
// call and ended by the destructor. False if it is not shown. A height of 0 is that of the content.
class Dialog {
public:
    Dialog(const char* id, ImVec2 size, ImVec2 padding, float rounding, float y = 0.5F);
    Dialog(const Dialog&) = delete;
    Dialog& operator=(const Dialog&) = delete;
    ~Dialog();
    explicit operator bool() const { return shown_; }

private:
    bool shown_;
};

// Registers a rectangle, or the ImGui item drawn last, as `target` for scripts.
void name_area(Interface& interface, const std::string& target, ImVec2 low, ImVec2 high);
void name_item(Interface& interface, const std::string& target);

// ImGui::InvisibleButton() of at least one pixel; a side of 0 would fail an assertion.
bool press_area(const char* id, ImVec2 size, ImGuiButtonFlags flags = 0);
// Invisible button at the cursor, in screen pixels; `target` is its id and its name for scripts.
struct Area {
    ImVec2 low, high;
    bool pressed, hovered;
};
Area area_button(Interface& interface, const std::string& target, ImVec2 size);

// Calls `draw` with the index of each row in sight; all rows have the same height.
template <class Draw>
void draw_rows(size_t count, float height, Draw draw) {
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count), height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            draw(static_cast<size_t>(i));
}

bool is_pressed(ImGuiKey key, bool repeat = true);
// Moves the index by the arrow keys, and by the page keys if `page` is not 0; stays in [0, count).
int moved_choice(int chosen, size_t count, int page = 0);
std::string percent(float part);  // "125 %" for 1.25
// Writes a paragraph, wrapped at `wrap` (0: at the right border of the window).
void write_paragraph(ImU32 color, const std::string& text, float wrap = 0);

// Draws the titles of the panels that share the lower part of the side column, at the upper left
// corner of the window; a click shows the panel. Returns the x position after them.
float draw_side_titles(State& state);
void draw_inputs(State& state);      // presets and inputs of the graph
void draw_input_rows(State& state);  // a row for each input that is displayed

// Popup of a panel, opened by ImGui::OpenPopup() and ended by the destructor; Escape closes it.
// False if it is not shown.
class PanelPopup {
public:
    explicit PanelPopup(const char* id);
    PanelPopup(const PanelPopup&) = delete;
    PanelPopup& operator=(const PanelPopup&) = delete;
    ~PanelPopup();
    explicit operator bool() const { return shown_; }
    bool is_left() const { return left_; }  // by Escape, in this frame

private:
    bool shown_, left_ = false;
};

inline constexpr float strip_tall = 28;
// Draws a one-line message with a mark at its left; returns false if the text is cut.
bool draw_strip(const Fonts& fonts, ImVec2 at, float width, ImU32 ground, ImU32 mark,
                const std::string& text);

// Button, named `target` for scripts; `chosen` highlights it. Returns true if pressed.
bool button(Interface& interface, const char* label, const std::string& target, bool chosen = false,
            ImVec2 size = {0, 0});
// Button of 24 x 24 pixels with an icon instead of a label; `tooltip` describes it.
bool icon_button(Interface& interface, const char* icon, const std::string& target,
                 const std::string& tooltip, bool enabled = true);

// Item of a combo box or a row of segments; `target` is its name for scripts.
struct Item {
    std::string label, target, tooltip = {};
    std::optional<uint32_t> image = {};  // in a list: its texture, 0 before it is drawn
};
// Row of segments, of which `chosen` is active. Returns the index that was clicked, or -1.
int segments(Interface& interface, std::span<const Item> items, int chosen, float width);
// Combo box with the current label, `shown`. Returns the index of the item that was picked, or -1.
int choose(Interface& interface, const std::string& target, const std::string& shown,
           std::span<const Item> items, float width);

// Contents of the popups of kinds ramp and curve; true when they are to be closed.
bool draw_ramp(State& state);
bool draw_curve(State& state);

// Color picker: RGB, HSV and hex code of display values (sRGB), OKLCh, and an eyedropper. The color
// is linear. Returns true if it changed; notes that it is held (note_held()).
bool pick_color(State& state, const std::string& target, std::array<float, 3>& linear);

// Requests keyboard focus for the text field that is drawn next; call note_field() after drawing
// it. ImGui focuses a field some frames after the request; the input queue holds back typed keys
// until then so that they are not lost.
void focus_field(Dialogs& dialogs);
void note_field(Dialogs& dialogs);  // ends the wait if the last field drawn has focus
// Returns true while an opened field does not have keyboard focus yet. The wait lasts a few frames
// at most, so that keys are delivered even if ImGui does not focus the field.
bool typing_waits(const Dialogs& dialogs);
void age_field_wait(Dialogs& dialogs);  // once a frame

// Notes that the control of a value, the last item drawn, is held down (refresh.h).
void note_held(Dialogs& dialogs);

// Opens the menu of the card, port, wire or box at the pointer, and selects it; on the open ground
// and on the cards of surface and inputs it does nothing.
void open_context_menu(State& state, const Hit& hit, ImVec2 at);
void open_selection_menu(State& state);  // the menu of the first selected node

// Opens the popup that edits the field: text, list or color. Tab continues with the next field.
void open_field(State& state, const Card& card, const Field& field);
void choose_image(State& state);  // opens a list of images; the chosen one is added
void edit_values(State& state);   // opens the first field of the selected node

}  // namespace wrinkle::editor
