// Benchmark of texel throughput, in one run by turns: Wrinkle's evaluator, the same job
// hand-written, and OpenGL (one process per turn: llvmpipe fixes its threads at start).
//
//   wrinkle_texel_bench [TURNS]                   default: 5
//   wrinkle_texel_bench --draw THREADS ROUNDS     OpenGL's turn: rates, a line feed, the texels
#include <stdio.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstdlib>
#include <string>

#include "bench/texels/clock.h"
#include "bench/texels/kernel.h"
#include "bench/texels/llvmpipe.h"
#include "bench/texels/ours.h"

namespace {

using namespace wrinkle;
using namespace wrinkle::bench;

constexpr uint32_t band = 16;  // rows
constexpr int rounds = 3;      // per turn

struct Contestant {
    enum class Kind { ours, kernel, opengl };
    Kind kind;
    const char* name;
    InstructionSet set;
    const Kernel* kernel = nullptr;  // the code of Kind::kernel; first and last stage of Kind::ours
    std::vector<double> wall = {}, processor = {};
    Packed texels = {};
};

using Kind = Contestant::Kind;

std::vector<Contestant> contestants() {
    std::vector<Contestant> all = {
        {Kind::opengl, "OpenGL, our GLSL", InstructionSet::baseline},
        {Kind::ours, "evaluator, baseline", InstructionSet::baseline, &avx2::kernel},
        {Kind::ours, "evaluator, avx2", InstructionSet::avx2, &avx2::kernel},
        {Kind::kernel, "by hand, avx2", InstructionSet::avx2, &avx2::kernel},
        {Kind::ours, "evaluator, avx512", InstructionSet::avx512, &avx512::kernel},
        {Kind::kernel, "by hand, avx512", InstructionSet::avx512, &avx512::kernel}};
    std::erase_if(all, [](const Contestant& each) { return !is_available(each.set); });
    return all;
}

template <class Rows>
void on_threads(int threads, Rows rows) {
    if (threads == 1) return rows(0, side);
    tbb::task_arena(threads).execute([&] {
        tbb::parallel_for(uint32_t{0}, side / band,
                          [&](uint32_t k) { rows(k * band, (k + 1) * band); });
    });
}

int draw_alone(int threads, int draws) {
    Packed texels;
    std::string why;
    const Rate rate = draw(make_material().shader, draws, threads, texels, why);
    if (texels.empty()) {
        std::fprintf(stderr, "%s\n", why.c_str());
        return 1;
    }
    std::printf("%.9g %.9g\n", rate.wall, rate.processor);
    return std::fwrite(texels.data(), 4, texels.size(), stdout) == texels.size() ? 0 : 1;
}

Rate draw_in_process(const std::string& self, int threads, Packed& texels) {
    const std::string count = std::to_string(threads);
    const std::string command = "LP_NUM_THREADS=" + count + " '" + self + "' --draw " + count +
                                " " + std::to_string(rounds);
    std::FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return {};
    Rate rate;
    texels.resize(texel_count);
    const bool whole = std::fscanf(pipe, "%lf %lf", &rate.wall, &rate.processor) == 2 &&
                       std::fgetc(pipe) == '\n' &&
                       std::fread(texels.data(), 4, texels.size(), pipe) == texels.size();
    if (pclose(pipe) != 0 || !whole) texels.clear();
    return rate;
}

void turn(Contestant& one, const Material& material, const std::string& self, int threads) {
    one.texels.resize(texel_count);
    const auto rows = [&](uint32_t first, uint32_t last) {
        if (one.kind == Kind::kernel)
            one.kernel->rows(first, last, one.texels.data());
        else
            evaluate_rows(material, one.set, *one.kernel, first, last, one.texels.data());
    };
    const Rate rate = one.kind == Kind::opengl
                          ? draw_in_process(self, threads, one.texels)
                          : measure(rounds, threads, [&] { on_threads(threads, rows); });
    one.wall.push_back(rate.wall);
    one.processor.push_back(rate.processor);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

// Formats "0.01 %, at most 1": the share of channels that differ and the largest difference.
std::string apart(const Packed& a, const Packed& b) {
    if (a.size() != b.size()) return "failed";
    size_t different = 0;
    int most = 0;
    for (size_t k = 0; k < 3 * texel_count; ++k) {
        const int x = static_cast<int>(a[k / 3] >> (8 * (k % 3)) & 0xFF);
        const int y = static_cast<int>(b[k / 3] >> (8 * (k % 3)) & 0xFF);
        different += x != y;
        most = std::max(most, std::abs(x - y));
    }
    char text[64];
    std::snprintf(text, sizeof text, "%.4f %%, at most %d",
                  100.0 * static_cast<double>(different) / (3.0 * texel_count), most);
    return text;
}

void print(const std::vector<Contestant>& all, int threads) {
    std::printf("\n%d thread%s%*s Mpix/s  to OpenGL | by processor time  to OpenGL | bytes apart\n",
                threads, threads == 1 ? " " : "s", 18, "");
    const double wall = median(all[0].wall), processor = median(all[0].processor);
    for (const Contestant& one : all)
        std::printf("%-28s %7.1f %9.2fx | %17.1f %9.2fx | %s\n", one.name, median(one.wall),
                    median(one.wall) / wall, median(one.processor),
                    median(one.processor) / processor, apart(one.texels, all[1].texels).c_str());
}

}  // namespace

int main(int argc, char** argv) {
    const std::string first = argc > 1 ? argv[1] : "5";
    if (first == "--draw" && argc == 4) return draw_alone(std::atoi(argv[2]), std::atoi(argv[3]));
    const Material material = make_material();
    if (!material.error.empty()) {
        std::fprintf(stderr, "%s\n", material.error.c_str());
        return 1;
    }
    std::printf("two RGBA8 normal maps of %u x %u to one; %zu steps, medians of %s turns\n", side,
                side, material.program.steps.size(), first.c_str());
    for (const int threads : {1, 2}) {
        std::vector<Contestant> all = contestants();
        for (int k = 0; k < std::atoi(first.c_str()); ++k)
            for (Contestant& one : all)
                turn(one, material, argv[0], threads);
        print(all, threads);
    }
}
