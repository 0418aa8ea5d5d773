// Tests of arbitrary events in arbitrary order at three zooms on the real interface: no check of
// the program or of ImGui fails, enough events are edits, every edit can be undone to the byte,
// nothing stays open. WRINKLE_EVENTS sets the number of events, WRINKLE_SEED the seed.
#include <GLFW/glfw3.h>

#include <cstdlib>
#include <map>
#include <random>

#include "editor/model/document/files.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/commands/commands.h"
#include "graph/read.h"
#include "graph/write.h"
#include "headless.h"
#include "random_events.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

int from_environment(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atoi(text) : otherwise;
}

class Events : public Headless {
protected:
    // Checks that the document has the same text whenever the history returns to a state.
    void look() {
        if (!state.is_synced) return;  // another file is loaded in the next frame
        if (state.follow.first != opened_) texts_.clear();
        opened_ = state.follow.first;
        state.quit = false;
        const uint64_t serial = state.history.serial();
        if (texts_.contains(serial) && serial == serial_) return;
        serial_ = serial;
        const std::string text = write_document(state.document());
        const auto [known, is_new] = texts_.emplace(serial, text);
        ASSERT_EQ(known->second, text) << "undo or redo led elsewhere";
        const bool is_step = is_new && state.history.at() != at_;  // a drag is one step
        at_ = state.history.at();
        edits_ += is_step;
        if (is_step && edits_ % 16 == 0) expect_round_trip();
    }
    void expect_round_trip() {
        Diagnostics problems;
        const std::string text = canonical_text(state.document());
        EXPECT_EQ(canonical_text(read_document(text, "again.json", problems)), text);
    }
    void run_frames(std::mt19937& random) {
        while (!queue.empty() && random() % 30 && !HasFatalFailure()) {  // may stop early
            frame();
            look();
        }
    }
    void drain() {
        while (!queue.empty())
            frame();
    }

    // Opens the graph again at the zoom of the round.
    void begin_round(size_t round) {
        open_file(state, folder.write("graph.json", small_graph));
        ImGui::GetIO().DisplaySize = {1600, 900};
        frame();
        constexpr float zooms[] = {1, 0.25F, 2.5F};
        zoom_at(state.view, state.layout, {500, 400}, zooms[round % 3] / state.view.zoom);
    }

    // Closes everything that is open with Escape.
    void leave_all(RandomEvents& events) {
        events.reset_interaction();
        for (int i = 0; i < 8; ++i) {
            queue.chord("Escape");
            drain();
            frame();
        }
        EXPECT_FALSE(state.question.open()) << "a question stays";
        EXPECT_TRUE(state.browser.purpose == Browser::Purpose::none) << "the browser stays";
        EXPECT_FALSE(state.palette.open) << "the search stays";
        EXPECT_TRUE(state.popup.kind == Popup::Kind::none) << "a popup stays";
        EXPECT_FALSE(state.offer.open) << "an offer stays";
        EXPECT_TRUE(state.gesture.kind == Gesture::Kind::none) << "a gesture stays";
    }

    // Undoes to the first state and redoes to the last.
    void undo_and_redo_all() {
        const std::string last = write_document(state.document());
        const size_t steps = state.history.at();
        for (size_t i = 0; i < steps && !HasFatalFailure(); ++i)
            state.history.undo(), look();
        frame();
        EXPECT_FALSE(state.history.can_undo());
        while (state.history.at() < steps && !HasFatalFailure())
            state.history.redo(), look();
        frame();
        EXPECT_EQ(write_document(state.document()), last);
    }

    size_t edits_ = 0;

private:
    std::map<uint64_t, std::string> texts_;  // by serial
    uint64_t opened_ = 0, serial_ = ~uint64_t{0};
    size_t at_ = 0;  // index in the history
};

TEST_F(Events, ADragOutOfTheWindowKeepsTheCardWhereItWas) {
    open(small_graph);
    state.view.zoom = 0.5F;
    frame();
    const auto node = *state.targets.find("node:softer");
    queue.motion(node.middle_x(), node.middle_y());
    queue.button(0, true);
    queue.motion(node.middle_x() + 20, node.middle_y());
    while (!queue.empty())
        frame();
    queue.motion(node.middle_x() + 40, node.middle_y());
    while (!queue.empty())
        frame();
    queue.push({InputEvent::Kind::leave, 0, false, 0, 0});
    while (!queue.empty())
        frame();
    queue.button(0, false);
    while (!queue.empty())
        frame();
    frame();
    EXPECT_EQ(state.layout.find("softer")->at.x, 272 + 80);
    EXPECT_EQ(state.layout.find("softer")->at.y, 0);
}

TEST_F(Events, AnyAreSurvivedAndUndone) {
    const auto count = static_cast<size_t>(from_environment("WRINKLE_EVENTS", 3000));
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    begin_round(0);
    RandomEvents events(state, queue, static_cast<unsigned>(from_environment("WRINKLE_SEED", 1)));
    std::mt19937 random(1);
    size_t gestures = 0, rounds = 0;
    while (events.count() < count && !HasFailure()) {
        events.next();
        run_frames(random);
        if (++gestures % 6 == 0) events.reset_interaction();  // a held key masks the others
        if (random() % 300 == 0)
            ImGui::GetIO().DisplaySize = {400.0F + static_cast<float>(random() % 1600),
                                          300.0F + static_cast<float>(random() % 900)};
        if (state.document().nodes.size() < 30 && events.count() < (rounds + 1) * 1000) continue;
        leave_all(events);
        undo_and_redo_all();
        expect_round_trip();
        rounds = events.count() / 1000;
        begin_round(rounds);
    }
    leave_all(events);
    undo_and_redo_all();
    expect_round_trip();
    fs::current_path(before);
    std::printf("%zu events in %zu gestures: %zu edits, %llu texts generated\n", events.count(),
                gestures, edits_, static_cast<unsigned long long>(state.counters.builds));
    // Of 60 seeds the median has an edit in 9.1 events, the worst in 11.9. It was 49 with a panel
    // or dialog over the canvas that stayed there.
    EXPECT_GE(edits_ * 20, events.count()) << "the hands aim too badly";
}

}  // namespace
}  // namespace wrinkle::editor
