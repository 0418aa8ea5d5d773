// Image files of an exported MaterialX document: copies of those that the graph reads, and maps.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "base/diagnostics.h"
#include "export/baked_material.h"

namespace wrinkle {

class MtlxTextures {
public:
    MtlxTextures(const std::filesystem::path& folder, Diagnostics& diagnostics)
        : folder_(folder), diagnostics_(diagnostics) {}

    // Copies the file once; returns its name, relative to the document. Without a copy an error is
    // appended.
    std::string copy(const std::string& file);

    struct Map {
        std::string file;  // relative to the document
        bool is_srgb = false;
    };
    // Saves an output: in 16 bits if its values are from 0 to 1, colors as sRGB; else in linear
    // floats.
    Map save(const BakedMaterial& material, const std::string& name, const BakedOutput& output,
             bool is_color);
    // Saves a normal, 0.5 + 0.5 m, in 16 bits.
    Map save_normal(const BakedMaterial& material, const std::string& name,
                    const BakedOutput& output);

private:
    std::string free_file(const std::string& stem, const std::string& extension);
    std::string write(const Image& image, const std::string& stem, bool is_integer);

    const std::filesystem::path& folder_;
    Diagnostics& diagnostics_;
    std::map<std::string, std::string> copies_;  // by file
    std::set<std::string> files_;
};

}  // namespace wrinkle
