// examine_textures(): facts that the names of a texture set do not state.
#include <algorithm>
#include <set>

#include "import/relief.h"
#include "import/texture_set.h"
#include "maps/lint.h"

namespace wrinkle::textures {
namespace fs = std::filesystem;
namespace {

constexpr const char* green_hint = "--green gl (up) or dx (down) states it";

class Examiner {
public:
    Examiner(TextureSet& set, const ExamineOptions& options, Diagnostics& diagnostics)
        : set_(set), options_(options), diagnostics_(diagnostics) {}

    bool run() {
        read_headers();
        if (diagnostics_.has_errors()) return false;
        drop_absent_components();
        if (diagnostics_.has_errors()) return false;
        if (set_.find(Channel::normal)) examine_normal();
        if (!has_failed()) find_opacity();
        if (!has_failed()) fit_relief();
        return !has_failed();
    }

private:
    bool has_failed() const { return diagnostics_.has_errors() || is_stopped(); }
    bool is_stopped() const { return options_.stopped && options_.stopped(); }

    void report(Severity severity, const fs::path& file, std::string message,
                std::string expected = {}) {
        diagnostics_.add(file_problem(severity, RuleId::image_meaning, file.string(),
                                      std::move(message), std::move(expected)));
    }

    void read_headers() {
        const ImageLimits limits = image_limits_from_environment(diagnostics_);
        std::set<fs::path> failed;  // a packed image is reported once
        for (auto& texture : set_.channels) {
            if (!texture || failed.contains(texture->file)) continue;
            if (const auto info = read_image_info(texture->file, limits, diagnostics_))
                texture->info = *info;
            else
                failed.insert(texture->file);
        }
    }

    static bool has_component(const ImageInfo& info, Component component) {
        const uint32_t colors = info.channels - (info.has_alpha ? 1 : 0);
        if (component == Component::alpha) return info.has_alpha;
        if (component == Component::green) return colors >= 2;
        return component != Component::blue || colors >= 3;
    }

    void drop_absent_components() {
        fs::path last;
        for (auto& texture : set_.channels) {
            if (!texture || has_component(texture->info, texture->source.component)) continue;
            report(Severity::warning, texture->file,
                   "has no " + std::string(name_of(texture->source.component)) +
                       ", which by its name holds the channel " +
                       std::string(name_of(texture->source.channel)) + ": it is left out");
            last = texture->file;
            texture.reset();
        }
        if (std::ranges::none_of(set_.channels, [](const auto& each) { return each.has_value(); }))
            report(Severity::error, last, "holds none of the channels of its name",
                   "the set has no other image");
    }

    void examine_normal() {
        const Texture texture = *set_.find(Channel::normal);
        const auto found =
            maps::examine(texture.file, Wrap::repeat, diagnostics_, options_.stopped);
        if (!found) return;
        const maps::MapClass seen = found->verdict.map_class;
        if (seen == maps::MapClass::two_channel) return use_two_channels(texture);
        const bool is_normal = seen == maps::MapClass::normal ||
                               seen == maps::MapClass::normal_gl ||
                               seen == maps::MapClass::normal_dx;
        if (!is_normal)
            report(Severity::warning, texture.file,
                   "is read as a tangent-space normal map, by its name; its values look like " +
                       std::string(description_of(seen)));
        const bool is_down =
            options_.green ? *options_.green == maps::Green::dx : is_green_down(texture, seen);
        set_.normal_encoding = is_down ? Encoding::normal_dx : Encoding::normal_gl;
    }

    bool is_green_down(const Texture& texture, maps::MapClass seen) {
        const NamedGreen named = texture.role->green;
        const bool seen_down = seen == maps::MapClass::normal_dx;
        const bool is_seen = seen_down || seen == maps::MapClass::normal_gl;
        if (named != NamedGreen::unknown) {
            const bool named_down = named == NamedGreen::dx;
            if (is_seen && named_down != seen_down)
                report(Severity::warning, texture.file,
                       std::string("is read with green ") + (named_down ? "down" : "up") +
                           ", by its name; its slopes have green " + (seen_down ? "down" : "up"),
                       green_hint);
            return named_down;
        }
        if (!is_seen)
            report(Severity::warning, texture.file,
                   "is read with green up: neither its name nor its slopes state the direction",
                   green_hint);
        else if (seen_down)
            report(Severity::warning, texture.file, "is read with green down, by its slopes",
                   green_hint);
        return seen_down;
    }

    // No encoding has two channels and green down.
    void use_two_channels(const Texture& texture) {
        set_.normal_encoding = Encoding::normal_rg;
        const bool is_down = options_.green ? *options_.green == maps::Green::dx
                                            : texture.role->green == NamedGreen::dx;
        if (is_down)
            report(Severity::error, texture.file,
                   "holds a normal in two channels with green down, which no node reads",
                   "wrinkle convert --from normal_dx --to normal makes one that can be read");
    }

    void find_opacity() {
        const Texture* color = set_.find(Channel::color);
        if (!color || !color->info.has_alpha || set_.find(Channel::opacity)) return;
        bool is_transparent = false;
        const auto take = [&](const ImageInfo& info, const float* row) {
            for (uint32_t x = 0; x < info.width && !is_transparent; ++x)
                is_transparent = row[size_t{x} * info.channels + info.channels - 1] < 1;
            return !is_transparent && !is_stopped();
        };
        read_image_rows(color->file, take, diagnostics_);
        if (!is_transparent) return;
        Texture opacity = *color;
        opacity.source = {Channel::opacity, Component::alpha};
        set_.channels[static_cast<size_t>(Channel::opacity)] = opacity;
    }

    void fit_relief() {
        const Texture* height = set_.find(Channel::height);
        const Texture* normal = set_.find(Channel::normal);
        if (!height || !normal || height->source.component != Component::red) return;
        const ImageInfo &a = height->info, &b = normal->info;
        if (a.width != b.width || a.height != b.height || b.channels < 3) return;
        const bool is_down = set_.normal_encoding == Encoding::normal_dx;
        set_.relief =
            fitted_relief(height->file, normal->file, is_down ? maps::Green::dx : maps::Green::gl,
                          diagnostics_, options_.stopped);
    }

    TextureSet& set_;
    const ExamineOptions& options_;
    Diagnostics& diagnostics_;
};

}  // namespace

bool examine_textures(TextureSet& set, const ExamineOptions& options, Diagnostics& diagnostics) {
    Diagnostics problems;
    const bool is_good = Examiner(set, options, problems).run();
    diagnostics.append(problems);
    return is_good;
}

}  // namespace wrinkle::textures
