// Tests of an editor process that is killed at any time: no committed edit is lost, no file is half
// written. WRINKLE_KILLS sets the number of kills; default: 6.
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <random>
#include <thread>

#include "base/text.h"
#include "editor/model/document/files.h"
#include "editor/model/document/recovery.h"
#include "editor/view/lifecycle.h"
#include "graph/read.h"
#include "graph/write.h"
#include "headless.h"
#include "running_editor.h"
#include "virtual_screen.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

int kills() {
    const char* wanted = std::getenv("WRINKLE_KILLS");
    return wanted ? std::atoi(wanted) : 6;
}

// Script that counts upwards in one field, with saves and drags in between, and prints each number.
std::string counting_script(int from) {
    std::string script;
    for (int i = from; i < from + 400; ++i) {
        const std::string number = std::to_string(i);
        script +=
            "double field:softer.amount\ntype " + number + "\nkey Enter\nsay " + number + "\n";
        if (i % 3 == 0) script += "say saving\nkey Ctrl+S\n";
        if (i % 5 == 0) script += "drag field:noise.scale field:noise.scale+9,0\n";
    }
    return script;
}

// Returns the number in a complete graph; std::nullopt if the graph is incomplete.
std::optional<int> number_in(const std::string& text) {
    Diagnostics problems;
    const Document document = read_document(text, "graph.json", problems);
    const Node* node = document.find("softer");
    const Input* input = node ? node->find("amount") : nullptr;
    if (problems.has_errors() || !document.lost.empty() || !node) return std::nullopt;
    return input ? static_cast<int>(input->value.as_number()) : 1;  // 1 is the default
}

int last_number(const std::string& said, int otherwise) {
    for (const std::string_view line : split(said, '\n'))
        if (!line.empty() && std::isdigit(static_cast<unsigned char>(line[0])))
            otherwise = std::atoi(std::string(line).c_str());
    return otherwise;
}

// Lets the editor run: less than 2 s from its start, less than 120 ms from a save, or less than 2.5
// s from its first output.
void let_work(RunningEditor& victim, int round, std::mt19937& random) {
    const auto any = [&](unsigned most) {
        std::this_thread::sleep_for(std::chrono::microseconds(random() % (most * 1000)));
    };
    const auto patience = Clock::now() + std::chrono::seconds(60);
    if (round % 8 == 2) return any(2000);
    victim.listen(patience, round % 2 ? "saving" : "\n");
    any(round % 2 ? 120 : 2500);
}

struct Toll {
    int reached = 10;  // number in the file or in a recovery file
    int recovered = 0, stray = 0, edits = 0;
};

class Killed : public Headless {
protected:
    // Runs and kills the editor once, recovers its edits and checks the files.
    void round(const VirtualScreen& screen, int number, std::mt19937& random) {
        const auto script = home.write("script.txt", counting_script(tally.reached + 1));
        RunningEditor victim(screen, {file.string(), "--size", "1280", "720", "--script",
                                      script.string(), "--state", home.path().string()});
        let_work(victim, number, random);
        const int said = last_number(victim.kill(), tally.reached);
        const auto on_disk = number_in(text_of(file));
        ASSERT_TRUE(on_disk) << "half written:\n" << text_of(file);
        look_for_recoverable(state);
        ASSERT_LE(state.keeping.recoverable.size(), 1U);
        int now = *on_disk;
        if (!state.keeping.recoverable.empty()) {
            ++tally.recovered;
            recover(state, state.keeping.recoverable[0]);
            now = number_in(write_document(state.document())).value_or(-1);
            ASSERT_TRUE(save_file(state)) << state.status;
            finish(state);
        }
        ASSERT_GE(now, said) << "an edit is lost";
        ASSERT_LE(now, said + 1) << "nobody has typed that";
        tally.edits += now - tally.reached;
        tally.reached = now;
        for (const auto& entry : fs::directory_iterator(folder.path()))
            tally.stray += entry.path() != file && fs::remove(entry.path());
    }
    Toll tally;
};

TEST_F(Killed, AnEditorLosesNoCommittedEdit) {
    const VirtualScreen screen;
    if (!screen.is_there()) GTEST_SKIP() << "there is no Xvfb here";
    std::string graph = small_graph;
    graph.replace(graph.find("0.6"), 3, std::to_string(tally.reached));
    file = folder.write("graph.json", graph);
    std::mt19937 random(static_cast<unsigned>(kills()));
    for (int i = 0; i < kills() && !HasFatalFailure(); ++i) {
        SCOPED_TRACE("round " + std::to_string(i));
        round(screen, i, random);
    }
    std::printf("%d kills, %d edits, %d recoveries, %d temporary files left\n", kills(),
                tally.edits, tally.recovered, tally.stray);
    EXPECT_GT(tally.edits, 0);
    EXPECT_GT(tally.recovered, 0);
}

}  // namespace
}  // namespace wrinkle::editor
