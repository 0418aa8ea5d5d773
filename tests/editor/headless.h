// The editor without a window and without GL: the real draw_ui() with input from the real queue.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "editor/app/script.h"
#include "editor/view/input/input_queue.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

const Registry& built_in_registry();

// A graph that reads no files: noise -> scaled -> normal, and an unconnected number.
extern const char* const small_graph;
// Parses a document; any problem fails the test.
Document parsed(const std::string& text);

// A new temporary folder; the destructor removes it.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    std::filesystem::path write(const std::string& name, const std::string& text) const;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::string text_of(const std::filesystem::path& file);

// Returns the standard output and standard error of `wrinkle ARGUMENTS`.
std::string program_output(const std::string& arguments);
// Compares with tests/editor/golden/NAME; WRINKLE_UPDATE_GOLDEN=1 writes it.
void expect_golden(const std::string& name, const std::string& text);

class Headless : public ::testing::Test {
protected:
    Headless();
    ~Headless() override;
    void open(const std::string& graph);
    // Copies an image of graphs/textures into the folder's textures/.
    std::string texture(const std::string& name) const;
    void frame();
    // Plays a script to its end; a failed step fails the test.
    void play(const std::string& script);

    TemporaryFolder folder, home;
    std::filesystem::path file;
    State state;
    InputQueue queue;
};

}  // namespace wrinkle::editor
