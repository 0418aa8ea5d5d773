// Runs a fixed number of damaged samples for each reader: generated samples, and those in corpus/
// (inputs by which libFuzzer reached all the code that it did). WRINKLE_FUZZ=N runs N times as
// many. The current input is in fuzz_NAME.input in the build folder; after a crash, that file has
// the input that caused it.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "fuzz/calls_fuzz.h"
#include "fuzz/damage.h"
#include "fuzz/fuzz.h"
#include "fuzz/samples.h"
#include "support/files.h"

namespace wrinkle::fuzz {
namespace {
namespace fs = std::filesystem;

uint32_t times() {
    const char* text = std::getenv("WRINKLE_FUZZ");
    uint32_t value = 1;
    if (text) std::from_chars(text, text + std::char_traits<char>::length(text), value);
    return value;
}

// Sorted by name, so that a number gives the same damage on every machine.
std::vector<fs::path> corpus(const std::string& name) {
    std::vector<fs::path> files;
    for (const auto& entry :
         fs::directory_iterator(WRINKLE_SOURCE_DIR "/tests/fuzz/corpus/" + name))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

struct Reader {
    const char* name;
    std::string (*play)(std::string_view);
    std::vector<std::string> samples;
    uint32_t inputs;
};

// Writes the current input to a file that survives a crash. The file remains open, because opening
// is the slow part.
class AtWork {
public:
    explicit AtWork(const std::string& name)
        : path_(WRINKLE_BINARY_DIR "/fuzz_" + name + ".input"),
          file_(open(path_.c_str(), O_RDWR | O_CREAT | O_TRUNC, 0600)) {}
    ~AtWork() { close(file_); }
    AtWork(const AtWork&) = delete;
    AtWork& operator=(const AtWork&) = delete;

    bool keep(const std::string& bytes) const {
        return pwrite(file_, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()) &&
               ftruncate(file_, static_cast<off_t>(bytes.size())) == 0;
    }
    const std::string& path() const { return path_; }

private:
    std::string path_;
    int file_;
};

void play(Reader reader) {
    for (const std::string& sample : reader.samples)
        EXPECT_EQ(reader.play(sample), "") << "an undamaged sample";
    for (const fs::path& file : corpus(reader.name)) {
        reader.samples.push_back(test::bytes_of(file));
        EXPECT_EQ(reader.play(reader.samples.back()), "") << file;
    }
    const AtWork work(reader.name);
    const uint32_t count = reader.inputs * times();
    for (uint32_t number = 0; number < count; ++number) {
        const std::string bytes = damaged(reader.samples, number);
        const std::string input = number % 2 ? with_checksums(bytes) : bytes;
        ASSERT_TRUE(work.keep(input)) << work.path();
        ASSERT_EQ(reader.play(input), "") << "input " << number << ", kept in " << work.path();
    }
    fs::remove(work.path());
}

TEST(Fuzz, Graphs) {
    play({"graph", graph, graph_samples(), 2000});
}
TEST(Fuzz, Meshes) {
    play({"mesh", mesh, mesh_samples(), 20000});
}
TEST(Fuzz, Images) {
    play({"image", image, image_samples(), 1000});
}
TEST(Fuzz, Descriptors) {
    play({"descriptor", descriptor, descriptor_samples(), 20000});
}
TEST(Fuzz, Listings) {
    play({"listing", listing, listing_samples(), 20000});
}
TEST(Fuzz, RecordedCalls) {
    play({"calls", calls, right_calls(), 2000});
}
TEST(Fuzz, PartsOfBakes) {
    play({"bake_part", bake_part, bake_part_samples(), 20000});
}

// Damage is deterministic and changes most samples.
TEST(Fuzz, DamageIsDoneAndRepeats) {
    const std::vector<std::string> samples = mesh_samples();
    size_t refused = 0;
    for (uint32_t number = 0; number < 100; ++number) {
        EXPECT_EQ(damaged(samples, number), damaged(samples, number));
        const std::string bytes = damaged(samples, number);
        refused += std::count(samples.begin(), samples.end(), bytes) == 0 ? 1 : 0;
    }
    EXPECT_GT(refused, 90u);
}

}  // namespace
}  // namespace wrinkle::fuzz
