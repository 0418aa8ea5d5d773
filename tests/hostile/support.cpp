#include "hostile/support.h"

#include <algorithm>

#include "base/text.h"

namespace wrinkle::hostile {
namespace {

// Returns the code point and length of the character at `at`. Precondition: valid UTF-8.
std::pair<uint32_t, size_t> character_at(std::string_view text, size_t at) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[at + i]); };
    const uint32_t first = byte(0);
    if (first < 0x80) return {first, 1};
    const size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    uint32_t code = first & (0xFF >> (length + 1));
    for (size_t i = 1; i < length; ++i)
        code = code << 6 | (byte(i) & 0x3F);
    return {code, length};
}

bool is_interpreted(uint32_t code) {
    if (code < 0x20) return code != '\n' && code != '\t';
    const bool control = code >= 0x7F && code < 0xA0;
    const bool separator = code == 0x2028 || code == 0x2029;
    const bool bidirectional = code == 0x061C || code == 0x200E || code == 0x200F ||
                               (code >= 0x202A && code <= 0x202E) ||
                               (code >= 0x2066 && code <= 0x2069);
    return control || separator || bidirectional;
}

bool is_text(const fs::path& path) {
    static const std::set<std::string> extensions = {".glsl", ".vert", ".frag", ".hlsl", ".metal",
                                                     ".msl",  ".json", ".d",    ".txt"};
    return extensions.contains(path.extension());
}

bool is_in(const std::string& file, const std::set<std::string>& outputs) {
    return std::any_of(outputs.begin(), outputs.end(), [&](const std::string& output) {
        return file == output || file.starts_with(output + "/") || output.starts_with(file + "/");
    });
}

}  // namespace

std::string unsafe_character(std::string_view text) {
    if (!is_utf8(text)) return "bytes that are not UTF-8";
    for (size_t at = 0; at < text.size();) {
        const auto [code, length] = character_at(text, at);
        if (is_interpreted(code)) {
            char name[64];
            std::snprintf(name, sizeof name, "U+%04X at byte %zu", code, at);
            return name;
        }
        at += length;
    }
    return "";
}

void HostileTest::SetUp() {
    CliTest::SetUp();
    setenv("SOURCE_DATE_EPOCH", "0", 1);  // equal reports in every run
    seconds = WRINKLE_SANITIZED ? 60 : 5;
    temporary.put("outside/secret.txt", secret);
    temporary.put("outside/secret.json", "{\"wrinkle\": 1, \"name\": \"SECRET-CONTENT\"}");
}

std::vector<std::string> HostileTest::all_files() const {
    std::vector<std::string> names;
    const auto options = fs::directory_options::skip_permission_denied;
    for (const auto& entry : fs::recursive_directory_iterator(folder.parent_path(), options)) {
        // Lexically: fs::relative() reads the file system for every component.
        const std::string name = entry.path().lexically_relative(folder.parent_path());
        if (name != "in" && name != "out" && name != "err" && !name.starts_with("cache"))
            names.push_back(name);
    }
    return names;
}

void HostileTest::baseline() {
    const auto files = all_files();
    project_ = {files.begin(), files.end()};
}

void HostileTest::clean() {
    for (const std::string& name : all_files())
        if (!project_.contains(name)) fs::remove_all(folder.parent_path() / name);
}

std::string HostileTest::violation(const Ran& ran, const std::set<std::string>& outputs) {
    if (ran.code == 128 + 14) return "does not end";
    if (ran.code < 0 || ran.code > 3) return "ends with code " + std::to_string(ran.code);
    if (ran.code != 0 && ran.err.empty() && ran.out.empty()) return "fails without a message";
    for (const std::string& name : all_files()) {
        if (project_.contains(name)) continue;
        const std::string inside = name.starts_with("work/") ? name.substr(5) : name;
        if (!is_in(inside, outputs)) return "creates '" + name + "'";
        const fs::path path = folder.parent_path() / name;
        if (!fs::is_regular_file(path)) continue;
        const std::string bytes = test::bytes_of(path);
        if (bytes.find(secret) != bytes.npos) return "copies the secret to " + name;
        const std::string unsafe = is_text(path) ? unsafe_character(bytes) : "";
        if (!unsafe.empty()) return "writes " + unsafe + " of " + name;
    }
    const std::string unsafe = unsafe_character(ran.err + ran.out);
    if (!unsafe.empty()) return "prints " + unsafe;
    const bool shown = (ran.err + ran.out).find(secret) != std::string::npos;
    return shown ? "shows the secret" : "";
}

Ran HostileTest::attack(const std::string& label, const std::vector<std::string>& args,
                        const std::set<std::string>& outputs, const std::string& input) {
    ++cases;
    Ran ran = run(args, input);
    const std::string wrong = violation(ran, outputs);
    if (!wrong.empty())
        ADD_FAILURE() << label << ": wrinkle " << args[0] << " " << wrong << "\n"
                      << ran.err.substr(0, 2000);
    return ran;
}

}  // namespace wrinkle::hostile
