#include "certify/subject.h"

#include <unistd.h>

#include <cstdlib>
#include <random>

#include "base/file.h"

namespace wrinkle::certify {
namespace fs = std::filesystem;
namespace {

constexpr const char* picture_names[] = {"a.exr", "b.exr"};
constexpr int max_attempts = 50;

Image random_image(uint32_t width, uint32_t height, unsigned seed) {
    std::mt19937 random(seed);
    Image image = make_image(width, height, 4);
    for (float& value : image.data)
        value = 0.1F + 0.8F * static_cast<float>(random() >> 8) / 16777216.0F;
    return image;
}

}  // namespace

std::optional<PictureFolder> PictureFolder::make(std::string& why) {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "wrinkle-certify-XXXXXX").string();
    if (error || !mkdtemp(name.data())) {
        why = name + ": " + (error ? error.message() : std::generic_category().message(errno));
        return {};
    }
    PictureFolder folder;
    folder.path_ = fs::canonical(name, error);
    if (error) folder.path_ = name;
    for (const char* picture : picture_names)
        if (!write_file(folder.path_ / picture, "never read", why)) return {};
    return folder;
}

PictureFolder::PictureFolder(PictureFolder&& other) noexcept : path_(std::move(other.path_)) {
    other.path_.clear();
}

PictureFolder::~PictureFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
}

const MipChain& test_image(const std::string& file) {
    static const MipChain a = build_mips(random_image(16, 8, 1));
    static const MipChain b = build_mips(random_image(7, 5, 2));
    return fs::path(file).filename() == picture_names[0] ? a : b;
}

Compiled compile(const Project& project, const CertifyContext& context, Options options,
                 Diagnostics& diagnostics) {
    MaterialOptions material;
    material.uniform_parameters = options.uniform;
    material.given_differentials = options.given;
    return compile_material(project, context.registry, material, diagnostics);
}

Project project_of(const std::string& text, const CertifyContext& context,
                   Diagnostics& diagnostics) {
    return load_project(read_document(text, "subject.json", diagnostics), context.pictures, {},
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

std::string port_of(const std::string& output) {
    return output.starts_with("out_") ? output.substr(4) : output;
}

}  // namespace wrinkle::certify
