// Any events, in any order, over the real interface: the program's own checks and ImGui's stay
// quiet. WRINKLE_EVENTS says how many, WRINKLE_SEED which.
#include <GLFW/glfw3.h>

#include <cstdlib>
#include <random>

#include "editor/commands/commands.h"
#include "editor/document/files.h"
#include "graph/read.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

int from_environment(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atoi(text) : otherwise;
}

// Hands that mostly know where things are, and hold keys and buttons across each other.
class RandomEvents {
public:
    RandomEvents(State& state, InputQueue& queue, unsigned seed)
        : state_(state), queue_(queue), random_(seed) {}

    void next() {
        if (state_.question.open() && pick(5) == 0) return void(queue_.chord("Escape"));
        switch (pick(16)) {
            case 0:
            case 1:
            case 2:
                return somewhere();
            case 3:
                return queue_.button(static_cast<int>(pick(3)), pick(2) == 0);
            case 4:
            case 5:
                somewhere();
                queue_.button(pick(6) ? 0 : 1, true);
                return queue_.button(pick(6) ? 0 : 1, false);
            case 6:
                return queue_.wheel(pick(4) ? 0.0F : 1.0F, static_cast<float>(pick(7)) - 3);
            case 7:
                return queue_.key(any_key(), pick(2) == 0);
            case 8: {
                const auto all = commands();
                const Command& command = all[pick(all.size())];
                if (!command.keys.empty()) queue_.chord(command.keys);
                return;
            }
            case 9:
                return queue_.type(any_text());
            case 11:
            case 12:
            case 13:
                somewhere();
                queue_.button(0, true);
                for (size_t n = 1 + pick(4); n > 0; --n)
                    somewhere();
                return queue_.button(0, false);
            case 14: {  // a node from the palette
                queue_.chord("Space");
                queue_.type(any_text());
                queue_.chord("Enter");
                return;
            }
            case 10:
                queue_.chord(pick(3) ? "Enter" : pick(2) ? "Escape" : "Tab");
                return;
            default:
                if (pick(5) == 0) queue_.push({InputEvent::Kind::leave, 0, false, 0, 0});
        }
    }
    void let_go() {
        for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key)
            queue_.key(key, false);
        for (int button = 0; button < 3; ++button)
            queue_.button(button, false);
    }

private:
    size_t pick(size_t count) { return random_() % count; }
    float part(float whole) { return static_cast<float>(pick(1000)) / 1000 * whole; }

    void somewhere() {
        const auto& all = state_.targets.all();
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        if (all.empty() || pick(4) == 0)
            return queue_.motion(part(size.x * 1.2F) - 50, part(size.y * 1.2F) - 50);
        // Mostly things of the graph: there are more lines of code than cards.
        auto chosen = std::next(all.begin(), static_cast<int>(pick(all.size())));
        const auto graph = [&] {
            for (const char* kind : {"pin:", "out:", "node:", "field:", "canvas"})
                if (chosen->first.starts_with(kind)) return true;
            return false;
        };
        for (int tries = 0; tries < 20 && !graph(); ++tries)
            chosen = std::next(all.begin(), static_cast<int>(pick(all.size())));
        const TargetRect rect = chosen->second;
        queue_.motion(rect.x0 + part(rect.x1 - rect.x0), rect.y0 + part(rect.y1 - rect.y0));
    }
    int any_key() {
        static constexpr int keys[] = {
            GLFW_KEY_LEFT_CONTROL, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_LEFT_ALT, GLFW_KEY_SPACE,
            GLFW_KEY_DELETE,       GLFW_KEY_BACKSPACE,  GLFW_KEY_UP,       GLFW_KEY_DOWN,
            GLFW_KEY_LEFT,         GLFW_KEY_RIGHT,      GLFW_KEY_HOME,     GLFW_KEY_END,
            GLFW_KEY_F1,           GLFW_KEY_F5,         GLFW_KEY_F11,      GLFW_KEY_KP_ENTER};
        return pick(2) ? keys[pick(std::size(keys))] : 'A' + static_cast<int>(pick(26));
    }
    // No path leads out of the folder that the test stands in.
    std::string any_text() {
        static const std::string texts[] = {"0.5",      "-1e300",     "nan", "%s%n",
                                            "add",      "noise",      "a.b", "\xC3\xA9\xE2\x82\xAC",
                                            "\xFF\xFE", "graph.json", "x y", std::string(300, 'w'),
                                            "1e-320",   "$x",         "\"",  "surface"};
        return texts[pick(std::size(texts))];
    }

    State& state_;
    InputQueue& queue_;
    std::mt19937 random_;
};

TEST_F(Headless, ADragOutOfTheWindowKeepsTheCardWhereItWas) {
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

TEST_F(Headless, AnyEventsAreSurvived) {
    const int count = from_environment("WRINKLE_EVENTS", 3000);
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    open(small_graph);
    RandomEvents events(state, queue, static_cast<unsigned>(from_environment("WRINKLE_SEED", 1)));
    std::mt19937 random(1);
    size_t steps = 0;
    for (int i = 0; i < count; ++i) {
        events.next();
        while (!queue.empty() && random() % 12)  // now and then the hands are faster
            frame();
        if (i % 40 == 0) events.let_go();  // a key that stays down hides the others
        state.quit = false;
        if (random() % 500 == 0)
            ImGui::GetIO().DisplaySize = {400.0F + static_cast<float>(random() % 1600),
                                          300.0F + static_cast<float>(random() % 900)};
        if (state.document().nodes.size() > 300 || i % 2000 == 1999) {
            steps += state.history.size();
            state.question = {};
            open_file(state, folder.write("graph.json", small_graph));
        }
    }
    events.let_go();
    while (!queue.empty())
        frame();
    // What is left is a graph that can be read back.
    Diagnostics problems;
    const std::string text = write_document(state.document());
    EXPECT_EQ(canonical_text(read_document(text, "again.json", problems)),
              canonical_text(state.document()));
    fs::current_path(before);
    std::printf("%d events, %llu texts generated, %zu steps\n", count,
                static_cast<unsigned long long>(state.counters.builds),
                steps + state.history.size());
}

}  // namespace
}  // namespace wrinkle::editor
