#include "cli/bake_options.h"

#include <cmath>
#include <filesystem>
#include <set>

#include "bake/bake.h"
#include "base/text.h"
#include "cli/arguments.h"
#include "cli/cli.h"
#include "cli/meshes.h"

namespace wrinkle::cli {
namespace {

bool parse_whole(std::string_view text, uint32_t most, uint32_t& number) {
    return parse_number(text, number) && number >= 1 && number <= most;
}

// Parses "2/8".
bool parse_shard(const std::string& text, BakeRequest& request) {
    if (text.empty()) return true;
    const auto parts = split(text, '/');
    return parts.size() == 2 && parse_whole(parts[1], 1'000'000, request.shards) &&
           parse_whole(parts[0], request.shards, request.shard);
}

PixelType usual_type(const std::string& extension) {
    if (extension == ".exr") return PixelType::half;
    return extension == ".hdr" ? PixelType::float32 : PixelType::u8;
}

// Extension of a map in a folder: --format, else .exr for floats and .png for integers.
std::string usual_extension(const BakeOptions& options, const std::string& map) {
    if (!options.format.empty()) return "." + options.format;
    const bool floats = options.type == "half" || options.type == "float";
    return floats || (options.type.empty() && !fits_integers(map)) ? ".exr" : ".png";
}

// Returns one sentence on wrong usage, otherwise "".
std::string name_maps(const BakeOptions& options, BakeRequest& request) {
    Diagnostics problems;
    const std::string names = !options.maps.empty()   ? options.maps
                              : options.packs.empty() ? "normal"
                                                      : "";
    if (!names.empty())
        for (const std::string_view name : split(names, ','))
            request.maps.push_back({{std::string(name), {}, true}, "", {}});
    for (const std::string& text : options.packs)
        if (auto pack = parse_pack(text, problems)) request.maps.push_back({*pack, "", {}});
    if (problems.has_errors())
        return problems.list()[0].message + " (" + problems.list()[0].expected + ")";
    std::set<std::string> seen;
    for (const WantedMap& map : request.maps)
        if (!seen.insert(map.request.name).second)
            return "two maps would be called '" + map.request.name +
                   "'; a pack takes a name: " + "--pack \"orm: r=occlusion g=roughness\"";
    return "";
}

void choose_files(const BakeOptions& options, BakeRequest& request) {
    request.one_file = request.maps.size() == 1 && !request.is_shard();
    const std::string own = std::filesystem::path(options.output).extension().string();
    for (WantedMap& map : request.maps) {
        map.extension = request.one_file ? own : usual_extension(options, map.request.name);
        map.type = pixel_type_named(options.type).value_or(usual_type(map.extension));
        map.request.integers = is_integer(map.type);
    }
}

std::string conflict(const BakeOptions& options, const BakeRequest& request) {
    if (options.gl && options.dx) return "--gl and --dx are two ways of green; choose one";
    if (options.file.empty()) return "bake needs a graph: FILE, or --merge with folders of shards";
    if (options.mesh.empty()) return "bake needs a mesh: --mesh " + mesh_help();
    if (!(options.scale > 0) || !std::isfinite(options.scale))
        return "--scale is a number greater than 0";
    if (options.tile % 16 != 0) return "--tile is a multiple of 16";
    if (options.file == "-" && (request.is_shard() || options.resume))
        return "--shard and --resume need a graph in a file, to know it again";
    for (const WantedMap& map : request.maps)
        if (map.request.name.empty() || map.request.name.find('/') != map.request.name.npos)
            return "'" + map.request.name + "' cannot be the name of a map's file";
    if (!options.depfile.is_complete()) return "-MF, -MT and -MP go with -MD";
    if (request.one_file && !options.format.empty())
        return "--format is for maps in a folder; OUT itself says what one map is written as";
    return "";
}

}  // namespace

std::string read_request(const BakeOptions& options, BakeRequest& request) {
    if (!parse_size(options.size, max_baked_side, request.width, request.height))
        return "--size " + options.size +
               " is not a size such as 1024 or 2048x1024, at most 65536 a side";
    if (!parse_shard(options.shard, request))
        return "--shard " + options.shard + " is not I/N such as 2/8, the second of eight";
    if (std::string why = name_maps(options, request); !why.empty()) return why;
    choose_files(options, request);
    return conflict(options, request);
}

void declare_bake_maps(CLI::App& sub, BakeOptions& c) {
    sub.add_option("--map", c.maps, bake_words::map)->type_name("LIST");
    sub.add_option("--pack", c.packs, bake_words::pack)
        ->type_name("CHANNELS")
        ->allow_extra_args(false)
        ->take_all();
    add_choice(sub, "--space", c.space, {"tangent", "object", "world"}, bake_words::space);
    sub.add_flag("--gl", c.gl, bake_words::gl);
    sub.add_flag("--dx", c.dx, bake_words::dx);
    sub.add_option("--scale", c.scale, bake_words::scale)->type_name("S")->capture_default_str();
}

void declare_bake_layout(CLI::App& sub, BakeOptions& c) {
    sub.add_option("--size", c.size, "Size of a map in texels: N or WxH")
        ->type_name("N")
        ->capture_default_str();
    sub.add_flag("--udim", c.udim, bake_words::udim);
    sub.add_option("--samples", c.samples, bake_words::samples)
        ->check(CLI::IsMember(
            std::vector<uint32_t>(bake_sample_counts.begin(), bake_sample_counts.end())))
        ->capture_default_str();
    sub.add_option("--dilate", c.dilate, bake_words::dilate)
        ->type_name("N")
        ->check(CLI::Range(uint32_t{0}, max_dilation))
        ->capture_default_str();
}

void declare_bake_options(CLI::App& sub, BakeOptions& c) {
    sub.add_option("FILE", c.file, "A graph; - reads standard input");
    declare_mesh(sub, c.mesh, "Mesh: ");
    sub.add_option("-o", c.output, "The map's file; of several, their folder")
        ->type_name("OUT")
        ->required();
    declare_bake_maps(sub, c);
    declare_bake_layout(sub, c);
    add_choice(sub, "--type", c.type, pixel_type_names, bake_words::type);
    add_choice(sub, "--format", c.format, bake_formats,
               "Format of maps in a folder; default: png, or exr for floats");
    sub.add_option("--compression", c.compression, bake_words::compression)->type_name("NAME");
    sub.add_option("--tile", c.tile, bake_words::tile)
        ->type_name("N")
        ->check(CLI::Range(uint32_t{0}, max_bake_tile))
        ->capture_default_str();
    sub.add_option("-j", c.threads, "Threads; 0 is one for each core")
        ->type_name("N")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    sub.add_option("--shard", c.shard,
                   "Bakes the I-th of N equal parts of the work into the folder OUT, for --merge")
        ->type_name("I/N");
    sub.add_option("--merge", c.merge, "Joins the folders of all shards instead of baking")
        ->type_name("DIR");
    sub.add_flag("--resume", c.resume, "Continues a bake that was stopped");
    sub.add_flag("--json", c.json, "Progress and the files written, a line of JSON each");
    declare_depfile(sub, c.depfile);
    declare_common(sub, c.common);
}

}  // namespace wrinkle::cli
