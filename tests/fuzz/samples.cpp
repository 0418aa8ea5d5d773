#include "fuzz/samples.h"

#include <random>

#include "cli/bake_header.h"
#include "fuzz/compiled.h"
#include "image/support.h"
#include "mesh/files.h"
#include "registry/listing.h"
#include "support/samples.h"

namespace wrinkle::fuzz {

std::vector<std::string> graph_samples() {
    std::vector<std::string> samples;
    for (const auto& path : test::sample_graphs())
        samples.push_back(test::bytes_of(path));
    samples.push_back(R"({"wrinkle": 1, "inputs": {
  "wear": {"type": "float", "renamed": ["age", "years"]}, "rust": {"type": "float"}},
  "presets": {"Old": {"age": 0.5}, "New": {"wear": 0, "rust": 1}},
  "nodes": {"n": {"type": "add", "in": {"a": {"from": "input.wear"}, "b": {"from": "input.rust"}}}},
  "outputs": {"roughness": {"from": "n.result"}}})");
    return samples;
}

std::vector<std::string> mesh_samples() {
    test::GltfText strip = test::square();
    strip.primitive = R"(, "mode": 5)";
    test::GltfText indexed = test::square();
    indexed.primitive =
        R"(, "indices": )" + std::to_string(indexed.add_indices({0, 1, 2, 0, 2, 3}));
    return {test::square().text(),
            strip.text(),
            indexed.text(),
            indexed.glb(),
            "v 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
            "f 1/1/1 2/2/1 3/3/1 4/4/1\n",
            "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng b\nf 1 3 2\nf 1 2 4\nf -4 -1 -2\ns 1\n"
            "f 2//\\\n 3 4\n"};
}

std::vector<std::string> image_samples() {
    const test::TemporaryFolder folder;
    std::vector<std::string> samples;
    const auto add = [&](const char* name, uint32_t channels, PixelType type,
                         const char* compression) {
        Diagnostics diagnostics;
        const Image image = test::sample_image(13, 9, channels);
        const WriterOptions options{.type = type, .compression = compression};
        EXPECT_TRUE(save_image(image, folder.path() / name, options, diagnostics))
            << to_text(diagnostics);
        samples.push_back(test::bytes_of(folder.path() / name));
    };
    for (const uint32_t channels : {1, 3, 4})
        for (const PixelType type : {PixelType::u8, PixelType::u16})
            add("a.png", channels, type, "");
    add("a.jpg", 1, PixelType::u8, "");
    add("a.jpg", 3, PixelType::u8, "");
    for (const char* compression : {"none", "lzw", "zip"})
        for (const PixelType type : {PixelType::u8, PixelType::half, PixelType::float32})
            add("a.tif", 3, type, compression);
    for (const char* compression : {"none", "rle", "zip", "zips", "piz"})
        for (const PixelType type : {PixelType::half, PixelType::float32})
            add("a.exr", 4, type, compression);
    add("a.hdr", 3, PixelType::float32, "");
    samples.push_back("Pf\n3 2\n-1.0\n" + std::string(24, '?'));
    samples.push_back("P6\n3 2\n255\n" + std::string(18, 'x'));
    samples.push_back("P2\n3 2\n255\n0 1 2 3 4 5\n");
    samples.push_back(test::png_file(3, 2, 8, 2, std::string(20, '\0')));
    return samples;
}

std::vector<std::string> descriptor_samples() {
    std::vector<std::string> samples(50, std::string(400, '\0'));
    std::mt19937 random(1);
    for (std::string& sample : samples)
        for (char& byte : sample)
            byte = static_cast<char>(random() % 256);
    samples.emplace_back();
    return samples;
}

std::vector<std::string> listing_samples() {
    std::vector<std::string> samples;
    const Registry registry = with_built_in_nodes();
    for (const NodeType& type : registry.list())
        samples.push_back(to_json(PluginListing{"fuzz", "1", "0", {type}}));
    return samples;
}

std::vector<std::string> bake_part_samples() {
    cli::PartHeader one;
    one.identity = "identity";
    one.maps.push_back({"normal", ".exr", {}});
    one.maps[0].writer = {.width = 64, .height = 32, .channels = {"R", "G", "B"}};
    one.maps[0].writer.numbers.push_back({"height_scale", 2});
    one.sets = {""};
    one.last = one.bands();
    cli::PartHeader two = one;
    two.maps.push_back({"height", ".png", {}});
    two.maps[1].writer = {.width = 64, .height = 32, .channels = {"Y"}, .type = PixelType::u16};
    two.sets = {".1001", ".1002", ".1003"};
    two.shards = two.shard = 2;
    two.first = two.bands();
    two.last = two.done = 3 * uint64_t{two.bands()};
    two.sums.assign(4, "0123456789abcdef");
    two.found.clamped.push_back({3, -1, 2});
    std::vector<std::string> samples;
    for (const cli::PartHeader& header : {one, two}) {
        const std::string text = header_json(header);
        samples.push_back(text.substr(0, text.rfind(",\n")));
    }
    return samples;
}

}  // namespace wrinkle::fuzz
