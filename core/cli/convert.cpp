// wrinkle convert IN -o OUT --to KIND: converts a bump map to another kind.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

#include "base/file.h"
#include "base/mapped.h"
#include "cli/arguments.h"
#include "cli/cli.h"
#include "cli/output.h"
#include "image/load.h"
#include "maps/convert.h"
#include "maps/lint.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

struct KindName {
    const char* name;
    maps::Kind kind;
    maps::Green green = maps::Green::gl;
};
constexpr KindName target_kinds[] = {{"derivative", maps::Kind::derivative},
                                     {"normal", maps::Kind::normal},
                                     {"slopes", maps::Kind::slopes},
                                     {"moments", maps::Kind::moments},
                                     {"height", maps::Kind::height}};
constexpr KindName source_kinds[] = {{"height", maps::Kind::height},
                                     {"normal_gl", maps::Kind::normal},
                                     {"normal_dx", maps::Kind::normal, maps::Green::dx},
                                     {"derivative", maps::Kind::derivative}};

std::vector<std::string> names_in(std::span<const KindName> table) {
    return mapped<std::string>(table, &KindName::name);
}

// Returns the row of a name; nullptr if there is none.
const KindName* named(std::span<const KindName> table, std::string_view name) {
    const auto found = std::ranges::find(table, name, &KindName::name);
    return found == table.end() ? nullptr : &*found;
}

// Detects the kind of an image and reports it as a warning. Returns nullptr and reports an error
// that suggests --from if the image matches none of them.
const KindName* source_found(const Image& image, const std::string& file,
                             Diagnostics& diagnostics) {
    const maps::MapClass found = maps::examine(image, Wrap::clamp).map_class;
    const std::string description(description_of(found));
    const KindName* kind = named(source_kinds, name_of(found));
    diagnostics.add(kind ? file_problem(Severity::warning, RuleId::image_meaning, file,
                                        "is taken for " + description, "--from says what it is")
                         : file_problem(Severity::error, RuleId::image_meaning, file,
                                        "looks like " + description,
                                        "--from height, normal_gl, normal_dx or derivative"));
    return kind;
}

struct ConvertCommand {
    maps::Source source;
    maps::Target target;
    std::string input, output, to, from, type, green = "gl", wrap = "clamp", per = "texel",
                                               from_per = "texel", diagnostics = "text";
    std::vector<float> texel = {1};

    int run() {
        if (const std::string why = wrong_usage(); !why.empty()) return fail(exit_usage, why);
        Diagnostics problems;
        const auto image = load_image(input, problems);
        const KindName* kind = nullptr;
        if (image)
            kind = from.empty() ? source_found(*image, input, problems) : named(source_kinds, from);
        const int code = report(problems, problems.has_errors() ? diagnostics : "text");
        if (code != exit_success) return code;
        source.image = &*image;
        source.kind = kind->kind;
        source.green = kind->green;
        complete_options();
        maps::read_stored_scale(input, source);
        Diagnostics environment;
        if (maps::convert(source, target, output, environment)) return exit_success;
        report(environment, diagnostics);
        return exit_environment;
    }

    std::string wrong_usage() const {
        if (input == "-" || output == "-") return "convert reads and writes files, no streams";
        const std::string read[] = {input}, made[] = {output};
        if (const std::string why = overwrite_fault(made, read); !why.empty()) return why;
        if (!std::isfinite(source.factor)) return "--scale is not a number";
        if (texel.size() > 2) return "--texel takes one size or two";
        for (const float size : texel)
            if (!(size > 0)) return "--texel takes sizes above 0";
        if (target.tile % 16 != 0)
            return "--tile " + std::to_string(target.tile) + " is not a multiple of 16";
        return {};
    }

    void complete_options() {
        source.wrap = *wrap_named(wrap);
        source.per = from_per == "uv" ? maps::Per::uv : maps::Per::texel;
        source.texel_width = texel.front();
        source.texel_height = texel.back();
        target.kind = named(target_kinds, to)->kind;
        target.green = green == "dx" ? maps::Green::dx : maps::Green::gl;
        target.per = per == "uv" ? maps::Per::uv : maps::Per::texel;
        target.type = *pixel_type_named(type.empty() ? usual_type() : type);
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
    add_choice(sub, "--to", c.to, names_in(target_kinds), "Kind of map to write")->required();
    add_choice(sub, "--from", c.from, names_in(source_kinds),
               "Kind of IN; default: the kind that it looks like, which is printed");
    add_choice(sub, "--type", c.type, pixel_type_names,
               "Type of its values; default: half, or a type of the format");
    sub.add_option("--compression", c.target.compression,
                   "exr: none rle zip zips piz; tif: none lzw zip; default: zip")
        ->type_name("NAME");
    add_choice(sub, "--wrap", c.wrap, {"clamp", "repeat"}, "Values beyond the border");
    sub.add_flag("--mips", c.target.mips, "All levels, means of slopes and not of normals (.exr)");
    sub.add_option("--tile", c.target.tile,
                   "Tiles of this side (.exr, .tif); default: none, 64 with mips")
        ->type_name("N");
    sub.add_option("--scale", c.source.factor, "The bump is so many times as high")
        ->capture_default_str();
    sub.add_option("--texel", c.texel,
                   "Width, or width and height, of a texel in units of the scaled height")
        ->delimiter(',')
        ->type_name("W[,H]");
    add_choice(sub, "--green", c.green, {"gl", "dx"},
               "Where green of a normal map points: up or down");
    add_choice(sub, "--per", c.per, {"texel", "uv"},
               "Slopes written are per texel or per unit of uv");
    add_choice(sub, "--from-per", c.from_per, {"texel", "uv"},
               "And those of a derivative map that is read");
    declare_diagnostics(sub, c.diagnostics);
}

}  // namespace

void declare_convert(CLI::App& app, Run& run) {
    auto [sub, c] =
        add_command<ConvertCommand>(app, run, "convert", "One map of a bump made from another");
    declare_options(sub, c);
}

}  // namespace wrinkle::cli
