// Tests of chains of thirty nodes that alternate between two node types: each graph compiles or is
// refused with a diagnostic that names a node, within limits on time and memory.
//
// WRINKLE_ALL_CHAINS=1 runs every ordered pair within the usual limits, which takes half an hour on
// one core. Otherwise each node type is paired with itself, and the first type of each kind with
// the first of each other kind, within limits 40 times lower. A kind has one family and one list of
// output types, from a field or not.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "certify/subject.h"
#include "chains/chain.h"
#include "emit/emit.h"
#include "graph/read.h"
#include "graph/subgraph.h"
#include "lower/material.h"

namespace wrinkle::test {
namespace {

constexpr int length = 30;
#if defined(__SANITIZE_ADDRESS__)
constexpr auto hang = std::chrono::seconds(60);  // about ten times the usual time
constexpr size_t stride = 3;                     // every third chain, for the same reason
#else
constexpr auto hang = std::chrono::seconds(5);
constexpr size_t stride = 1;
#endif

bool all_chains() {
    const char* wanted = std::getenv("WRINKLE_ALL_CHAINS");
    return wanted && *wanted;
}

// The usual limit, divided by 40 unless all chains run.
uint64_t share_of(Limit limit) {
    return limit_of(limit) / (all_chains() ? 1 : 40);
}

struct Case {
    Link there, back;
};

std::string kind_of(const NodeType& type) {
    std::set<std::string> parts{type.family};
    for (const Port& port : type.ports) {
        if (port.kind == Port::Kind::field) parts.insert("field");
        if (port.kind == Port::Kind::output)
            parts.insert(std::to_string(static_cast<int>(port.type)));
    }
    std::string text;
    for (const std::string& part : parts)
        text += part + " ";
    return text;
}

std::vector<Case> cases(bool all, Wiring wiring) {
    std::set<const NodeType*> first;
    std::set<std::string> kinds;
    for (const NodeType& type : registry().list())
        if (kinds.insert(kind_of(type)).second) first.insert(&type);
    std::vector<Case> found;
    size_t pairs = 0;
    for (const NodeType& a : registry().list())
        for (const NodeType& b : registry().list()) {
            if (!all && &a != &b && !(first.contains(&a) && first.contains(&b))) continue;
            if (!all && pairs++ % stride != 0) continue;
            Case each{link(a, b, wiring), link(b, a, wiring)};
            if (!each.there.inputs.empty() && !each.back.inputs.empty())
                found.push_back(std::move(each));
        }
    return found;
}

enum class Outcome : uint8_t { text, refused, illegal };

struct Ended {
    Outcome outcome = Outcome::text;
    std::string wrong;  // "" if no error was found
    size_t bytes = 0;
    double seconds = 0;
};

Ended run(const Case& each, const std::filesystem::path& folder) {
    Ended ended;
    const auto start = std::chrono::steady_clock::now();
    const std::string text = chain(each.there, each.back, length);
    Diagnostics problems;
    const Project project = load_project(
        read_document(text, (folder / "chain.json").string(), problems), folder, {}, problems);
    MaterialOptions options;
    options.lower.max_values = share_of(Limit::graph_values);
    EmitOptions emit_options;
    emit_options.max_bytes = share_of(Limit::text_bytes);
    const Compiled compiled = compile_material(project, registry(), options, problems);
    if (compiled.ok) {
        const Shader shader = emit(compiled.module, emit_options);
        report_problems(shader.problems, compiled.module, project, compiled.places, problems);
        ended.bytes = shader.source.size();
    }
    const auto took = std::chrono::steady_clock::now() - start;
    ended.seconds = std::chrono::duration<double>(took).count();
    const auto& list = problems.list();
    const auto is_size = [](const Diagnostic& d) {
        return d.message.starts_with("the graph becomes more than ");
    };
    if (took > hang) ended.wrong += "took " + std::to_string(ended.seconds) + " s; ";
    if (ended.bytes > emit_options.max_bytes)
        ended.wrong += "text of " + std::to_string(ended.bytes) + "; ";
    if (!problems.has_errors()) return ended;
    const bool size = std::any_of(list.begin(), list.end(), is_size);
    ended.outcome = size ? Outcome::refused : Outcome::illegal;
    if (std::none_of(list.begin(), list.end(), [](const auto& d) { return !d.node.empty(); }))
        ended.wrong += "names no node: " + to_text(problems);
    return ended;
}

// Failures, refusals, counts by outcome, and the slowest chain.
struct Survey {
    std::array<size_t, 3> count{};
    double slowest = 0;
    std::string slowest_name;
    std::vector<std::string> wrong, refused;
};

Survey survey(const std::vector<Case>& all, const std::filesystem::path& folder) {
    Survey result;
    std::mutex mutex;
    std::atomic<size_t> next{0};
    const auto work = [&] {
        for (size_t i = next++; i < all.size(); i = next++) {
            const Ended ended = run(all[i], folder);
            const std::lock_guard lock(mutex);
            const std::string name = all[i].there.from->id + " -> " + all[i].there.to->id;
            ++result.count[static_cast<size_t>(ended.outcome)];
            if (ended.seconds > result.slowest) {
                result.slowest = ended.seconds;
                result.slowest_name = name;
            }
            if (ended.outcome == Outcome::refused) result.refused.push_back(name);
            if (!ended.wrong.empty()) result.wrong.push_back(name + ": " + ended.wrong);
        }
    };
    const unsigned threads = std::clamp(std::thread::hardware_concurrency(), 1U, 2U);
    std::vector<std::jthread> helpers;
    for (unsigned i = 1; i < threads; ++i)
        helpers.emplace_back(work);
    work();
    helpers.clear();
    return result;
}

class Chains : public testing::TestWithParam<Wiring> {};

TEST_P(Chains, OfAnyTwoNodeTypesBecomeATextOrAreRefused) {
    std::string why;
    const auto folder = certify::make_image_folder(why);
    ASSERT_TRUE(folder) << why;
    const std::vector<Case> all = cases(all_chains(), GetParam());
    ASSERT_GT(all.size(), 300U);
    const Survey found = survey(all, *folder);
    for (const std::string& each : found.wrong)
        ADD_FAILURE() << each;
    const auto [text, refused, illegal] = found.count;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::printf("%zu chains: %zu texts, %zu refused for size, %zu for another reason\n", all.size(),
                text, refused, illegal);
    std::printf("the slowest took %.2f s (%s); %ld MB\n", found.slowest, found.slowest_name.c_str(),
                usage.ru_maxrss / 1024);
    EXPECT_GT(refused, 5U);
    EXPECT_LT(illegal, all.size() / 4);
    EXPECT_GT(text, all.size() / 2);
    if (std::getenv("WRINKLE_CHAINS_LIST"))
        for (const std::string& each : found.refused)
            std::printf("refused %s\n", each.c_str());
#if !defined(__SANITIZE_ADDRESS__)
    EXPECT_LT(usage.ru_maxrss, 1024 * 1024) << "KB";
#endif
}

INSTANTIATE_TEST_SUITE_P(Wired, Chains, testing::Values(Wiring::one_input, Wiring::all_inputs),
                         [](const auto& wired) {
                             return wired.param == Wiring::one_input ? "ThroughOneInput"
                                                                     : "ThroughAllInputs";
                         });

}  // namespace
}  // namespace wrinkle::test
