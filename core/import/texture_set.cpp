#include "import/texture_set.h"

#include <algorithm>

#include "base/case.h"
#include "base/mapped.h"
#include "base/text.h"

namespace wrinkle::textures {
namespace fs = std::filesystem;
namespace {

constexpr const char* example_names =
    "names end like brick_color.png, brick_normal_gl.png, brick_roughness.png, brick_orm.png";

Diagnostic problem_of(Severity severity, const fs::path& file, std::string message,
                      std::string expected = {}) {
    return file_problem(severity, RuleId::texture_set, file.string(), std::move(message),
                        std::move(expected));
}

// Formats that cannot be read are listed too: their error names the file.
bool has_image_extension(const fs::path& file) {
    static constexpr std::string_view known[] = {
        ".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".hdr",  ".pfm", ".ppm", ".pgm",
        ".pnm", ".tga", ".bmp",  ".dds", ".ktx",  ".psd", ".webp", ".gif", ".ktx2"};
    return std::ranges::find(known, lower_case(file.extension().string())) != std::end(known);
}

std::string listed_names(const std::vector<fs::path>& files) {
    constexpr size_t most = 5;
    std::vector<std::string> names;
    for (size_t i = 0; i < std::min(files.size(), most); ++i)
        names.push_back(files[i].filename().string());
    std::string text = joined(names, ", ");
    return files.size() > most ? text + " and " + std::to_string(files.size() - most) + " more"
                               : text;
}

// Returns the images of a folder, sorted by name; std::nullopt after an error.
std::optional<std::vector<fs::path>> images_of_folder(const fs::path& folder,
                                                      Diagnostics& diagnostics) {
    const auto failed = [&](std::string message, std::string expected = {}) {
        diagnostics.add(
            problem_of(Severity::error, folder, std::move(message), std::move(expected)));
        return std::nullopt;
    };
    std::vector<fs::path> images;
    fs::path textures;  // a sub-folder that may be the one that was meant
    std::error_code error;
    size_t count = 0;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (++count > max_folder_files)
            return failed("holds more than " + std::to_string(max_folder_files) + " files",
                          "name the images of the material instead of the folder");
        std::error_code ignored;
        if (entry->is_directory(ignored) && (textures.empty() || entry->path() < textures))
            textures = entry->path();
        if (has_image_extension(entry->path()) && entry->is_regular_file(ignored))
            images.push_back(entry->path());
    }
    if (error) return failed("cannot be read: " + error.message());
    if (images.empty())
        return failed("holds no image", textures.empty() ? std::string(example_names)
                                                         : "name the folder with the images, such "
                                                           "as " +
                                                               textures.string());
    std::ranges::sort(images);
    return images;
}

std::optional<std::vector<fs::path>> images_of(const std::vector<fs::path>& inputs,
                                               Diagnostics& diagnostics) {
    std::error_code error;
    if (inputs.size() == 1 && fs::is_directory(inputs[0], error))
        return images_of_folder(inputs[0], diagnostics);
    std::vector<fs::path> images = inputs;
    std::ranges::sort(images);
    images.erase(std::unique(images.begin(), images.end()), images.end());
    if (images.size() > max_folder_files) {
        diagnostics.error(RuleId::over_limit,
                          "more than " + std::to_string(max_folder_files) + " images are named");
        return {};
    }
    for (const fs::path& image : images)
        if (!fs::exists(image, error))
            diagnostics.add(problem_of(Severity::error, image, "does not exist",
                                       "a folder with textures, or images"));
        else if (fs::is_directory(image, error))
            diagnostics.add(problem_of(Severity::error, image, "is one folder of several inputs",
                                       "one folder, or images"));
    return diagnostics.has_errors() ? std::nullopt : std::optional(images);
}

struct Candidate {
    fs::path file;
    const TextureRole* role = nullptr;
    bool is_used = false;
    fs::path better;  // the file that is used instead, if it is not used
};

// The candidates that hold a channel, the best one first.
std::vector<Candidate*> holders(std::vector<Candidate>& candidates, Channel channel) {
    std::vector<Candidate*> found;
    for (Candidate& each : candidates)
        if (each.role && std::ranges::find(each.role->sources, channel, &ChannelSource::channel) !=
                             each.role->sources.end())
            found.push_back(&each);
    std::ranges::stable_sort(found, {}, [](const Candidate* each) { return each->role->rank; });
    return found;
}

void assign(TextureSet& set, std::vector<Candidate>& candidates, Channel channel,
            Diagnostics& diagnostics) {
    const std::vector<Candidate*> found = holders(candidates, channel);
    if (found.empty()) return;
    Candidate& best = *found.front();
    if (found.size() > 1 && found[1]->role->rank == best.role->rank)
        diagnostics.add(problem_of(Severity::error, found[1]->file,
                                   "is a second file for the channel " +
                                       std::string(name_of(channel)) + " beside " +
                                       best.file.filename().string(),
                                   "name the images that are to be used instead of the folder"));
    best.is_used = true;
    if (!is_utf8(best.file.filename().string()))
        diagnostics.add(problem_of(Severity::error, best.file, "is not named in UTF-8",
                                   "another name: a graph cannot spell this one"));
    for (size_t i = 1; i < found.size(); ++i)
        found[i]->better = best.file;
    const auto source = std::ranges::find(best.role->sources, channel, &ChannelSource::channel);
    set.channels[static_cast<size_t>(channel)] = Texture{best.file, *source, best.role, {}};
}

void report_unused(const std::vector<Candidate>& candidates, Diagnostics& diagnostics) {
    std::vector<fs::path> unknown;
    for (const Candidate& each : candidates) {
        if (each.is_used) continue;
        if (!each.role)
            unknown.push_back(each.file);
        else if (each.role->sources.empty())
            diagnostics.add(problem_of(Severity::warning, each.file,
                                       "is left out: the material has no channel for '" +
                                           std::string(each.role->key) + "'"));
        else
            diagnostics.add(
                problem_of(Severity::warning, each.file,
                           "is left out: " + each.better.filename().string() + " is used instead"));
    }
    if (!unknown.empty())
        diagnostics.add(problem_of(Severity::warning, unknown.front().parent_path(),
                                   "not recognised by name and left out: " + listed_names(unknown),
                                   example_names));
}

std::string folder_name(const fs::path& input) {
    std::error_code error;
    const fs::path whole = fs::absolute(input, error).lexically_normal();
    const fs::path folder = fs::is_directory(whole, error) ? whole : whole.parent_path();
    return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
}

}  // namespace

std::optional<TextureSet> find_textures(const std::vector<fs::path>& inputs,
                                        Diagnostics& diagnostics) {
    const auto images = images_of(inputs, diagnostics);
    if (!images) return {};
    const auto stems =
        mapped<std::string>(*images, [](const fs::path& image) { return image.stem().string(); });
    const RecognisedNames names = recognise(stems);
    std::vector<Candidate> candidates;
    for (size_t i = 0; i < images->size(); ++i)
        candidates.push_back({(*images)[i], names.roles[i], false, {}});
    TextureSet set;
    set.name = names.set.empty() ? folder_name(inputs.front()) : names.set;
    Diagnostics problems;
    for (size_t i = 0; i < channel_count; ++i)
        assign(set, candidates, static_cast<Channel>(i), problems);
    if (!problems.has_errors()) report_unused(candidates, problems);
    const bool none = std::ranges::none_of(candidates, &Candidate::is_used);
    if (none) {
        diagnostics.add(problem_of(Severity::error, inputs.front(),
                                   "no image has a name of a channel: " + listed_names(*images),
                                   example_names));
        return {};
    }
    diagnostics.append(problems);
    return problems.has_errors() ? std::nullopt : std::optional(std::move(set));
}

}  // namespace wrinkle::textures
