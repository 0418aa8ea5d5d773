#include "certify/subject.h"

#include <unistd.h>

#include <cstdlib>
#include <random>

#include "base/file.h"

namespace wrinkle::certify {
namespace fs = std::filesystem;
namespace {

constexpr const char* image_names[] = {"a.exr", "b.exr"};
constexpr int max_attempts = 50;

Image random_image(uint32_t width, uint32_t height, unsigned seed) {
    std::mt19937 random(seed);
    Image image = make_image(width, height, 4);
    for (float& value : image.data)
        value = 0.1F + 0.8F * static_cast<float>(random() >> 8) / 16777216.0F;
    return image;
}

}  // namespace

std::shared_ptr<const fs::path> make_image_folder(std::string& why) {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "wrinkle-certify-XXXXXX").string();
    if (error || !mkdtemp(name.data())) {
        why = name + ": " + (error ? error.message() : std::generic_category().message(errno));
        return {};
    }
    const auto remove = [](const fs::path* path) {
        std::error_code ignored;
        fs::remove_all(*path, ignored);
        delete path;
    };
    const std::shared_ptr<const fs::path> folder(new fs::path(real_path(name)), remove);
    for (const char* image : image_names)
        if (!write_file(*folder / image, "never read", why)) return {};
    return folder;
}

const MipChain& test_image(const std::string& file) {
    static const MipChain a = build_mips(random_image(16, 8, 1));
    static const MipChain b = build_mips(random_image(7, 5, 2));
    return fs::path(file).filename() == image_names[0] ? a : b;
}

Compiled compile(const Project& project, const CertifyContext& context, Options options,
                 Diagnostics& diagnostics) {
    return compile_material(
        project, context.registry,
        {.uniform_parameters = options.uniform, .given_differentials = options.given}, diagnostics);
}

Project project_of(const std::string& text, const CertifyContext& context,
                   Diagnostics& diagnostics) {
    return load_project(read_document(text, "subject.json", diagnostics), context.image_folder, {},
                        diagnostics);
}

Subject compile_harness(const NodeType& type, Inputs inputs, unsigned seed,
                        const CertifyContext& context) {
    std::mt19937 random(seed);
    Subject subject;
    for (int attempt = 0; attempt < max_attempts; ++attempt) {
        subject.text = harness_graph(type, inputs, random);
        Diagnostics diagnostics;
        subject.project = project_of(subject.text, context, diagnostics);
        subject.compiled = compile(subject.project, context, {}, diagnostics);
        if (subject.compiled.ok) {
            subject.problem.clear();
            return subject;
        }
        subject.problem = diagnostics.list().empty() ? "" : diagnostics.list().front().message;
    }
    return subject;
}

void Trial::add(const char* check, const std::string& port, const std::string& message,
                std::string remedy) const {
    report.add({check, port, words(inputs) + ", " + message, std::move(remedy), subject.text});
}

void each_trial(const NodeType& type, std::initializer_list<Inputs> inputs, unsigned seed,
                const CertifyContext& context, Report& report, void (*check)(const Trial&)) {
    for (const Inputs each : inputs) {
        const Trial trial{compile_harness(type, each, seed, context), each, context, report};
        if (trial.subject.compiled.ok) check(trial);
    }
}

std::string port_of(const std::string& output) {
    return output.starts_with("out_") ? output.substr(4) : output;
}

}  // namespace wrinkle::certify
