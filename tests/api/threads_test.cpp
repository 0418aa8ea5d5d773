// Tests of concurrent use of one library and one graph, and of process-wide settings (locale).
#include <array>
#include <atomic>
#include <clocale>
#include <locale>
#include <thread>

#include "api/support.h"

namespace wrinkle::test {
namespace {

using namespace api;

const std::string sample = WRINKLE_SOURCE_DIR "/graphs/everything.json";

// All results of a graph as one string.
std::string everything(const Graph& graph) {
    std::string all = to_text(graph.check());
    for (const char* target : {"glsl330", "hlsl"}) {
        CompileOptions options;
        options.target = target;
        const Shader shader = graph.compile(options);
        all += shader.source + shader.vertex + shader.fragment + shader.reflection;
    }
    for (const InputFile& file : graph.inputs())
        all += file.path;
    return all;
}

Points some_points() {
    Points points;
    points.count = 100;
    for (size_t i = 0; i < points.count; ++i) {
        const double x = static_cast<double>(i) / 100;
        const auto add = [&](const char* name, std::initializer_list<double> numbers) {
            points.values[name].insert(points.values[name].end(), numbers);
        };
        for (const std::string change : {"", "dx.", "dy."}) {
            const double scale = change.empty() ? 1 : change == "dx." ? 0.001 : -0.001;
            add((change + "position").c_str(), {x * scale, 0.3 * scale, scale});
            add((change + "normal").c_str(), {0.1 * scale, x * scale, scale});
            for (const char* uv : {"uv0", "uv1", "uv2", "uv3"})
                add((change + uv).c_str(), {x * scale, (1 - x) * scale});
            add((change + "color0").c_str(), {x, x, x, 1});
            add((change + "view").c_str(), {0, 0, scale});
            add((change + "tangent").c_str(), {scale, 0, 0, 1});
        }
    }
    return points;
}

std::vector<double> numbers(const Graph& graph, const Points& points) {
    std::vector<double> all;
    const Evaluated evaluated = graph.evaluate(points);
    EXPECT_TRUE(evaluated.ok) << to_text(evaluated.problems);
    for (const Column& column : evaluated.outputs)
        all.insert(all.end(), column.values.begin(), column.values.end());
    return all;
}

TEST(Threads, OneGraphForAll) {
    const Points points = some_points();
    const Graph alone = library().load(sample);
    const std::string wanted = everything(alone);
    const std::vector<double> wanted_numbers = numbers(alone, points);
    ASSERT_FALSE(wanted_numbers.empty());
    const Graph shared = library().load(sample);
    std::atomic<int> ready{0}, same{0};
    std::vector<std::thread> threads;
    constexpr int count = 8;
    for (int i = 0; i < count; ++i)
        threads.emplace_back([&, i] {
            for (++ready; ready < count;) {
            }
            const Graph copy = i % 2 ? shared : library().load(sample);
            const bool first = i % 3 == 0;  // some threads compile first, some evaluate first
            const bool text = first && everything(copy) == wanted;
            const bool computed = numbers(copy, points) == wanted_numbers;
            if ((text || everything(copy) == wanted) && computed) ++same;
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(same, count);
}

TEST(Threads, LibrariesSideBySide) {
    const std::string wanted = everything(library().load(sample));
    std::array<std::thread, 4> threads;
    std::atomic<size_t> same{0};
    for (std::thread& thread : threads)
        thread = std::thread([&] {
            const Library own({{WRINKLE_RIPPLES}, false});
            if (own.problems().empty() && everything(own.load(sample)) == wanted) ++same;
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(same, threads.size());
}

struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

// The host program may set any locale, in C++ and in C.
TEST(Locale, ChangesNothing) {
    const Graph graph = library().load(sample);
    const std::string wanted = everything(graph);
    const TemporaryFolder folder;
    const std::string made = folder.path() / "de_DE.UTF-8";
    const bool german =
        std::system(("localedef -i de_DE -f UTF-8 " + made + " >/dev/null 2>&1").c_str()) == 0;
    setenv("LOCPATH", folder.path().c_str(), 1);
    const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
    const bool set = german && std::setlocale(LC_ALL, "de_DE.UTF-8");
    const std::string there = everything(library().load(sample));
    std::locale::global(before);
    std::setlocale(LC_ALL, "C");
    unsetenv("LOCPATH");
    EXPECT_EQ(there, wanted);
    if (!set) GTEST_SKIP() << "no German locale can be made (Debian package locales)";
}

}  // namespace
}  // namespace wrinkle::test
