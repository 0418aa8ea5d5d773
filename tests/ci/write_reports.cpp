// Writes results with hostile texts in every format into a folder, for readers_test.py.
#include <filesystem>
#include <fstream>

#include "report/ci_formats.h"
#include "report/hostile_results.h"
#include "report/results_json.h"

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    using namespace wrinkle;
    const std::filesystem::path folder = argv[1];
    const report::Results results = test::hostile_results();
    report::CiOptions options;
    options.attachment = [](const std::string& image) { return "report/" + image; };
    std::ofstream(folder / "junit.xml") << report::junit(results, options);
    std::ofstream(folder / "results.tap") << report::tap(results);
    std::ofstream(folder / "results.json") << report::to_json(results);
    return 0;
}
