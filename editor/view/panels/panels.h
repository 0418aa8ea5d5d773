// Functions of panels, popups and the widgets that they share. A panel draws into the current ImGui
// window; a popup is a window of its own, which draws nothing while it is closed. ui.cpp has the
// table of panels.
#pragma once

#include <filesystem>
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

// ImGui window without decoration at a fixed position, ended by the destructor.
class FixedWindow {
public:
    FixedWindow(const char* id, ImVec2 at, ImVec2 size, ImGuiWindowFlags flags, ImU32 color = 0,
                ImVec2 padding = {0, 0});
    FixedWindow(const FixedWindow&) = delete;
    FixedWindow& operator=(const FixedWindow&) = delete;
    ~FixedWindow();
};
// Flags of a window over a panel. It does not take focus, so that a drag on the panel continues.
inline constexpr ImGuiWindowFlags overlay_flags = ImGuiWindowFlags_NoBackground |
                                                  ImGuiWindowFlags_NoFocusOnAppearing |
                                                  ImGuiWindowFlags_NoNavFocus;

// Registers a rectangle, or the ImGui item drawn last, as `target` for scripts.
void name_area(Interface& interface, const std::string& target, ImVec2 low, ImVec2 high);
void name_item(Interface& interface, const std::string& target);

bool is_pressed(ImGuiKey key, bool repeat = true);
// Moves the index by the arrow keys, and by the page keys if `page` is not 0; stays in [0, count).
int moved_choice(int chosen, size_t count, int page = 0);
// Writes a paragraph, wrapped at `wrap` (0: at the right border of the window).
void write_paragraph(ImU32 color, const std::string& text, float wrap = 0);

// Button, named `target` for scripts; `chosen` highlights it. Returns true if pressed.
bool button(Interface& interface, const char* label, const std::string& target, bool chosen = false,
            ImVec2 size = {0, 0});
// Button of 24 x 24 pixels with an icon instead of a label; `tooltip` describes it.
bool icon_button(Interface& interface, const char* icon, const std::string& target,
                 const std::string& tooltip, bool enabled = true);

// Row of segments, of which `chosen` is active. Returns the index that was clicked, or -1.
struct Segment {
    std::string label, target, tooltip = {};
};
int segments(Interface& interface, std::span<const Segment> all, int chosen, float width);

// Items of a combo box: labels and script targets by index; `chosen` is the current one, or -1.
struct Choices {
    std::vector<std::string> labels, targets;
    int chosen = -1;

    void add(std::string label, std::string target, bool is_chosen = false) {
        if (is_chosen) chosen = static_cast<int>(labels.size());
        labels.push_back(std::move(label));
        targets.push_back(std::move(target));
    }
};
// Combo box that shows `shown` while it is closed. Returns the index that was picked, or -1.
int choose(Interface& interface, const std::string& target, const std::string& shown,
           const Choices& choices, float width);

// Requests keyboard focus for the text field that is drawn next; call note_field() after drawing
// it. ImGui focuses a field some frames after the request; the input queue holds back typed keys
// until then so that they are not lost.
void focus_field(Dialogs& dialogs);
void note_field(Dialogs& dialogs);  // ends the wait if the last field drawn has focus
// Returns true while an opened field does not have keyboard focus yet. The wait lasts a few frames
// at most, so that keys are delivered even if ImGui does not focus the field.
bool typing_waits(const Dialogs& dialogs);
void age_field_wait(Dialogs& dialogs);  // once a frame

// Opens the popup that edits the field: text, list or color. Tab continues with the next field.
void open_field(State& state, const Card& card, const Field& field);
void choose_image(State& state);  // opens a list of images; the chosen one is added
void edit_values(State& state);   // opens the first field of the selected node

}  // namespace wrinkle::editor
