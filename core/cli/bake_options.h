// Command line options of `wrinkle bake` and their parsed values.
#pragma once

#include <string>
#include <vector>

#include "bake/maps.h"
#include "bake/options.h"
#include "cli/depfile.h"
#include "cli/session.h"
#include "image/image.h"
#include "image/writer.h"

namespace wrinkle::cli {

struct BakeOptions : BakeTuning {
    CommonOptions common;
    Depfile depfile;
    std::string file, mesh, output;
    std::string size = "1024", space = "tangent", maps, type, format, shard;
    std::vector<std::string> packs, merge;
    uint32_t threads = 0;
    bool gl = false, dx = false, udim = false, json = false, resume = false;
};

void declare_bake_options(CLI::App& command, BakeOptions& options);

// Requested map and its file format.
struct WantedMap {
    MapRequest request;
    std::string extension;  // ".png"
    PixelType type = PixelType::u8;
};

// Parsed values of the options.
struct BakeRequest {
    std::vector<WantedMap> maps;
    bool one_file = false;  // OUT is the file of the only map; otherwise a folder
    uint32_t width = 1024, height = 1024;
    uint32_t shard = 1, shards = 1;

    bool is_shard() const { return shards > 1; }
};

// Parses the options; returns one sentence on wrong usage, otherwise "".
std::string read_request(const BakeOptions& options, BakeRequest& request);

}  // namespace wrinkle::cli
