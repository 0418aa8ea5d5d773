// wrinkle convert IN -o OUT --to KIND: converts a bump map to another kind.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/overwrite.h"
#include "base/text.h"
#include "cli/cli.h"
#include "cli/map_kind.h"
#include "cli/output.h"
#include "image/load.h"
#include "maps/convert.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

PixelType type_named(const std::string& name) {
    for (const PixelType type : {PixelType::u8, PixelType::u16, PixelType::half})
        if (name == name_of(type)) return type;
    return PixelType::float32;
}

struct ConvertCommand {
    std::string input, output, to, from, type, compression,
        green = "gl", wrap = "clamp", per = "texel", from_per = "texel", diagnostics = "text";
    float scale = 1;
    std::vector<float> texel = {1};
    uint32_t tile = 0;
    bool mips = false;

    int run() const {
        const std::string sentence = wrong_usage();
        if (!sentence.empty()) {
            print_error(sentence);
            return exit_usage;
        }
        Diagnostics problems;
        const auto image = load_image(input, problems);
        maps::Source source;
        if (image && find_kind(*image, source, problems)) describe(source);
        const int code = report(problems, problems.has_errors() ? diagnostics : quiet_text());
        if (code != exit_success) return code;
        source.image = &*image;
        maps::read_stored_scale(input, source);
        Diagnostics environment;
        if (maps::convert(source, target(), output, environment)) return exit_success;
        report(environment, diagnostics);
        return exit_environment;
    }

private:
    // Diagnostics format if there are only warnings: never JSON.
    std::string quiet_text() const { return diagnostics == "json" ? "text" : diagnostics; }

    std::string wrong_usage() const {
        if (input == "-" || output == "-") return "convert reads and writes files, no streams";
        const std::string read[] = {input}, made[] = {output};
        if (const std::string why = overwrite_fault(made, read); !why.empty()) return why;
        if (!std::isfinite(scale)) return "--scale is no number";
        if (texel.size() > 2) return "--texel takes one size or two";
        for (const float size : texel)
            if (!(size > 0)) return "--texel takes sizes above 0";
        if (tile % 16 != 0) return "--tile " + std::to_string(tile) + " is no multiple of 16";
        return {};
    }

    // Sets `source` from --from, else detects it and reports a warning; returns false on failure.
    bool find_kind(const Image& image, maps::Source& source, Diagnostics& problems) const {
        if (!from.empty()) {
            source = source_named(from);
            return true;
        }
        const auto found = source_found(image, input, problems);
        if (found) source = *found;
        return found.has_value();
    }

    void describe(maps::Source& source) const {
        source.wrap = *wrap_named(wrap);
        source.factor = scale;
        source.per = from_per == "uv" ? maps::Per::uv : maps::Per::texel;
        source.texel_width = texel.front();
        source.texel_height = texel.back();
    }

    maps::Target target() const {
        maps::Target target;
        target.kind = kind_named(to);
        target.green = green == "dx" ? maps::Green::dx : maps::Green::gl;
        target.per = per == "uv" ? maps::Per::uv : maps::Per::texel;
        target.type = type_named(type.empty() ? usual_type() : type);
        target.compression = compression;
        target.tile = tile;
        target.mips = mips;
        return target;
    }

    // Default pixel type: half if the format supports it, else the most precise supported type.
    std::string usual_type() const {
        const std::string extension = fs::path(output).extension().string();
        if (extension == ".png") return "u16";
        if (extension == ".jpg" || extension == ".jpeg") return "u8";
        return extension == ".hdr" ? "float" : "half";
    }
};

void declare_options(CLI::App& sub, ConvertCommand& c) {
    sub.add_option("IN", c.input, "A map: PNG, JPEG, TIFF, OpenEXR, HDR, PFM, PNM")->required();
    sub.add_option("-o", c.output, "The map to write: .exr, .tif, .png, .hdr or .jpg")
        ->type_name("OUT")
        ->required();
    sub.add_option("--to", c.to, "What it is to be")
        ->check(CLI::IsMember(kind_names()))
        ->required();
    sub.add_option("--from", c.from, "What IN is; default: what it looks like, which is said")
        ->check(CLI::IsMember(source_names()));
    sub.add_option("--type", c.type, "Of its values; default: half, or what the format has")
        ->check(CLI::IsMember({"u8", "u16", "half", "float"}));
    sub.add_option("--compression", c.compression,
                   "exr: none rle zip zips piz; tif: none lzw zip; default: zip")
        ->type_name("NAME");
    sub.add_option("--wrap", c.wrap, "What lies beyond the border")
        ->check(CLI::IsMember({"clamp", "repeat"}))
        ->capture_default_str();
    sub.add_flag("--mips", c.mips, "All levels, means of slopes and not of normals (.exr)");
    sub.add_option("--tile", c.tile, "Tiles of this side (.exr, .tif); default: none, 64 with mips")
        ->type_name("N");
    sub.add_option("--scale", c.scale, "The bump is so many times as high")->capture_default_str();
    sub.add_option("--texel", c.texel,
                   "Width, or width and height, of a texel in units of the scaled height")
        ->delimiter(',')
        ->type_name("W[,H]");
    sub.add_option("--green", c.green, "Where green of a normal map points: up or down")
        ->check(CLI::IsMember({"gl", "dx"}))
        ->capture_default_str();
    sub.add_option("--per", c.per, "Slopes written are per texel or per unit of uv")
        ->check(CLI::IsMember({"texel", "uv"}))
        ->capture_default_str();
    sub.add_option("--from-per", c.from_per, "And those of a derivative map that is read")
        ->check(CLI::IsMember({"texel", "uv"}))
        ->capture_default_str();
    sub.add_option("--diagnostics", c.diagnostics, "How problems are printed")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
}

}  // namespace

void declare_convert(CLI::App& app, Run& run) {
    auto command = std::make_shared<ConvertCommand>();
    CLI::App& sub = *app.add_subcommand("convert", "One map of a bump made from another");
    declare_options(sub, *command);
    sub.callback([command, &run] { run = [command] { return command->run(); }; });
}

}  // namespace wrinkle::cli
