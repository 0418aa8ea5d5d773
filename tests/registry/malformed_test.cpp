// Tests that files which are not plugins, or broken plugins, are refused with a reason, and that
// the host continues.
#include <gtest/gtest.h>

#include <elf.h>

#include <cstring>
#include <filesystem>

#include "registry/loaded.h"
#include "registry/plugins/broken.h"
#include "support/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;
using test::load;
using test::Loaded;
using test::plugin_folder;

struct Case {
    const char* name;
    const char* expected;

    friend void PrintTo(const Case& row, std::ostream* out) { *out << row.name; }
};

#define X(name, change, expected) {#name, expected},
constexpr Case cases[] = {BROKEN(X)};
#undef X

// A valid plugin follows the broken one.
std::string refusal_of(const fs::path& file, std::chrono::milliseconds limit = probe_limit) {
    PluginOptions options;
    options.limit = limit;
    const Loaded loaded = load({file.string(), plugin_folder + "/good.so"}, options);
    EXPECT_EQ(loaded.registry.ids(), std::vector<std::string>{"small"});
    EXPECT_TRUE(loaded.diagnostics.has_errors());
    EXPECT_EQ(loaded.reports.size(), 2u);
    EXPECT_EQ(loaded.reports[0].path, file.string());
    EXPECT_EQ(loaded.reports[0].state, PluginReport::State::refused);
    EXPECT_EQ(loaded.reports[1].state, PluginReport::State::found);
    for (const Diagnostic& diagnostic : loaded.diagnostics.list())
        EXPECT_EQ(diagnostic.where.file, file.string()) << diagnostic.message;
    return loaded.reports[0].why;
}

class Malformed : public testing::TestWithParam<Case> {
protected:
    const test::TemporaryFolder folder;
};

TEST_P(Malformed, IsRefusedWithItsReason) {
    const Case& row = GetParam();
    const fs::path file = folder.path() / (std::string(row.name) + ".so");
    fs::copy_file(plugin_folder + "/broken.so", file);
    const bool hangs = std::string_view(row.expected).starts_with("it hung");
    const std::string why = refusal_of(file, std::chrono::milliseconds(hangs ? 400 : 60'000));
    EXPECT_EQ(why.substr(0, std::strlen(row.expected)), row.expected);
    EXPECT_LT(why.size(), 1200u) << "faults follow from faults: " << why;
}

INSTANTIATE_TEST_SUITE_P(Plugins, Malformed, testing::ValuesIn(cases),
                         [](const auto& row) { return std::string(row.param.name); });

// The unmodified file name does not select a variant.
TEST(MalformedPlugin, IsGoodWhenNothingIsChanged) {
    const Loaded loaded = load({plugin_folder + "/broken.so"});
    EXPECT_EQ(to_text(loaded.diagnostics), "");
    EXPECT_EQ(loaded.registry.ids(), std::vector<std::string>{"broken"});
    EXPECT_GE(std::size(cases), 100u);
}

class DamagedFile : public testing::Test {
protected:
    std::string refusal(std::string_view bytes) const {
        return refusal_of(folder.put("damaged.so", bytes));
    }
    std::string with(size_t at, const std::string& bytes) const {
        std::string damaged = whole;
        return damaged.replace(at, bytes.size(), bytes);
    }

    const test::TemporaryFolder folder;
    const std::string whole = test::bytes_of(plugin_folder + "/good.so");
};

TEST_F(DamagedFile, IsNamedByWhatItIs) {
    EXPECT_EQ(refusal(""), "it cannot be loaded: the file is empty");
    EXPECT_EQ(refusal("no shared object"), "it cannot be loaded: it is not a shared object");
    EXPECT_EQ(refusal("\x7F"), "it cannot be loaded: the file is cut short");
    EXPECT_EQ(refusal(std::string(4096, '\0')), "it cannot be loaded: it is not a shared object");
    EXPECT_EQ(refusal(with(EI_CLASS, "\x01")),
              "it cannot be loaded: it is built for 32-bit programs, or damaged");
    EXPECT_EQ(refusal(with(EI_DATA, "\x02")),
              "it cannot be loaded: it is built for another byte order, or damaged");
    const std::string machine = refusal(with(offsetof(Elf64_Ehdr, e_machine), {"\xF3\x00", 2}));
    EXPECT_EQ(machine.substr(0, 58), "it cannot be loaded: it is built for RISC-V, this program ");
    EXPECT_EQ(refusal(with(offsetof(Elf64_Ehdr, e_type), {"\x02\x00", 2})),
              "it cannot be loaded: it is not a shared object");
}

TEST_F(DamagedFile, ThatIsCutShortIsRefused) {
    for (size_t size = SELFMAG; size < whole.size(); size += whole.size() / 40 + 1)
        EXPECT_EQ(refusal(whole.substr(0, size)), "it cannot be loaded: the file is cut short")
            << size;
}

// The system's loader trusts these bytes, so it loads them in another process.
TEST_F(DamagedFile, InsideIsSurvived) {
    Elf64_Ehdr head;
    std::memcpy(&head, whole.data(), sizeof head);
    for (size_t at = head.e_phoff; at < head.e_phoff + 8 * sizeof(Elf64_Phdr); at += 29) {
        const auto file = folder.put("damaged.so", with(at, "\xA5\x5A\xFF"));
        const Loaded loaded = load({file.string(), plugin_folder + "/second.so"});
        EXPECT_NE(loaded.registry.find("smaller"), nullptr) << at;
        EXPECT_TRUE(loaded.registry.find("small") || !loaded.reports[0].why.empty()) << at;
    }
}

TEST_F(DamagedFile, OrNoneIsRefused) {
    fs::create_directory(folder.path() / "folder.so");
    fs::create_symlink("nowhere", folder.path() / "dangling.so");
    fs::create_symlink("/dev/zero", folder.path() / "endless.so");
    const Loaded loaded = load({folder.path().string()});
    ASSERT_EQ(loaded.reports.size(), 3u);
    for (const PluginReport& report : loaded.reports)
        EXPECT_TRUE(report.why.starts_with("it cannot be loaded: it ")) << report.why;
    EXPECT_EQ(loaded.reports[1].why, "it cannot be loaded: it is a device, not a file");
    EXPECT_EQ(loaded.reports[2].why, "it cannot be loaded: it is a folder, not a file");
    EXPECT_FALSE(loaded.diagnostics.has_errors());
}

TEST_F(DamagedFile, ThatNeedsWhatIsMissingSaysWhat) {
    EXPECT_EQ(refusal_of(plugin_folder + "/missing_symbol.so"),
              "it cannot be loaded: undefined symbol: nobody_has_this");
}

}  // namespace
}  // namespace wrinkle
