#include "headless.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "editor/model/document/files.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"
#include "editor/view/refresh.h"
#include "graph/read.h"
#include "nodes/all.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;

const char* const small_graph = R"({
  "wrinkle": 1,
  "name": "Small",
  "nodes": {
    "noise": { "type": "gradient_noise", "in": { "scale": 3.0 } },
    "softer": { "type": "gradient_scale", "in": { "gradient": { "from": "noise.height" }, "amount": 0.6 } },
    "normal": { "type": "resolve", "in": { "gradient": { "from": "softer.gradient" } } },
    "number": { "type": "add" }
  },
  "outputs": {
    "normal": { "from": "normal.normal" }
  },
  "layout": {
    "noise": [0, 0],
    "softer": [272, 0],
    "normal": [512, 0],
    "number": [272, 176]
  }
}
)";

Document parsed(const std::string& text) {
    Diagnostics problems;
    Document document = read_document(text, "graph.json", problems);
    EXPECT_FALSE(problems.has_errors()) << to_text(problems);
    return document;
}

namespace {

Registry make_registry() {
    Registry registry;
    Diagnostics problems;
    EXPECT_TRUE(registry.add_plugin(built_in_nodes(), Registry::built_in, problems));
    return registry;
}

// One context for all tests, as baking fonts is slow.
Fonts& context() {
    static Fonts fonts = [] {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.MouseDoubleClickTime = 0.06F;                            // seconds: three frames
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // as in the window's backend
        map_keys(io);
        theme::use(Theme::dark);
        Fonts loaded;
        loaded.load();
        return loaded;
    }();
    return fonts;
}

}  // namespace

const Registry& built_in_registry() {
    static const Registry registry = make_registry();
    return registry;
}

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "wrinkle-editor-XXXXXX").string();
    path_ = mkdtemp(name.data());
}

TemporaryFolder::~TemporaryFolder() {
    fs::remove_all(path_);
}

fs::path TemporaryFolder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
}

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

std::string program_output(const std::string& arguments) {
    const std::string command = std::string(WRINKLE_PROGRAM) + " " + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    std::string text;
    char bytes[4096];
    for (size_t n; pipe && (n = fread(bytes, 1, sizeof bytes, pipe)) > 0;)
        text.append(bytes, n);
    if (pipe) pclose(pipe);
    return text;
}

void expect_golden(const std::string& name, const std::string& text) {
    const fs::path file = fs::path(WRINKLE_SOURCE_DIR) / "tests/editor/golden" / name;
    if (std::getenv("WRINKLE_UPDATE_GOLDEN")) std::ofstream(file, std::ios::binary) << text;
    EXPECT_EQ(text, text_of(file)) << file;
}

Headless::Headless() {
    state.fonts = context();
    state.registry = &built_in_registry();
    state.keeping.folders = folders_below(home.path());
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {1600, 900};
    io.DeltaTime = 1.0F / 60;
    io.MousePos = {-1, -1};
    for (ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        window->Scroll = {0, 0};    // left by a previous test
    for (int i = 0; i < 30; ++i) {  // avoids a double click with the last test
        ImGui::NewFrame();
        ImGui::EndFrame();
    }
}

Headless::~Headless() {
    theme::use(Theme::dark);
    ImGui::GetIO().DisplayFramebufferScale = {1, 1};
    if (state.fonts.generation() != context().generation()) context().load();
}

std::string Headless::texture(const std::string& name) const {
    const fs::path textures = folder.path() / "textures";
    fs::create_directories(textures);
    fs::copy_file(fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures" / name, textures / name);
    return (textures / name).string();
}

void Headless::open(const std::string& graph) {
    file = folder.write("graph.json", graph);
    open_file(state, file);
    frame();
    frame();
}

void Headless::frame() {
    ImGuiIO& io = ImGui::GetIO();
    apply_look(state.look, state.fonts);
    if (const float scale = state.look.scale; scale != io.DisplayFramebufferScale.x) {
        io.DisplaySize = {1600 / scale, 900 / scale};
        io.DisplayFramebufferScale = {scale, scale};
    }
    queue.apply(io, typing_waits(state));
    state.dropped.arrived = queue.take_drops();
    ImGui::NewFrame();
    draw_ui(state);
    ImGui::Render();
}

void Headless::play(const std::string& text) {
    using Clock = std::chrono::steady_clock;
    const auto patience = Clock::now() + std::chrono::minutes(5);
    Script script(text);
    while (Clock::now() < patience) {
        frame();
        // Leaves the CPU to the worker threads that the script waits for.
        if (!is_settled(state)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        switch (script.step(state, queue, {})) {
            case Script::Progress::done:
                return;
            case Script::Progress::failed:
                FAIL() << script.why();
            case Script::Progress::running:
                break;
        }
    }
    FAIL() << "the script does not end";
}

}  // namespace wrinkle::editor
